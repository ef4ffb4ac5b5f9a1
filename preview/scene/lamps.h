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
  Vec3 at;             ///< The middle of the lamp's glass, plane metres; z above sea level.
  float height_m = 0;  ///< Height of the whole lamp above the ground.
  props::Luminaire light{};
  Vec3 up{0, 0, 1};  ///< The vertical of its place.
};

/// Returns the lamps of a scene, which holds recipes in chunks (one for each square of the map): for each chunk the
/// mapped lamps, then the lamps along lit streets. Generates no meshes. Cost: the terrain of every tile with lamps is
/// computed, in parallel, since lamps stand on it.
std::vector<StreetLamp> lamps_of(const scene::Scene& scene, int threads);

/// Returns the lamps of baked tiles: their instances that lamp_named() knows, in the order of the tiles. The
/// light of a lamp follows from its kind and height, since tiles do not hold OSM tags. Tiles at tolerances at which
/// lamps are left out give no lamps. O(instances).
std::vector<StreetLamp> lamps_of(std::span<const bake::BakedTile> tiles);

/// Returns the lamps as sources of sky glow. Their positions are relative to the eye, in plan.
/// @param eye  Plane metres.
std::vector<sky::GroundLight> ground_lights(std::span<const StreetLamp> lamps, Vec3 eye);

}  // namespace citykiln::preview
