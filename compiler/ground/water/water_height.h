// The height of water at a place, from recipes with levels, profiles and influence radii.
//
//   ‾‾‾‾\  ~ ~ ~ ~ ~ ~ ~ ~  /‾‾‾     Across a river the heights of all pieces of axes near by are blended, nearer ones
//        \_______•_________/         with more weight, so that bends, arms and mouths make no steps.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// The level of standing water applies up to this distance from its shore, farther than simplification moves any shore.
inline constexpr double kStandingInfluence_m = 32;

/// Returns the influence radius of a stream: the distance from its axis within which its profile gives heights. It
/// contains the stream's own strip, and the area of its river.
double influence_radius_m(const roads::Strip& stream);

/// An index of water recipes. Contains copies of them; can be moved, not copied.
struct WaterIndex {
  /// A piece of an axis along which the height is linear.
  struct Piece {
    Vec2 a, b;
    double from_m, to_m;  ///< Heights at a and b.
    double influence_radius_m;
  };
  /// A piece of a shore.
  struct Shore {
    Vec2 a, b;
    double level_m;
  };
  std::vector<LandCoverPolygon> standing;
  LandCoverIndex standing_index;  ///< Index of `standing`.
  std::vector<Piece> pieces;
  std::vector<Shore> shores;
  BoxGrid pieces_grid, shores_grid;  ///< Grids of the boxes of influence of pieces and shores, in the index's box.

  WaterIndex() = default;
  WaterIndex(WaterIndex&&) = default;
  WaterIndex& operator=(WaterIndex&&) = default;
  WaterIndex(const WaterIndex&) = delete;
};

/// Builds the index. Polygons without level and streams without profile are ignored. Linear, times the 32 m buckets
/// within a radius.
/// @param box  The box in which heights can be queried.
WaterIndex index_waters(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                        const Box2& box);

/// Returns the height of water at p: inside standing water and on its shore its level; else the height of running water
/// whose radius of influence contains p; else the level of the nearest shore within kStandingInfluence_m; else nothing.
///
/// Guarantees: on an axis, the height of its profile; elsewhere a height between the lowest and highest axis in range;
/// continuous away from standing water. Depends only on polygons within kStandingInfluence_m of p and on axes whose
/// radius contains p, in the order of their ids, so trimmed recipes give the same bits. p must lie in the index's box.
/// O(pieces in range).
std::optional<double> water_m(const WaterIndex& index, Vec2 p);

}  // namespace citykiln::ground
