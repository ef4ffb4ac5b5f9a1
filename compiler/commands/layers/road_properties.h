// Properties of roads and junctions, shared by the layers of a map and of a manifest.
#pragma once

#include <string>

#include "compiler/commands/layers/layer.h"
#include "compiler/map/cross_section.h"
#include "compiler/map/features.h"

namespace citykiln::commands {

/// Returns the name of a land cover class, such as "ResidentialRoad".
std::string class_of(map::LandCoverClass surface);

/// Adds the properties lanes (lanes of traffic in both directions), section (all lanes, in the notation of
/// cross_section.h) and width_m (from kerb to kerb).
void add_section(Properties& properties, const map::CrossSection& section);

/// Adds the property surface, the material of a class, such as "Asphalt".
void add_surface(Properties& properties, map::LandCoverClass surface);

/// Adds the property layer, and bridge or tunnel if the object is one.
void add_place(Properties& properties, int layer, map::Passage passage);

}  // namespace citykiln::commands
