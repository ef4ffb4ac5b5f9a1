#include "compiler/vacant/area_plots.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/countries/country_group.h"
#include "compiler/vacant/ground_cover.h"
#include "compiler/vacant/plot_parts.h"

namespace citykiln::vacant {
namespace {

using map::LandCoverClass;

// Plots of allotments: 250 to 400 m2 in Germany (Bundeskleingartengesetz, paragraph 3), 250 m2 in Britain; smaller ones
// are usual in towns.
constexpr double kAllotment_m = 11, kAllotmentDepth_m = 18, kAlley_m = 1.5;
constexpr double kHedgeBushes = 12, kInsideAllotment = 0.5;
constexpr double kBedPercent = 60;
constexpr double kLeastSite_m2 = 150;
constexpr int kMostRows = 60;

map::CountryGroup country_of(const PlotInputs& inputs) {
  return inputs.roads.empty() ? map::CountryGroup{} : inputs.roads.front().country;
}

// The longest edge of a ring: its begin and direction.
PlotRectangle frame_along_longest(const Ring& ring) {
  PlotRectangle frame;
  double longest_m = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if (distance(a, b) <= longest_m) continue;
    longest_m = distance(a, b);
    frame.corner = a, frame.along = unit(b - a), frame.back = left_of(unit(b - a));
  }
  return frame;
}

bool is_all_of(const PlotInputs& inputs, const PlotRectangle& r, const ground::LandCoverPolygon& area) {
  for (const double x : {0.0, 0.5, 1.0})
    for (const double y : {0.0, 0.5, 1.0}) {
      const ground::LandCoverPolygon* cover = cover_at(inputs, r.at(x * r.width_m, y * r.depth_m));
      if (cover == nullptr || cover->id != area.id) return false;
    }
  return true;
}

void add_allotment(const PlotInputs& inputs, const PlotRectangle& r, const ground::LandCoverPolygon& area,
                   std::uint32_t number, Plots& plots) {
  PlotRectangle with_alley = r;
  with_alley.corner = r.at(0, -kAlley_m), with_alley.depth_m += kAlley_m;
  if (!is_in_tile(inputs, ring_of(with_alley)) || !is_all_of(inputs, r, area)) return;
  const ObjectId id{area.id.osm, number};
  const RandomSequence draw(inputs.seed, stable_id(id), "allotment");
  plots.grounds.push_back(ground_of(r, id, lots::LotKind::kAllotment, country_of(inputs)));
  const int priority = map::values_of(area.surface).priority;
  const ObjectId part = derived_id({area.id.osm, 0}, 0);
  PlotRectangle alley = r;
  alley.corner = r.at(0, -kAlley_m), alley.depth_m = kAlley_m;
  plots.surfaces.push_back(surface_on(LandCoverClass::kGravelDrive, part, priority, {ring_of(alley)}));
  if (100 * draw.unit(0) < kBedPercent) {
    PlotRectangle bed = r;
    bed.corner = r.at(1.2, draw.unit(1) < 0.5 ? 1.2 : 0.5 * r.depth_m);
    bed.width_m -= 2.4 + 3 * draw.unit(2), bed.depth_m = (0.35 + 0.1 * draw.unit(3)) * r.depth_m;
    plots.surfaces.push_back(surface_on(LandCoverClass::kEarthYard, part, priority, {ring_of(bed)}));
  }
  add_bushes(inputs, r, derived_id({area.id.osm, 0}, number), kHedgeBushes, kInsideAllotment, plots);
}

void add_rows(const PlotInputs& inputs, const ground::LandCoverPolygon& area, Plots& plots) {
  const PlotRectangle frame = frame_along_longest(area.rings.front());
  const double row_m = kAllotmentDepth_m + kAlley_m;
  std::uint32_t number = 0;
  for (int row = -kMostRows; row < kMostRows; ++row)
    for (int column = -kMostRows; column < kMostRows; ++column) {
      ++number;
      PlotRectangle r = frame;
      r.corner = frame.at(column * kAllotment_m + 1, row * row_m + kAlley_m);
      r.width_m = kAllotment_m, r.depth_m = kAllotmentDepth_m;
      if (inputs.tile.contains(r.centre())) add_allotment(inputs, r, area, number, plots);
    }
}

}  // namespace

void add_allotment_plots(const PlotInputs& inputs, Plots& plots) {
  for (const ground::LandCoverPolygon& area : inputs.areas)
    if (area.surface == LandCoverClass::kAllotments && !area.rings.empty()) add_rows(inputs, area, plots);
}

void add_sites(const PlotInputs& inputs, Plots& plots) {
  for (const ground::LandCoverPolygon& area : inputs.areas) {
    if (area.surface != LandCoverClass::kConstruction || area.rings.empty() || area.area_m2 < kLeastSite_m2) continue;
    const PlotRectangle frame = frame_along_longest(area.rings.front());
    lots::Yard site = ground_of(frame, area.id, lots::LotKind::kSite, country_of(inputs));
    site.polygon = {area.rings.front(), {area.rings.begin() + 1, area.rings.end()}};
    plots.grounds.push_back(std::move(site));
  }
}

}  // namespace citykiln::vacant
