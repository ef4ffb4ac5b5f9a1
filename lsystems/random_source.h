// Chance of one step of a derivation: a pure function of (seed, plant, step, place in the string).
#pragma once

#include <cstdint>

#include "compiler/contract/draw.h"

namespace citykiln::lsystems {

/// How many dice one production may throw: those of a module's place are apart from its neighbours'.
inline constexpr std::uint32_t kDrawsPerModule = 16;

/// Those of one module.
struct RandomSource {
  const Draw* draw = nullptr;  ///< Of the step.
  std::uint32_t place = 0;     ///< Of the module in the string that is rewritten.
  std::uint32_t thrown = 0;

  /// Uniform in [0, 1).
  double next() { return draw->unit(place * kDrawsPerModule + thrown++); }
};

}  // namespace citykiln::lsystems
