// Places the objects that have no recipes of their own: street trees, parked and moving cars, street furniture, utility
// poles, things of yards. The folders cars/ and furniture/ choose them at random, by the seed, from the recipes of
// streets, car parks and yards when a tile is baked.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/place_lamps.h"
#include "compiler/bake/place_things.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// Upper bounds of the heights, in metres, of generated objects: cars; furniture, things of yards and utility poles;
/// cranes on building sites. A level shows a kind only if its tolerance is smaller than the kind's bound.
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

/// Removes the generated people, cars, furniture and cranes that a level of this tolerance does not show. Returns a
/// bound of the heights of the kinds that are left out, in metres, for the level's error. The bound depends on the
/// header, the chunk and the tolerance, not on `things`. It is 0 if the layer of things is not shown.
double leave_out_drawn(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m,
                       std::vector<PlacedThing>& things);

/// Returns the trees of a tile's recipes and those that are assumed along its streets (furniture/street_trees.h), which
/// there are none of without scene::Header::has_street_furniture.
/// @param ground  Its trunks are not read.
std::vector<plants::Tree> trees_with_street_trees(const scene::Header& header, const scene::Chunk& chunk,
                                                  const TileGround& ground, const Box2& box);

/// Returns the parked cars of a tile, its moving cars, the things of its yards, its refuges (traffic islands), its
/// other furniture, and its poles, in this order, by the header's settings.
///
/// - A car stands on the plane that fits best to the heights of the ground below its four wheels. There is none where
///   that is steeper than 25 % along the car or 12.5 % across it.
/// - Furniture stands upright, at the height of the lowest corner of its base. Only kinds whose rules the header has
///   are placed. Refuges are the only furniture, and there are no poles, without scene::Header::has_street_furniture.
/// - Things of yards and poles stand in the same way; a thing of a yard is left out where the ground rises by more than
///   0.4 m above its foot.
///
/// @param box  The tile.
GeneratedThings place_generated(const scene::Header& header, const scene::Chunk& chunk, const TileGround& ground,
                                const Box2& box, const WantedThings& wanted);

}  // namespace citykiln::bake
