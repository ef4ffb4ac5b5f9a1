// Writes street lamps as UsdLux lights.
#pragma once

#include <span>

#include "compiler/bake/place_lamps.h"
#include "exporters/usd/layer_writer.h"

namespace citykiln::exporters {

/// Writes the prim "lights" with a light for each lamp; writes nothing if there are no lamps. A lantern is a
/// SphereLight of 0.1 m radius with lumen / (3 pi) candela. A lamp that shines down is a DiskLight of 0.15 m radius
/// with all of its lumen. The intensity is the luminance over usd_unit_luminance_cd_m2() (encode_scene.h); the colour
/// is linear and has luminance 1. customData: lumen, temperature_k, class, osm_id, osm_type.
/// @param origin  The tile's origin, plane metres.
void write_usd_lights(LayerWriter& writer, std::span<const bake::PlacedLamp> lamps, Vec3 origin);

}  // namespace citykiln::exporters
