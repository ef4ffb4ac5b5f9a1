// The height of the land with landforms: level areas (pitches), steps (retaining walls, cliffs), ridges (dykes, dams),
// and decks above water (piers, breakwaters). Level areas change the terrain before the others: in an area the land is
// its plane; beside it banks of 1 : 4, or steeper ones that meet the terrain within kLandformReach_m.
//
//                 top  _______ terrain     A step raises the land on its high side to its top, and lowers the land on
//               ______|      .             its low side to its foot, each by at most its rise (top minus foot). From
//      terrain .      |                    kLandformReach_m / 2 to kLandformReach_m from the axis this fades to 0.
//      _______________| foot               Within the wall's thickness the land falls from the top to the foot.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/ground/landforms/recipe.h"

namespace citykiln::ground {

/// Copies of landforms, with a spatial index.
struct LandformIndex {
  /// A segment of an axis, or a whole area.
  struct Piece {
    std::uint32_t form = 0, segment = 0;  ///< Indices into `forms`, and of the segment of its axis; 0 for areas.
    Box2 reach;                           ///< The box, widened by the distance at which it changes the land.
  };
  std::vector<Landform> forms;
  std::vector<std::vector<double>> along_m;  ///< For each form the distance of each vertex along the whole way.
  std::vector<Piece> pieces;                 ///< In the order of forms.
  BoxGrid grid;                              ///< The reaches of `pieces`.
  bool has_level = false;                    ///< True if any form is of kind kLevel.
};

/// Indexes landforms, which must be sorted by id. Landforms without a profile change nothing. O(n).
LandformIndex index_landforms(std::span<const Landform> forms);

/// The nearest step, as seen from a place.
struct StepSide {
  double away_m = 0;      ///< Distance of the place from the axis.
  double rise_m = 0;      ///< Height of the step; it fades with the distance, and beyond the ends of the axis.
  double high_share = 0;  ///< 1 on the high side, 0 on the low side, in between within the wall's thickness.
};

/// The land at a place, plane metres.
struct LandformHeights {
  double land_m = 0;                                         ///< The terrain, changed by steps and ridges.
  double deck_m = -std::numeric_limits<double>::infinity();  ///< The ground is at least this high, also in water.
  std::optional<StepSide> step{};                            ///< Empty if no step is near.
};

/// Returns the heights at p. The land is at terrain_m where no landform is near.
/// @param terrain_m  The terrain's height at p.
/// Guarantees: depends only on landforms whose edge is within kLandformReach_m of p, in the order of their ids, so
/// recipes that are trimmed to a tile give the same bits. O(pieces near).
LandformHeights landform_heights(const LandformIndex& index, Vec2 p, double terrain_m);

/// Returns the height of the ground on which things are planned at p: the land, or the deck if it is higher.
double with_landforms_m(const LandformIndex& index, Vec2 p, double terrain_m);

/// Returns the slope of the sides of a ridge, dam or deck, height over distance.
double side_slope(LandformKind kind);

}  // namespace citykiln::ground
