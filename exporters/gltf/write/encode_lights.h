// Writes street lamps as lights of KHR_lights_punctual.
#pragma once

#include "exporters/gltf/write/glb_builder.h"

namespace citykiln::exporters {

/// Adds the node "lights" below the root, with a node for each lamp of the options. Adds nothing if there are none.
/// Lamps with equal properties share one light of the model.
///
/// | beam     | light | candela on the axis  | so that                                                                |
/// |----------|-------|----------------------|------------------------------------------------------------------------|
/// | kLantern | point | lumen / (3 pi)       | the street is as bright as below the lantern, which has a cap          |
/// | kDown    | spot  | 3 lumen / (2 pi)     | the cone from 0 to 90 degrees, squared as the extension says, has the  |
/// |          |       |                      | lamp's lumen                                                           |
///
/// Colours are linear with a largest component of 1. The intensity is scaled so that colour times intensity has the
/// luminance of the candela above. The range is the distance at which 0.05 lx are left, a quarter of the full moon's
/// light. Extras of a node: lumen, temperature_k, class, osm_id, osm_type; osm_id is that of the mapped lamp, or of the
/// way it lights.
void add_lights(GlbBuilder& f);

}  // namespace citykiln::exporters
