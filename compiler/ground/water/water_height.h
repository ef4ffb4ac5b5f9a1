// The height of water at a place, from recipes with levels, profiles and influence radii.
//
//   ‾‾‾‾\  ~ ~ ~ ~ ~ ~ ~ ~  /‾‾‾     Across a river the heights of all pieces of axes near by are blended, the nearer
//        \_______•_________/         the more: so a bend, an arm or a mouth makes no step.
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

/// The level of standing water is known up to this distance: farther than any simplified shore moves.
inline constexpr double kStandingInfluence_m = 32;

/// Returns the influence radius of a stream: beyond its own strip, and over its river's area.
double reach_m(const roads::Strip& stream);

/// Recipes of water, indexed. Holds copies; can be moved, not copied.
struct WaterIndex {
  /// A piece of an axis along which the height is linear.
  struct Piece {
    Vec2 a, b;
    double from_m, to_m;  ///< Heights at a and b.
    double reach_m;
  };
  /// A piece of a shore.
  struct Shore {
    Vec2 a, b;
    double level_m;
  };
  std::vector<LandCoverPolygon> standing;
  LandCoverIndex map;  ///< Of `standing`.
  std::vector<Piece> pieces;
  std::vector<Shore> shores;
  BoxGrid pieces_grid, shores_grid;  ///< Of the boxes that pieces and shores influence, within the index's box.

  WaterIndex() = default;
  WaterIndex(WaterIndex&&) = default;
  WaterIndex& operator=(WaterIndex&&) = default;
  WaterIndex(const WaterIndex&) = delete;
};

/// Builds the index.
/// @param box  Where heights may be asked for.
/// Polygons without level and streams without profile are ignored. Linear, times the 32 m buckets within a radius.
WaterIndex index_waters(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                        const Box2& box);

/// Returns the height of water at p: on a shore or inside standing water its level; else that of running water within
/// its radius; else the level of the nearest shore within kStandingInfluence_m; else nothing.
///
/// Guarantees: on an axis the height of its profile; between the lowest and highest axis in range; continuous where
/// running water is alone. Depends only on polygons within kStandingInfluence_m of p and on axes within their radius,
/// in the order of their ids: an index of recipes trimmed no nearer gives the same bits. p must lie in the index's box.
/// O(pieces in range).
std::optional<double> water_m(const WaterIndex& index, Vec2 p);

}  // namespace citykiln::ground
