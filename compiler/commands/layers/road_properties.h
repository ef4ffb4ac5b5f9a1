// Adds the properties of roads and junctions to features of GIS layers. Both sources of layers use it: maps
// (map_layers.h) and manifests, the compiled scenes (scene_layers.h).
#pragma once

#include <string>

#include "compiler/commands/layers/layer.h"
#include "compiler/contract/findings/assumption.h"
#include "compiler/map/cross_section.h"
#include "compiler/map/features.h"

namespace citykiln::commands {

/// Returns the name of a land cover class, such as "ResidentialRoad". A road is one class of land cover.
std::string class_of(map::LandCoverClass surface);

/// Adds three properties: `lanes` (number of lanes for cars and buses, both directions together; left out if 0),
/// `section` (all lanes from left to right, in the notation of cross_section.h) and `width_m` (from kerb to kerb).
void add_section(Properties& properties, const map::CrossSection& section);

/// Adds the property `surface`: the material of a land cover class, such as "Asphalt".
void add_surface(Properties& properties, map::LandCoverClass surface);

/// Adds the property `assumed`, the names of what is assumed of an object; left out if nothing is.
void add_assumed(Properties& properties, Assumptions assumed);

/// Adds the property `layer` (the OSM layer, -10 to 10), and `bridge` or `tunnel` = true if the object is one.
void add_layer_and_passage(Properties& properties, int layer, map::Passage passage);

}  // namespace citykiln::commands
