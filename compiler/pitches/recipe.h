// Recipes of sports pitches. A pitch is a rectangle with the lines of one sport, such as a soccer pitch or a tennis
// court. A sports area (map::SportsArea) has one, or several side by side.
#pragma once

#include <cstdint>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/vec.h"

namespace citykiln::pitches {

/// Rows of pitches.inc. Their order is part of the manifest's format: add at the end.
enum class PitchKind : std::uint8_t {
#define PITCH(name, sports, length, width, space, line, lines, equipment) name,
#include "compiler/pitches/pitches.inc"
#undef PITCH
  kCount
};

/// A rectangle with the lines of a sport.
struct Pitch {
  ObjectId id;  ///< The area's; several pitches of an area have the same id.
  PitchKind kind{};
  Vec2 from, to;       ///< The middles of its two ends, plane metres, snapped; different.
  double width_m = 1;  ///< Between its outer edges; a multiple of 2^-10, > 0.
  bool operator==(const Pitch&) const = default;
};

}  // namespace citykiln::pitches
