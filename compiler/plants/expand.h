// From trees and woods to placed trees.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/geometry/placement.h"
#include "compiler/ground/carving.h"
#include "compiler/ground/surface_map.h"
#include "compiler/plants/recipe.h"

namespace citykiln::plants {

/// A trunk's least distance to roads, paths, rails, water and buildings, and to what else lies on top of land (priority
/// 50 and more).
inline constexpr double kTrunkClearance_m = 1.25;

/// Where plants stand, by shape; scale is the height in metres.
using Placed = std::map<Prototype, std::vector<Placement>>;

/// How far outside the box surfaces must be known for a wood's trees to be decided (a named reach, DESIGN section 8.4).
inline constexpr double kReach_m = 48;

/// The trees whose trunks stand in the half-open box.
///
/// @param surfaces  Covers the box widened by kReach_m.
/// @param ground    Carved in the box; its terrain covers as much as the surfaces. Trees of a wood keep apart on the
///                  terrain, and stand on the carved ground.
/// Guarantees: no trunk of a wood within kTrunkClearance_m of a road, building or water; trunks of one wood at least
/// spacing_m apart on the ground; a tree depends on nothing beyond kReach_m. Single trees on a building, road or water
/// are dropped, diagnosed kTreeOnRoad. Method: blue_noise.h; what stays undecided is diagnosed kTreesUndecided. Ledger
/// "bake/tree" for single trees.
Placed expand(std::span<const Tree> trees, std::span<const Wood> woods, const ground::SurfaceMap& surfaces,
              const ground::Carving& ground, const Box2& box, std::uint64_t seed, Report& report);

/// The tallest that a tree can be drawn, metres.
inline constexpr double kTallestTree_m = 40;

}  // namespace citykiln::plants
