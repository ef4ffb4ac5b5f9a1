// Arms as straight lines, close to their junction: what cuts and corners are computed from.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compiler/roads/network.h"

namespace citykiln::roads {

struct ArmLine {
  Vec2 from, along;                ///< `along` is a unit vector.
  double left_m = 0, right_m = 0;  ///< To the kerbs, seen along the arm.
};

/// The line from an arm's place to where it is 8 m on: a misleading first metre does not turn it.
ArmLine line_of(std::span<const Road> roads, const Arm& arm);

/// Indices of arms, counter-clockwise about a centre by where they are 8 m on.
std::vector<std::uint32_t> counter_clockwise(std::span<const ArmLine> lines, Vec2 centre);

/// For each arm the next one counter-clockwise of those that leave the same place; itself where it is alone there.
///
/// @param lines  Place by place.
std::vector<std::uint32_t> next_at_place(std::span<const ArmLine> lines);

/// Where the left edge of `arm` meets the right edge of the next arm counter-clockwise.
struct Corner {
  double along_arm_m = 0, along_next_m = 0;  ///< From each arm's place; not below 0.
  double sine = 1, cosine = 0;               ///< Of the angle between the arms.
};

/// Nothing where the arms lie more than some 160 degrees apart: no corner to round, no reason to cut.
std::optional<Corner> corner_between(const ArmLine& arm, const ArmLine& next);

}  // namespace citykiln::roads
