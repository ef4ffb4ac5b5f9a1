// What is around a scene, by what is at its edge.
#pragma once

#include "compiler/scene/scene.h"
#include "preview/light/fog.h"
#include "preview/light/surroundings.h"

namespace citykiln::commands {

/// The land and sea at the edge of a scene's chunks, or at the end of the grid around them (scene::Header::around),
/// continued to the horizon.
///
/// Method: along the edge 256 places have the height of the terrain, and the colour of the topmost land cover polygon.
/// The ground around has the height of a quarter of them from below, or of the sea where a tenth of them is sea;
/// colours are means over an eighth of the circle. Cost: O(polygons of the chunks at the edge).
preview::Surroundings surroundings_of(const scene::Scene& scene);
/// The same at the edge of the chunks, whatever is known around them.
preview::Surroundings plain_around(const scene::Scene& scene);

/// Fog up to the height below which this share of the scene's ground is, 0 to 1.
preview::Fog fog_of(const scene::Scene& scene, double share);

}  // namespace citykiln::commands
