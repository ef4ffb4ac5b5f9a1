// The street lamps of a scene as light sources.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/props/luminaire.h"
#include "compiler/scene/scene.h"
#include "compiler/sky/atmosphere/town_glow.h"

namespace citykiln::preview {

/// A street lamp that is lit.
struct StreetLamp {
  Vec3 at;             ///< The middle of its glass, plane metres.
  float height_m = 0;  ///< Height of the whole lamp above the ground.
  props::Luminaire light{};
};

/// Returns the lamps of a scene from its recipes, in the order of its chunks: mapped ones, then those along lit
/// streets. Generates no geometry; cost: grading the terrain of every tile with lamps, in parallel.
std::vector<StreetLamp> lamps_of(const scene::Scene& scene, int threads);

/// Returns the lamps of baked tiles: their instances named "PostTopLamp" and "ArmLamp", in the order of the tiles.
/// Their light is that of their kind and height, since tiles do not hold tags. Tiles whose tolerance drops lamps have
/// none. O(instances).
std::vector<StreetLamp> lamps_of(std::span<const bake::BakedTile> tiles);

/// Returns lamps as sources of sky glow, relative to an eye.
std::vector<sky::GroundLight> ground_lights(std::span<const StreetLamp> lamps, Vec3 eye);

}  // namespace citykiln::preview
