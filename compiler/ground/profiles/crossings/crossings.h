// Finds crossings: places where one line passes over another without a junction. It crosses the other line in plan, or
// runs above it within its width.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/ground/profiles/graph/profile_graph.h"
#include "compiler/ground/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// Clearances from surface to surface, including a deck of 1 m: 4.5 m clear over roads, trams and farm tracks, 5.5 m
/// over railways and funiculars (overhead wires, EBO), 2.5 m over paths. Over all of these but paths, the deck of a
/// path is kThinDeck_m thinner.
inline constexpr double kClearanceOverRoad_m = 5.5, kClearanceOverRail_m = 6.5, kClearanceOverPath_m = 3.5,
                        kThinDeck_m = 0.5;
/// Clearance over rivers and standing water. Over streams narrower than kRiver_m it is smaller in proportion, at least
/// kClearanceOverDitch_m, since roads do not climb over culverts.
inline constexpr double kClearanceOverWater_m = 2, kRiver_m = 8, kClearanceOverDitch_m = 0.5;

/// Smaller shortfalls (missing clearances) are not reported: the deck may be thinner by as much.
inline constexpr double kShortfallMargin_m = 0.25;
/// Lines move only for shortfalls above this, which is rounding.
inline constexpr double kMinShortfall_m = 0.01;

/// Returns the clearance from surface to surface of one line over another, or over water of a width.
double wanted_clearance_m(map::LandCoverClass upper, map::LandCoverClass lower);
double wanted_clearance_over_water_m(double width_m);

/// Lines that are connected within this distance along the network need no clearance there (abutments, forks).
/// Distances along paths count kPathJoins times, as paths are steeper; along rails kRailJoins times.
inline constexpr double kJoined_m = 96, kPathJoins = 3, kRailJoins = 0.5;

/// A path this near to a tunnel's mouth passes in front of it.
inline constexpr double kMouth_m = 3;

/// A place where one line should have clearance over another. `kNone` as a way is a line that is not in the graph.
struct Crossing {
  std::uint32_t upper = 0, lower = kNone;  ///< Ways of the graph; kNone: a line that is not in it.
  double upper_at_m = 0, lower_at_m = 0;   ///< Distances along the ways.
  double lower_z_m = 0, upper_z_m = 0;     ///< Height of the line that is not in the graph.
  double wanted_m = 0;                     ///< Clearance from surface to surface.
  double half_width_m = 0;                 ///< Half the width of the lower line.
  OsmId outside{};                         ///< The path, stream or water that is not in the graph; none if both are.
  bool is_contradictory = false;           ///< Result of layers_contradict().
};

/// Two bridges or two tunnels that cross without a common node and have the same layer.
struct UnorderedPair {
  OsmId first, second;  ///< first < second.
  auto operator<=>(const UnorderedPair&) const = default;
};

/// True if the layers of two crossing lines do not confirm that `upper` is above: one of two bridges or two tunnels has
/// no layer, or the layers (default 1 for bridges, -1 for tunnels, 0 on the ground) are equal or in reverse order.
bool layers_contradict(const map::Track& upper, const map::Track& lower);

/// Lines and water that bridges cross and that are not in the graph.
struct BelowBridges {
  std::span<const roads::Strip> streams;     ///< Watercourses: an axis with a width on each side.
  std::span<const LandCoverPolygon> waters;  ///< Areas of water.
  std::function<double(Vec2)> ground_m;      ///< The height of paths that follow the ground.
};

/// Finds all crossings. Bridges are above lines on the ground, and these are above tunnels. If two bridges or two
/// tunnels cross, the one with the higher layer=* is above (default 1 for bridges, -1 for tunnels). There is no
/// crossing
/// - if the layers are equal, or two bridges or tunnels run side by side, farther apart than half the width of each;
/// - of corridors in buildings (paths in "tunnels" of layer 0 or above);
/// - if a line runs within another's width within kJoined_m of its end (on the ground, or at the change from bridge to
///   tunnel) that lies on the other, or the other continues within kJoined_m as a bridge or tunnel of the same layer
///   beside it: both come down side by side;
/// - if the lines are connected within kJoined_m of it, or if a path that is not in the graph shares a node with the
///   other line;
/// - if a path on the ground passes within kMouth_m of a tunnel's mouth.
/// Sorted by upper line, then by place. O(n log n) in vertices of all lines, plus bridges times vertices of areas of
/// water.
std::vector<Crossing> find_crossings(const ProfileGraph& graph, const map::FeatureView& features,
                                     const BelowBridges& below);

/// Returns pairs of bridges, and of tunnels, with equal layers whose axes cross and that are not connected within
/// kJoined_m. Sorted, unique. Corridors in buildings are left out. O(n log n) in vertices of
/// all lines.
std::vector<UnorderedPair> find_unordered(const ProfileGraph& graph, const map::FeatureView& features);

/// Returns the missing clearance for heights by node; <= 0 if there is enough.
double clearance_shortfall_m(const ProfileGraph& graph, const Crossing& crossing, std::span<const double> z_m);

}  // namespace citykiln::ground
