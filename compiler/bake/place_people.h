// Places the people of a tile on the ground. They have no recipes: people/people.h draws them from those of streets.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/place_lamps.h"
#include "compiler/bake/place_things.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/people/body.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// People are shown below this tolerance, in metres: none is higher.
inline constexpr double kShowsPeople_m = people::kTallestPerson_m;

/// Returns the people of a tile by the header's wish. Who sits is on the ground below the bench.
/// @param furniture   Result of place_furniture(), also on levels that do not show it: people keep clear of it.
/// @param land_cover  With each road as one surface; of the tile and people::kPeopleHalo_m about it.
/// @param graded      Covers the same box.
/// @param box         The tile.
std::vector<PlacedThing> place_people(const scene::Header& header, const scene::Chunk& chunk,
                                      std::span<const PlacedThing> furniture, const Lamps& lamps,
                                      const ground::LandCoverIndex& land_cover, const ground::GradedTerrain& graded,
                                      const Box2& box);

}  // namespace citykiln::bake
