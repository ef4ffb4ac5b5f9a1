// The parts of plots that all of their kinds share: rectangles, surfaces, bushes.
#pragma once

#include <cstdint>

#include "compiler/vacant/plots.h"

namespace citykiln::vacant {

/// A rectangle in the plane: `width_m` along `along`, which is its front, and `depth_m` along `back`.
struct PlotRectangle {
  Vec2 corner;       ///< The front left corner.
  Vec2 along, back;  ///< Unit vectors of its sides; `back` is to the left of `along`.
  double width_m = 0, depth_m = 0;

  Vec2 at(double x_m, double y_m) const { return corner + along * x_m + back * y_m; }
  Vec2 centre() const { return at(width_m / 2, depth_m / 2); }
};

/// Returns the corners, counter-clockwise from the front left one, snapped to multiples of kQuantum_m.
Ring ring_of(const PlotRectangle& rectangle);

/// True if the bounding box of a ring lies in the tile, 1 m or more from its border.
bool is_in_tile(const PlotInputs& inputs, const Ring& ring);

/// Returns the ground of a plot: a yard whose outline and frame are the rectangle.
/// @param id  The id of an area, a road or a building; random draws of the yard depend on it.
lots::Yard ground_of(const PlotRectangle& rectangle, ObjectId id, lots::LotKind kind, map::CountryGroup country);

/// Returns a surface that lies above land use of a priority, and below yards and all that is mapped more finely.
ground::LandCoverPolygon surface_on(map::LandCoverClass surface, ObjectId id, int priority, std::vector<Ring> rings);

/// Adds bushes along the sides and the rear of a rectangle, and inside it, on urban land use, unmapped land and
/// allotments, at least 1 m from ways and 2 m from walls. Bushes outside of the tile are left out.
/// @param rim     The mean number on 100 m of its border.
/// @param inside  The mean number on 100 m2.
void add_bushes(const PlotInputs& inputs, const PlotRectangle& rectangle, ObjectId id, double rim, double inside,
                Plots& plots);

}  // namespace citykiln::vacant
