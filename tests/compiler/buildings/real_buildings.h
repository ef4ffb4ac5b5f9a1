// The buildings of real extracts, planned on level ground.
#pragma once

#include <string>
#include <vector>

#include "compiler/buildings/plan.h"
#include "compiler/map/locate.h"
#include "compiler/source/read_osm.h"
#include "tests/test_files.h"

namespace citykiln::buildings {

/// Returns the buildings of an extract; none if the file cannot be read.
inline std::vector<Building> buildings_in(const std::string& name) {
  Report report;
  const auto osm = source::read_osm(real_data(name), 2, report);
  if (!osm) return {};
  const source::LonLatBox box = map::choose_box(*osm, {});
  const map::Plane plane(map::default_origin(box));
  const map::Features features = map::locate(*osm, plane, box, {}, report);
  map::Heightfield level{{-64, -64}, {64, 64}, 3, 3, std::vector<std::int32_t>(9), 0};
  return plan(features, ground::GradedTerrain(std::move(level)), report);
}

}  // namespace citykiln::buildings
