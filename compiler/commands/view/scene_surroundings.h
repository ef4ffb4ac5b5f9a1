// The ground beyond a scene, estimated from the land at its edge.
#pragma once

#include "compiler/scene/scene.h"
#include "preview/light/fog.h"
#include "preview/light/surroundings.h"

namespace citykiln::commands {

/// Returns the ground that continues the land and sea at the scene's edge to the horizon. The edge is that of the
/// chunks, or of the grid of heights around them (scene::Header::around).
///
/// Method: 256 places along the edge have the height of the terrain, 0 at sea, and the colour of the topmost land cover
/// polygon. In each of 64 directions height, colour and share of sea are means over an eighth of the circle on both
/// sides. Cost: O(polygons of the chunks at the edge).
preview::Surroundings surroundings_of(const scene::Scene& scene);
/// Returns the ground that continues the edge of the chunks, even if the header has a grid around them.
preview::Surroundings plain_around(const scene::Scene& scene);

/// Returns fog that reaches up to a height.
/// @param share  Share of the scene's terrain that lies below this height, 0 to 1.
preview::Fog fog_of(const scene::Scene& scene, double share);

}  // namespace citykiln::commands
