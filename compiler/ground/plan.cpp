#include "compiler/ground/plan.h"

#include <algorithm>
#include <cmath>

#include "compiler/roads/expand.h"

namespace citykiln::ground {
namespace {

std::uint32_t whole_m2(double area_m2) {
  return static_cast<std::uint32_t>(std::min(std::floor(area_m2 + 0.5), 4.0e9));
}

Surface area_surface(const map::AreaFeature& area) {
  Surface surface{area.id, area.surface, whole_m2(area.area_m2), {area.polygon.outer}};
  surface.rings.insert(surface.rings.end(), area.polygon.holes.begin(), area.polygon.holes.end());
  return surface;
}

// A waterway as a road of water: the same stroke.
Surface water_surface(const map::Waterway& water) {
  return surface_of(roads::Road{water.id, water.axis, map::SurfaceClass::kRiver, water.width_m, true, true});
}

}  // namespace

std::vector<Surface> plan(const map::Features& features, Report& report) {
  std::vector<Surface> surfaces;
  Account areas, waters;
  for (const map::AreaFeature& area : features.areas) {
    ++areas.in, ++areas.out;
    surfaces.push_back(area_surface(area));
  }
  for (const map::Waterway& water : features.waterways) {
    ++waters.in;
    // a culvert or an aqueduct leaves the ground as it is
    if (water.passage != map::Passage::kGround) {
      report.drop(waters, Code::kWaterOffGround, water.id.osm, length_m(water.axis));
      continue;
    }
    ++waters.out;
    surfaces.push_back(water_surface(water));
  }
  report.account("ground", "area") = areas;
  report.account("ground", "waterway") = waters;
  std::sort(surfaces.begin(), surfaces.end(), [](const Surface& a, const Surface& b) { return a.id < b.id; });
  return surfaces;
}

Surface surface_of(const roads::Road& road) {
  // no area: a trimmed road must rank as the whole one does, so among equals its id decides
  return {road.id, road.surface, 0, roads::stroke(road)};
}

Surface trimmed_to(const Surface& surface, const Box2& box) {
  Surface trimmed{surface.id, surface.surface, surface.area_m2, {}};
  for (const Ring& ring : surface.rings)
    if (Ring kept = citykiln::trimmed_to(ring, box); !kept.empty()) trimmed.rings.push_back(std::move(kept));
  return trimmed;
}

}  // namespace citykiln::ground
