// The random numbers of a step: pure functions of (seed, plant, step, position in the string).
#pragma once

#include <cstdint>

#include "compiler/contract/random_sequence.h"

namespace citykiln::lsystems {

/// The random numbers of a module. The first one chooses between rules, so a production may draw one fewer; an axiom
/// may draw all those of position 0. nran() takes two.
inline constexpr std::uint32_t kDrawsPerModule = 16;

/// The random numbers of one module.
struct RandomSource {
  const RandomSequence* draw = nullptr;  ///< The draws of the step.
  std::uint32_t place = 0;               ///< The module's position in the string that is rewritten.
  std::uint32_t drawn = 0;

  /// Returns a number uniform in [0, 1).
  double next() { return draw->unit(place * kDrawsPerModule + drawn++); }
};

}  // namespace citykiln::lsystems
