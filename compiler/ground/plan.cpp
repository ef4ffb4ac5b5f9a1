#include "compiler/ground/plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/snap.h"
#include "compiler/ground/cover/contained_areas.h"
#include "compiler/ground/water/grown_widths.h"
#include "compiler/roads/generate.h"

namespace citykiln::ground {
namespace {

// Narrower watercourses are streams.
constexpr double kNarrowestRiver_m = 5;

std::uint32_t whole_m2(double area_m2) {
  return static_cast<std::uint32_t>(std::min(std::floor(area_m2 + 0.5), 4.0e9));
}

}  // namespace

LandCoverPolygon surface_of(const map::AreaFeature& area) {
  LandCoverPolygon surface{.id = area.id,
                           .surface = area.surface,
                           .area_m2 = whole_m2(area.area_m2),
                           .rings = {area.polygon.outer},
                           .row_heading = area.row_heading};
  surface.rings.insert(surface.rings.end(), area.polygon.holes.begin(), area.polygon.holes.end());
  return surface;
}

std::vector<LandCoverPolygon> plan(const map::FeatureView& features, Report& report) {
  std::vector<LandCoverPolygon> surfaces;
  Account account;
  for (const map::AreaFeature& area : features.areas) {
    // fields are no elements of the map: each region divides the land that it needs
    const bool is_counted = !is_of_field(area.id) && report.counts(area.id.osm);
    account.in += is_counted, account.out += is_counted;
    surfaces.push_back(surface_of(area));
  }
  report.account("ground", "area") = account;
  return with_contained_on_top(std::move(surfaces));
}

std::vector<roads::Strip> plan_streams(const map::FeatureView& features, Report& report) {
  std::vector<roads::Strip> streams;
  Account account;
  const std::vector<double> widths_m = grown_widths_m(features.waterways, features.extent);
  for (std::size_t i = 0; i < features.waterways.size(); ++i) {
    const map::Waterway& water = features.waterways[i];
    account.in += report.counts(water.id.osm);
    // a culvert or an aqueduct does not cover the ground
    if (water.passage != map::Passage::kGround) {
      report.drop(account, Code::kWaterOffGround, water.id.osm, length_m(water.axis));
      continue;
    }
    account.out += report.counts(water.id.osm);
    // sides are on the grid of the plane: half of a width may not be
    const double left_m = snapped(widths_m[i] / 2);
    const map::LandCoverClass surface =
        widths_m[i] < kNarrowestRiver_m ? map::LandCoverClass::kStream : map::LandCoverClass::kRiver;
    streams.push_back({water.id, water.axis, surface, left_m, widths_m[i] - left_m});
  }
  report.account("ground", "waterway") = account;
  return streams;
}

std::vector<Polyline> covered_waterways(const map::FeatureView& features) {
  std::vector<Polyline> covered;
  for (const map::Waterway& water : features.waterways)
    if (water.passage != map::Passage::kGround) covered.push_back(water.axis);
  return covered;
}

}  // namespace citykiln::ground
