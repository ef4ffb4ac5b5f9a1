// Random numbers of a step: pure functions of (seed, plant, step, position in the string).
#pragma once

#include <cstdint>

#include "compiler/contract/draw.h"

namespace citykiln::lsystems {

/// Random draws that one production may use; each position in the string has its own.
inline constexpr std::uint32_t kDrawsPerModule = 16;

/// The random numbers of one module.
struct RandomSource {
  const Draw* draw = nullptr;  ///< The step's.
  std::uint32_t place = 0;     ///< Position of the module in the string that is rewritten.
  std::uint32_t drawn = 0;

  /// Uniform in [0, 1).
  double next() { return draw->unit(place * kDrawsPerModule + drawn++); }
};

}  // namespace citykiln::lsystems
