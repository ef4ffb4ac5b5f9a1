// How high water lies at a place, from recipes that have their levels, profiles and reaches.
//
//   ‾‾‾‾\  ~ ~ ~ ~ ~ ~ ~ ~  /‾‾‾     Across a river the heights of all its axes' pieces near by are mixed, the nearer
//        \_______•_________/         the more: so a bend, an arm or a mouth has no step.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// So far beside standing water its level is known: more than any simplified shore is off.
inline constexpr double kStandingInfluence_m = 32;

/// So far from a stream's axis its water is known: beyond its own strip, and over its river's area.
double reach_m(const roads::Strip& stream);

/// Recipes of water, sorted into buckets. Holds copies; may be moved, not copied.
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
  struct Bucket {
    std::vector<std::uint32_t> pieces, shores;
  };
  std::vector<LandCoverPolygon> standing;
  LandCoverIndex map;  ///< Of those.
  std::vector<Piece> pieces;
  std::vector<Shore> shores;
  Vec2 corner;
  int columns = 0, rows = 0;
  std::vector<Bucket> buckets;

  WaterIndex() = default;
  WaterIndex(WaterIndex&&) = default;
  WaterIndex& operator=(WaterIndex&&) = default;
  WaterIndex(const WaterIndex&) = delete;
};

/// @param box  Where it will be asked.
/// Surfaces without level and streams without profile say nothing. Cost: linear, times the buckets of 32 m that a reach
/// touches.
WaterIndex index_waters(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                        const Box2& box);

/// The height of the water at p: on a shore or within standing water its level; else of running water within reach;
/// else the level of the nearest shore within kStandingInfluence_m; else nothing.
///
/// Guarantees: on an axis the height of its profile; within the heights of the axes in reach; continuous where running
/// water is alone. Depends only on surfaces within kStandingInfluence_m of p and on axes within their reach, in the
/// order of their ids: any index of recipes trimmed no nearer gives the same bytes. p must lie in the index's box.
/// O(pieces in reach).
std::optional<double> water_m(const WaterIndex& index, Vec2 p);

}  // namespace citykiln::ground
