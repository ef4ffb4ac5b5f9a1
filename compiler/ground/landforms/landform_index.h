// The land with landforms: retaining walls and cliffs as steps, dykes and dams as ridges, piers as decks above water.
//
//                 top  _______ terrain        A step moves the land on both sides to the heights of its own top and
//               ______|      .                foot, at most by its rise, and less from kLandformReach_m / 2 on, so that
//      terrain .      |                       the land meets the terrain at kLandformReach_m. Within the wall's own
//      _______________| foot                  thickness the land falls from the top to the foot.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/ground/landforms/recipe.h"

namespace citykiln::ground {

/// Landforms with a spatial index. Contains copies of them.
struct LandformIndex {
  /// A segment of a line, or a whole area.
  struct Piece {
    std::uint32_t form = 0, segment = 0;  ///< Indices into `forms`, and of the axis' segment; 0 for areas.
  };
  std::vector<Landform> forms;
  std::vector<std::vector<double>> along_m;  ///< Per form the distance of each vertex along the whole way.
  std::vector<Piece> pieces;                 ///< In the order of forms.
  BoxGrid grid;                              ///< Boxes of the pieces, widened by their influence.
};

/// Indexes landforms, which must be sorted by id. O(n).
LandformIndex index_landforms(std::span<const Landform> forms);

/// The side of the nearest step.
struct StepSide {
  double away_m = 0;  ///< Distance from its axis.
  double rise_m = 0;  ///< Height of the step.
  double share = 0;   ///< 1 above the step, 0 below, in between within its thickness.
};

/// The land at a place.
struct LandformHeights {
  double land_m = 0;                                         ///< The terrain with steps and ridges.
  double deck_m = -std::numeric_limits<double>::infinity();  ///< The land is at least this high, also in water.
  std::optional<StepSide> step{};                            ///< Empty if no step is near.
};

/// Returns the heights at p.
/// @param terrain_m  The terrain's height at p.
/// Guarantees: depends on landforms within kLandformReach_m of p only, in the order of their ids, so trimmed recipes
/// give the same bits; equals terrain_m where there are none. O(pieces near).
LandformHeights landform_heights(const LandformIndex& index, Vec2 p, double terrain_m);

/// Returns the height on which things are planned: the land with landforms, at least that of decks.
double with_landforms_m(const LandformIndex& index, Vec2 p, double terrain_m);

/// Returns the slope of a landform's sides, height over distance.
double side_slope(LandformKind kind);

}  // namespace citykiln::ground
