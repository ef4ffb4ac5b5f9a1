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

/// Returns the spots whose middle lies in a box, on the pavements of a street, or on a path or a pedestrian street.
/// Their use is kSquare on pedestrian streets, else kOpen; SpotFinder (people.cpp) sets kShops, kHouses and kPark. They
/// are counted from the start of the OSM way. O(points + spots * lanes).
std::vector<Spot> spots_along(const roads::Road& road, const Box2& box);

/// Returns the spots of a grid of kSquareStep_m in a box. The caller drops those that are not on the square. O(spots).
std::vector<Spot> spots_of_square(OsmId square, map::CountryGroup country, const Box2& box);

/// Returns the spots 0.55 m behind the kerbs at painted crossings: two at each end. O(points + roads).
/// @param tile_m  The side of the tiles, for roads::stretches_of().
std::vector<Spot> spots_at_crossings(std::span<const roads::Road> roads, std::span<const roads::Junction> junctions,
                                     double tile_m, const Box2& box);

/// Returns six spots beside a stop, three on either side, up to 3.9 m away and 0.2 to 1.2 m behind it.
std::vector<Spot> spots_at_stop(const Solid& stop, map::CountryGroup country);

/// Returns the two spots on a bench.
std::vector<Spot> spots_on_seat(const Solid& seat, map::CountryGroup country);

}  // namespace citykiln::people
