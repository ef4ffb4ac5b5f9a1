// The located features of an extract, for tests of roads.
#pragma once

#include <string>

#include "compiler/map/locate.h"
#include "compiler/source/read_osm.h"

namespace citykiln::roads {

struct RealMap {
  LonLat origin;  ///< Origin of the plane.
  map::Features features;
};

inline Result<RealMap> read_real_map(const std::string& path, Report& report) {
  const auto osm = source::read_osm(path, 0, report);
  if (!osm) return osm.error();
  const source::LonLatBox box = map::choose_box(*osm, {});
  const LonLat origin = map::default_origin(box);
  return RealMap{origin, map::locate(*osm, map::Plane(origin), box, {}, report)};
}

}  // namespace citykiln::roads
