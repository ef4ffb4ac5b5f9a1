// Writes street lamps as lights of UsdLux.
#pragma once

#include <span>

#include "compiler/bake/place_lamps.h"
#include "exporters/usd/layer_writer.h"

namespace citykiln::exporters {

/// Writes the prim "lights" with a light for each lamp: a lantern is a SphereLight of 0.1 m radius with the lamp's
/// lumen over 3 pi as candela, what shines down a DiskLight of 0.15 m radius with all of its lumen. The intensity is
/// the luminance over usd_unit_luminance_cd_m2() (encode_scene.h), the colour a linear one of luminance 1. customData:
/// lumen, temperature_k, class, osm_id, osm_type. Nothing without lamps.
/// @param origin  Of the tile, plane metres.
void write_usd_lights(LayerWriter& writer, std::span<const bake::PlacedLamp> lamps, Vec3 origin);

}  // namespace citykiln::exporters
