// Finds what is assumed where something is mapped: assumed pavements, lamps, railings and masts in water, buildings,
// railways and carriageways, shop fronts on walls that are not free, yards over mapped land, and houses that fill lots
// on roads or other buildings.
#pragma once

#include <cstdint>

#include "compiler/bake/baked_tile.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// Assumed objects of one kind in a tile.
struct AssumedPlaces {
  std::uint64_t places = 0;     ///< Number of places, or of objects, that were tested.
  std::uint64_t misplaced = 0;  ///< Number of those where something is mapped.
  Vec2 at;                      ///< The first one.
  OsmId first{}, on{};  ///< The element that it descends from, and the mapped one. `on` may be of OsmType::kNone.
};

/// Tests the middles of the strips beyond the kerbs, within the width limits, of ground roads with assumed pavements or
/// verges on that side, at most 4 m apart, in a box. None may lie
/// - in mapped water, a building or a square, unless the axis beside it lies there too;
/// - on a railway, the carriageway of another road, or a path that runs along the road. Other paths may join a
/// pavement. Places within kJunctionRadius_m of a node that both ways have are not tested against each other. O(places
/// · roads near).
AssumedPlaces measure_assumed_pavements(const scene::Chunk& chunk, const Box2& box);

/// Tests every instanced lamp of a way with assumed lamps: none may stand on a carriageway, a railway, a building or
/// water. Lamps are recognised by the name of their mesh. Pedestrian streets are allowed. O(instances).
/// @param land_cover  Land cover of the tile.
AssumedPlaces measure_assumed_lamps(const bake::BakedTile& tile, const scene::Chunk& chunk,
                                    const ground::LandCoverIndex& land_cover);

/// Tests every assumed railing every metre: it lies neither on a carriageway, a railway, steps, a building or water,
/// nor within 1 m of a door, and crosses the axis of no other road or path on the ground. Pedestrian streets are
/// allowed. O(length · roads near).
/// @param land_cover  Land cover of the tile.
/// @param box         The box in which land cover is known.
AssumedPlaces measure_assumed_railings(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                       const Box2& box);

/// Tests the feet of every assumed mast of a contact line: none stands on a carriageway, a railway, a building or
/// water, nor nearer to the axis of a railway than 2.6 m, of a tramway than 1.75 m. Pedestrian streets are allowed.
/// O(masts · tracks).
/// @param land_cover  Land cover of the tile.
/// @param box         The box in which land cover is known.
AssumedPlaces measure_assumed_masts(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                    const Box2& box);

/// Tests every assumed shop front of the chunk's buildings: it lies within its wall, and neither on a party wall, nor
/// on another front, nor across the opening for a way. O(fronts · what is on their walls).
AssumedPlaces measure_assumed_fronts(const scene::Chunk& chunk);

/// Tests the yards of a tile. Their trees stand in no building, road, railway, path or water, in no barrier, and not
/// below a power line; pedestrian streets are allowed. At places of a grid of 4 m, no yard is on top where finer land
/// than land use is mapped.
/// @param land_cover  Covers the box.
AssumedPlaces measure_assumed_yards(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                    const Box2& box);

/// Tests the houses that fill lots: the corners and the middles of their walls, an eighth of a metre inside, lie on no
/// road, railway, path or water, and in no other building. Pedestrian streets are allowed.
/// @param land_cover  Covers the box.
AssumedPlaces measure_assumed_houses(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                     const Box2& box);

}  // namespace citykiln::verify
