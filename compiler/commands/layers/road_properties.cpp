#include "compiler/commands/layers/road_properties.h"

#include <algorithm>

#include "compiler/contract/findings/assumption_names.h"
#include "compiler/map/land_cover_class.h"
#include "compiler/materials/material.h"

namespace citykiln::commands {

std::string class_of(map::LandCoverClass surface) { return std::string(map::values_of(surface).name); }

void add_section(Properties& properties, const map::CrossSection& section) {
  const auto is_for_traffic = [](const map::Lane& lane) {
    return lane.kind == map::LaneKind::kDriving || lane.kind == map::LaneKind::kBus ||
           lane.kind == map::LaneKind::kTurn;
  };
  if (const auto lanes = std::ranges::count_if(section.lanes, is_for_traffic); lanes > 0)
    properties.add("lanes", lanes);
  properties.add("section", map::to_string(section));
  properties.add("width_m", map::carriageway_width_m(section));
}

void add_surface(Properties& properties, map::LandCoverClass surface) {
  properties.add("surface", materials::values_of(map::values_of(surface).material).name);
}

void add_assumed(Properties& properties, Assumptions assumed) {
  if (assumed != kNoAssumptions) properties.add("assumed", names_in(assumed));
}

void add_layer_and_passage(Properties& properties, int layer, map::Passage passage) {
  properties.add("layer", layer);
  properties.add("bridge", passage == map::Passage::kBridge);
  properties.add("tunnel", passage == map::Passage::kTunnel);
}

}  // namespace citykiln::commands
