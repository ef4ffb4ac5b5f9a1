// Puts the people of a tile on the ground. They have no recipes: people/people.h makes them from recipes of streets.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/place_generated.h"
#include "compiler/people/body.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// People are baked at tolerances below the height of the tallest person, in metres.
inline constexpr double kShowsPeople_m = people::kTallestPerson_m;

/// Returns the people of a tile by the settings of the header. The origin of a sitting person is below the bench.
/// @param furniture  The result of place_generated() without cars; people keep clear of it.
/// @param box        The tile.
std::vector<PlacedThing> place_people(const scene::Header& header, const scene::Chunk& chunk,
                                      std::span<const PlacedThing> furniture, const TileGround& ground,
                                      const Box2& box);

}  // namespace citykiln::bake
