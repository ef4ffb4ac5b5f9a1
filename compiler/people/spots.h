// Spots of a tile: along pavements, paths and streets for walkers, on squares, at crossings, stops and benches.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/lots/mapped_things.h"
#include "compiler/map/countries/country_group.h"
#include "compiler/people/spot.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/recipe.h"

namespace citykiln::people {

/// The distance of spots along pavements, along paths, and on squares, in metres.
inline constexpr double kPavementStep_m = 3, kPathStep_m = 6, kSquareStep_m = 4;

/// A thing or a lamp on the ground.
struct Solid {
  Vec2 at{}, right{};  ///< Its middle, and the direction of its width, length 1.
  double width_m = 0, depth_m = 0;
  bool is_seat = false, is_stop = false;
  OsmId feature{};
};

/// Returns the spots on the pavements of a street, or on a path or a street for walkers, whose middle lies in a box.
/// Their use is kOpen, or kSquare; people.h looks for houses. They are numbered from the start of the whole way.
/// O(points
/// + spots · lanes).
std::vector<Spot> spots_along(const roads::Road& road, const Box2& box);

/// Returns the spots of a grid in a box: those on a square are among them. O(spots).
std::vector<Spot> spots_of_square(OsmId square, map::CountryGroup country, const Box2& box);

/// Returns the spots at the kerbs before crossings: two at each end.
/// @param tile_m  Side of the tiles (roads::stretches_of()).
std::vector<Spot> spots_at_crossings(std::span<const roads::Road> roads, std::span<const roads::Junction> junctions,
                                     double tile_m, const Box2& box);

/// Returns the spots at a stop: three on either side, behind it.
std::vector<Spot> spots_at_stop(const Solid& stop, map::CountryGroup country);

/// Returns the spots on a bench: two.
std::vector<Spot> spots_on_seat(const Solid& seat, map::CountryGroup country);

}  // namespace citykiln::people
