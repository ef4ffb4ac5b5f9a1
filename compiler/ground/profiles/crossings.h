// Finds crossings: places where one line passes over another without a junction, by crossing it in plan or by running
// above it within its width.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/ground/profiles/profile_graph.h"
#include "compiler/ground/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// Clearance from surface to surface: 4.5 m clear and a deck of 1 m over roads; 5.5 m over rails (overhead wires, EBO)
/// and the deck; 2.5 m over paths and the deck. The deck of a path is kThinDeck_m thinner.
inline constexpr double kClearanceOverRoad_m = 5.5, kClearanceOverRail_m = 6.5, kClearanceOverPath_m = 3.5,
                        kThinDeck_m = 0.5;
/// Over rivers and standing water; less in proportion over streams narrower than kRiver_m, at least
/// kClearanceOverDitch_m: a culvert is not a bridge to climb.
inline constexpr double kClearanceOverWater_m = 2, kRiver_m = 8, kClearanceOverDitch_m = 0.5;

/// A smaller shortfall is ignored: the deck may be thinner by that.
inline constexpr double kShortfallMargin_m = 0.25;
/// Nothing moves for a shortfall up to this: it is rounding.
inline constexpr double kMinShortfall_m = 0.01;

/// Returns the clearance from surface to surface where one line passes over another, or over water of a width.
double wanted_clearance_m(map::LandCoverClass upper, map::LandCoverClass lower);
double wanted_clearance_over_water_m(double width_m);

/// Lines connected within this distance along the network are not yet separate there (abutments, forks). Distances
/// along paths count kPathJoins times, as paths are steeper; along rails kRailJoins times.
inline constexpr double kJoined_m = 96, kPathJoins = 3, kRailJoins = 0.5;

/// A path this near to a tunnel's mouth passes in front of it.
inline constexpr double kMouth_m = 3;

/// A place where one line should clear another.
struct Crossing {
  std::uint32_t upper = 0, lower = kNone;  ///< Ways; kNone: not in the graph, at the height below.
  double upper_at_m = 0, lower_at_m = 0;
  double lower_z_m = 0, upper_z_m = 0;
  double wanted_m = 0;            ///< Clearance from surface to surface.
  double half_width_m = 0;        ///< Of the lower line.
  OsmId outside{};                ///< The path, stream or water that is not in the graph; none if both are.
  bool is_contradictory = false;  ///< Whether tags do not say which is above (layers_contradict).
};

/// Two bridges or two tunnels that cross without a common node or an order.
struct UnorderedPair {
  OsmId first, second;  ///< first < second.
  auto operator<=>(const UnorderedPair&) const = default;
};

/// Returns whether tags fail to say that the upper of two lines is above: of two bridges or two tunnels one has no
/// layer; or the layers (default 1 for bridges, -1 for tunnels, 0 on the ground) are equal or the reverse of the order.
bool layers_contradict(const map::Track& upper, const map::Track& lower);

/// What passes below bridges without being in the graph.
struct BelowBridges {
  std::span<const roads::Strip> streams;
  std::span<const LandCoverPolygon> waters;
  std::function<double(Vec2)> ground_m;  ///< The height of paths that follow the ground.
};

/// Finds all crossings. Bridges pass over the ground, and the ground and its paths over tunnels; of two bridges or two
/// tunnels the one with the higher layer=* is above (default 1 for bridges, -1 for tunnels); with equal layers there is
/// no crossing, nor where they run side by side: apart by more than half the width of each. Where a bridge goes on as a
/// tunnel it comes down, as on the ground. Corridors in buildings (paths in "tunnels" of layer 0 or above) cross
/// nothing. A line that runs along within another's width does not cross it within kJoined_m of an end that lies on the
/// other, nor where the other goes on within kJoined_m as a bridge or tunnel of the same layer beside it: they come
/// down side by side. Sorted by upper line, then by place. O(n log n) in what leaves the ground.
std::vector<Crossing> find_crossings(const ProfileGraph& graph, const map::Features& features,
                                     const BelowBridges& below);

/// Returns the bridges, and the tunnels, whose axes cross without a node in common within kJoined_m and whose layers
/// are the same. Sorted, unique. Corridors in buildings are left out. O(n log n) in what leaves the ground.
std::vector<UnorderedPair> find_unordered(const ProfileGraph& graph, const map::Features& features);

/// Returns the missing clearance for heights by node; <= 0 where there is enough.
double clearance_shortfall_m(const ProfileGraph& graph, const Crossing& crossing, std::span<const double> z_m);

}  // namespace citykiln::ground
