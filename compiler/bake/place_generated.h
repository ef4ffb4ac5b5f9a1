// Places what is drawn when a tile is baked: street trees, parked cars, street furniture, utility poles, things of
// yards. They have no recipes: the rooms cars and furniture draw them from those of streets, car parks and yards.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/place_lamps.h"
#include "compiler/bake/place_things.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The greatest heights of what is drawn: of cars; of furniture and things of yards, to utility poles; of cranes on
/// building sites. A level whose tolerance is not below such a height has none of it, whatever other levels show.
inline constexpr double kShowsCars_m = 3, kShowsFurniture_m = 10, kShowsCranes_m = 38;

/// The kinds of things that are to be placed.
struct WantedThings {
  bool cars = false, furniture = false;
  bool cranes = false;  ///< Without other furniture; these are part of it.
};

/// The ground of a tile, and lamps and trees on it.
struct TileGround {
  const ground::LandCoverIndex&
      land_cover;                       ///< With each road as one surface; of the tile and scene::kHalo_m about it.
  const ground::GradedTerrain& graded;  ///< Covers the same box.
  const Lamps& lamps;
  std::span<const Vec2> trunks;         ///< plants::GeneratedPlants::trunks.
  std::span<const lots::Yard> plots{};  ///< vacant::Plots::grounds.
};

/// Two poles between which wires hang.
struct PlacedPoleSpan {
  ObjectId id;
  things::Form form;  ///< The form of both poles.
  Placement from, to;
};

/// The things that are drawn, and the spans between poles.
struct GeneratedThings {
  std::vector<PlacedThing> placed;
  std::vector<PlacedPoleSpan> pole_spans;  ///< The spans whose middle lies in the tile.
};

/// Removes the drawn things that are not at a tolerance. Returns a bound of their heights, for a level's error: the
/// same whether or not they were placed for another level.
double leave_out_drawn(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m,
                       std::vector<PlacedThing>& things);

/// Returns the trees of a tile's recipes and those that are assumed along its streets (furniture/street_trees.h), which
/// there are none of without scene::Header::has_street_furniture.
/// @param ground  Its trunks are not read.
std::vector<plants::Tree> trees_with_street_trees(const scene::Header& header, const scene::Chunk& chunk,
                                                  const TileGround& ground, const Box2& box);

/// Returns the cars of a tile by the header's settings, then its furniture, the things of its yards, and its poles.
///
/// - A car stands on the plane that fits best to the heights of the ground below its four wheels. There is none where
///   that is steeper than 25 % along the car or 12.5 % across it.
/// - Furniture stands upright, as high as the lowest corner of its base; of the kinds whose rules the header has. There
///   is none without scene::Header::has_street_furniture.
/// - Things of yards and poles stand in the same way; a thing of a yard is left out where the ground rises by more than
///   0.4 m above its foot.
///
/// @param box  The tile.
GeneratedThings place_generated(const scene::Header& header, const scene::Chunk& chunk, const TileGround& ground,
                                const Box2& box, const WantedThings& wanted);

}  // namespace citykiln::bake
