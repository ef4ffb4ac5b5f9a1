// Who passes over whom without meeting: what crosses in plan, and what runs above another within its width.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/ground/profiles/profile_graph.h"
#include "compiler/ground/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// LandCoverPolygon to surface: a clear height of 4.5 m and a deck of 1 m over roads; over rails 5.5 m (the wires, EBO)
/// and the deck; over paths 2.5 m and the deck. A path's deck is half a metre thinner.
inline constexpr double kClearanceOverRoad_m = 5.5, kClearanceOverRail_m = 6.5, kClearanceOverPath_m = 3.5,
                        kThinDeck_m = 0.5;
/// Over rivers and standing water; over what is narrower than kRiver_m in proportion, but kClearanceOverDitch_m at
/// least: a culvert is no bridge to climb.
inline constexpr double kClearanceOverWater_m = 2, kRiver_m = 8, kClearanceOverDitch_m = 0.5;

/// A clearance that lacks less is one that a deck may be thinner by.
inline constexpr double kShortfallMargin_m = 0.25;

/// What should lie from surface to surface where one line passes over another, or over water of some width.
double wanted_clearance_m(map::LandCoverClass upper, map::LandCoverClass lower);
double wanted_clearance_over_water_m(double width_m);

/// Lines that are joined within this along the network are not apart yet: an abutment, a fork. Paths are so much
/// steeper that a third of it does, rails so much flatter that it takes twice as much.
inline constexpr double kJoined_m = 96, kPathJoins = 3, kRailJoins = 0.5;

/// A path this near to a tunnel's mouth passes before it.
inline constexpr double kMouth_m = 3;

/// One place where one line should clear another.
struct Crossing {
  std::uint32_t upper = 0, lower = kNone;  ///< Ways; kNone: what is not in the graph, at the height below.
  double upper_at_m = 0, lower_at_m = 0;
  double lower_z_m = 0, upper_z_m = 0;
  double wanted_m = 0;      ///< From surface to surface.
  double half_width_m = 0;  ///< Of the lower one.
};

/// What lies below bridges without being in the graph.
struct BelowBridges {
  std::span<const roads::Strip> streams;
  std::span<const LandCoverPolygon> waters;
  std::function<double(Vec2)> ground_m;  ///< Where paths lie that follow the ground as it is.
};

/// Bridges pass over the ground, the ground over tunnels, paths that follow it too; of two bridges or tunnels the one
/// of higher layer=* is above (a bridge without counts as 1, a tunnel as -1); of equal layer nobody knows. Corridors in
/// buildings (paths in "tunnels" of layer 0 or above) pass nothing. What only runs along within another's width does
/// not pass it within kJoined_m of an end on the ground that lies on that other: there it comes down beside it. Sorted
/// by upper, then by place. O(n log n) about what leaves the ground.
std::vector<Crossing> find_crossings(const ProfileGraph& graph, const map::Features& features,
                                     const BelowBridges& below);

/// How much is missing, of heights by node; not above zero where there is room.
double clearance_shortfall_m(const ProfileGraph& graph, const Crossing& crossing, std::span<const double> z_m);

}  // namespace citykiln::ground
