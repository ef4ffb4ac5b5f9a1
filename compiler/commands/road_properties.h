// Properties of roads and junctions, which layers of a map and of a manifest share.
#pragma once

#include <string>

#include "compiler/commands/layer.h"
#include "compiler/map/cross_section.h"
#include "compiler/map/features.h"

namespace citykiln::commands {

/// The name of a land cover class, "ResidentialRoad".
std::string class_of(map::LandCoverClass surface);

/// Adds lanes (of traffic, both directions), section (all lanes, in the notation of cross_section.h) and width_m (from
/// kerb to kerb).
void add_section(Properties& properties, const map::CrossSection& section);

/// Adds surface, the material of a class: "Asphalt".
void add_surface(Properties& properties, map::LandCoverClass surface);

/// Adds layer, and bridge or tunnel where the object is one.
void add_place(Properties& properties, int layer, map::Passage passage);

}  // namespace citykiln::commands
