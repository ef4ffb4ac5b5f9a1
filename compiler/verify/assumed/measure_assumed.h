// Finds assumed objects that conflict with mapped ones: assumed pavements, lamps, railings, masts and street furniture
// in water, buildings, railways and carriageways; parked cars off the paved ground; people in the carriageway; shop
// fronts on walls that are not free; yards over mapped land; and houses that fill lots on roads or other buildings.
//
// Each function tests the assumed objects of one kind in one tile. Where it takes the land cover of the tile, this must
// cover the box; places outside of the box are not tested. Pedestrian streets are no obstacle, except for pavements.
#pragma once

#include <cstdint>

#include "compiler/bake/baked_tile.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// The tests of assumed objects of one kind in a tile.
struct AssumedTests {
  std::uint64_t tested = 0;     ///< Number of places, or of objects, that were tested.
  std::uint64_t conflicts = 0;  ///< Number of those that meet a mapped object.
  Vec2 at;                      ///< The place of the first conflict, plane metres.
  OsmId element{};              ///< The element that the assumed object there descends from.
  OsmId obstacle{};  ///< The mapped element there. OsmType::kNone for a door, unmapped land, furniture and shop fronts.
};

/// Tests assumed pavements and verges of roads on the ground: places on the middle line of the land between kerb and
/// outer edge, after width limits, on the sides with assumed ones, at most 4 m apart. Land narrower than 0.25 m is not
/// tested. A place conflicts if it lies
/// - in mapped water, a building or a square, unless the axis beside it lies there too;
/// - on a railway, on the carriageway of another road, or on a path that runs along the road (at less than about 37
///   degrees). Paths at a greater angle may join a pavement.
///
/// A place within roads::kJunctionRadius_m of a node that both ways have does not conflict with the other way.
/// O(places · roads near).
/// @param box  The tile, plane metres.
AssumedTests measure_assumed_pavements(const scene::Chunk& chunk, const Box2& box);

/// Tests every instanced lamp of a way with assumed lamps: it conflicts on a carriageway, a railway, a building or
/// water. Lamps are recognised by the name of their mesh. O(instances).
/// @param tile        A baked level of the chunk.
/// @param land_cover  Land cover of the tile.
AssumedTests measure_assumed_lamps(const bake::BakedTile& tile, const scene::Chunk& chunk,
                                   const ground::LandCoverIndex& land_cover);

/// Tests every parked car, by the plan of its instance, less an edge of 0.3125 m. A car conflicts if a corner or its
/// middle lies on a building, a railway or water; on ground that is neither paved nor a yard, unless the map has a
/// parking space there; or if it is within 1.25 m of a door. Cars are recognised by the name of their mesh.
/// O(instances).
/// @param tile        A baked level of the chunk that shows cars.
/// @param land_cover  Land cover of the tile.
AssumedTests measure_parked_cars(const bake::BakedTile& tile, const scene::Chunk& chunk,
                                 const ground::LandCoverIndex& land_cover);

/// Tests every car of a street, moving or at its kerb, but none in a yard, by its plan less an edge of 0.25 m. One
/// conflicts if a corner or its middle lies neither on a carriageway nor on a car park, or if its plan overlaps that of
/// another car. Cars are recognised by the name of their mesh, and as they descend from roads. O(instances · cars
/// near).
/// @param tile        A baked level of the chunk that shows cars.
/// @param land_cover  Land cover of the tile.
AssumedTests measure_street_cars(const bake::BakedTile& tile, const scene::Chunk& chunk,
                                 const ground::LandCoverIndex& land_cover);

/// Tests every piece of assumed street furniture, by the plan of its instance, less an edge of 0.1 m. A piece conflicts
/// if a corner or its middle lies on a carriageway, a railway, a building or water; if it is within 1 m of a door; or
/// if it overlaps another piece by more than 2 cm. Pieces are recognised by the name of their mesh, and as they descend
/// from roads. O(instances).
/// @param tile        A baked level of the chunk that shows furniture.
/// @param land_cover  Land cover of the tile.
AssumedTests measure_street_furniture(const bake::BakedTile& tile, const scene::Chunk& chunk,
                                      const ground::LandCoverIndex& land_cover);

/// Tests every person, by the middle and four places 0.2 m about it. One conflicts on a carriageway (not of a street
/// for walkers), a railway, a building or water, and with the middle in a thing or lamp of another mesh; who sits on a
/// bench does not. People are recognised by the name of their mesh. O(people · things).
/// @param tile        A baked level of the chunk that shows people.
/// @param land_cover  Land cover of the tile.
AssumedTests measure_people(const bake::BakedTile& tile, const ground::LandCoverIndex& land_cover);

/// Tests every railing, all of which are assumed. Each segment is tested once against the axes of the other roads and
/// paths on the ground, which it must not cross, and each of its places, at most 1 m apart, which must not lie on a
/// carriageway, a railway, steps, a building or water, nor within 1 m of a door. Segments with an end outside of the
/// box are not tested. O(length · roads near).
/// @param land_cover, box  The land cover of the tile, and the box that it covers.
AssumedTests measure_assumed_railings(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                      const Box2& box);

/// Tests the feet of every assumed mast of a contact line: one, or two of a portal. A foot conflicts on a carriageway,
/// a railway, a building or water, and nearer than 2.6 m to the axis of a railway, 1.75 m to that of a tramway. O(masts
/// · tracks).
/// @param land_cover, box  The land cover of the tile, and the box that it covers.
AssumedTests measure_assumed_masts(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                   const Box2& box);

/// Tests assumed hedges and walls of fields, and hedges and guard rails beside roads, at places at most 2 m apart: none
/// may lie on a carriageway, a railway, a building or water. O(length).
/// @param land_cover, box  The land cover of the tile, and the box that it covers.
AssumedTests measure_assumed_hedges(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                    const Box2& box);

/// Tests every assumed shop front of the chunk's buildings. It conflicts if it leaves its wall, or overlaps a party
/// wall, another front or the opening for a way; AssumedTests::at is then the first corner of its wall. O(fronts · what
/// is on their walls).
AssumedTests measure_assumed_fronts(const scene::Chunk& chunk);

/// Tests the yards of a tile. A tree or shrub of a yard conflicts in a building, on a road, railway, path or water, in
/// a barrier (within 0.25 m of its faces) and below a power line. The surface of a yard conflicts at a place of a grid
/// of 4 m where land that is finer than land use is mapped too. O(trees · barriers + area of the box).
/// @param land_cover, box  The land cover of the tile, and the box that it covers.
AssumedTests measure_assumed_yards(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                   const Box2& box);

/// Tests the houses that fill lots (--fill lots), at each corner and the middle of each wall, an eighth of a metre
/// towards the centroid. A place conflicts on a road, railway, path or water, and in a building that is not of the same
/// lot. O(corners · buildings).
/// @param land_cover, box  The land cover of the tile, and the box that it covers.
AssumedTests measure_assumed_houses(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                    const Box2& box);

}  // namespace citykiln::verify
