// An extract and its heightmap, read up to the ground's recipes.
#pragma once

#include <algorithm>
#include <string>

#include "compiler/ground/plan.h"
#include "compiler/map/heights/resample.h"
#include "compiler/map/locate.h"
#include "compiler/source/read_osm.h"
#include "compiler/source/read_raster.h"
#include "compiler/source/voids/fill_gaps.h"

namespace citykiln::ground {

struct RealGround {
  map::Features features;
  map::Heightfield heights;
  std::vector<LandCoverPolygon> surfaces;
  std::vector<roads::Strip> streams;
  std::vector<Polyline> covered;  ///< Culverts and aqueducts.
};

inline source::LonLatBox degrees_of(const Box2& extent, const map::Plane& plane) {
  source::LonLatBox box{180, 90, -180, -90};
  for (const Vec2 p : {extent.min, extent.max, Vec2{extent.min.x, extent.max.y}, Vec2{extent.max.x, extent.min.y}}) {
    const LonLat place = plane.backward(p);
    box = {std::min(box.west, place.lon_deg), std::min(box.south, place.lat_deg), std::max(box.east, place.lon_deg),
           std::max(box.north, place.lat_deg)};
  }
  return box;
}

/// Reads an extract and its heightmap.
/// @param dem  Empty: no heights.
inline Result<RealGround> read_real_ground(const std::string& path, const std::string& dem, Report& report) {
  const auto osm = source::read_osm(path, 0, report);
  if (!osm) return osm.error();
  const source::LonLatBox box = map::choose_box(*osm, {});
  const map::Plane plane(map::default_origin(box));
  RealGround ground{map::locate(*osm, plane, box, {}, report), {}, {}, {}, {}};
  std::vector<source::Raster> rasters;
  if (!dem.empty()) {
    const source::LonLatBox window = degrees_of(ground.features.extent, plane);
    const auto spec = source::parse_raster_spec(dem);
    if (!spec) return spec.error();
    auto raster = source::read_raster(*spec, &window);
    if (!raster) return raster.error();
    rasters.push_back(source::fill_voids(std::move(*raster), report));
  }
  auto heights = map::resample(rasters, plane, ground.features.extent, report);
  if (!heights) return heights.error();
  ground.heights = std::move(*heights);
  ground.surfaces = plan(ground.features, report);
  ground.streams = plan_streams(ground.features, report);
  ground.covered = covered_waterways(ground.features);
  return ground;
}

}  // namespace citykiln::ground
