#include "compiler/vacant/street_plots.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/line_part.h"
#include "compiler/geometry/oriented_rect.h"
#include "compiler/vacant/ground_cover.h"
#include "compiler/vacant/plot_parts.h"

namespace citykiln::vacant {
namespace {

using lots::LotKind;
using map::LandCoverClass;

constexpr double kFrontage_m = 24, kDepth_m = 22;
// A plot has straight frontage if its chord is at least this share of it.
constexpr double kStraight = 0.985;
constexpr double kLeastLeftOver = 0.6;
// The plot begins below the edge of the pavement.
constexpr double kBelowPavement_m = 0.25;
// Grass stays at the rear of paved plots.
constexpr double kGrassRim_m = 2;
// Unmapped land is a town's if a building stands within this distance.
constexpr double kTown_m = 30;
// The share of green where nothing is mapped about a plot, in industry and elsewhere.
constexpr double kUsualInIndustry = 0.1, kUsualGreen = 0.5;
constexpr double kRimOfGrass = 6, kRimOfPaved = 4, kInsideGrass = 0.05;

struct PlotRow {
  LandCoverClass use;
  double if_grey, if_green;
  LotKind kind;
  LandCoverClass surface;
};
constexpr PlotRow kPlotRows[] = {
#define PLOT(use, if_grey, if_green, kind, surface) \
  {LandCoverClass::use, if_grey, if_green, LotKind::kind, LandCoverClass::surface},
#include "compiler/vacant/plot_kinds.inc"
};

const PlotRow* drawn_row(LandCoverClass use, double green, double drawn) {
  const auto weight = [&](const PlotRow& row) { return std::lerp(row.if_grey, row.if_green, green); };
  double sum = 0;
  for (const PlotRow& row : kPlotRows)
    if (row.use == use) sum += weight(row);
  double left = drawn * sum;
  const PlotRow* last = nullptr;
  for (const PlotRow& row : kPlotRows) {
    if (row.use != use) continue;
    last = &row;
    if ((left -= weight(row)) < 0) return last;
  }
  return last;
}

// The rectangle beside a stretch of a road; none where the road bends.
std::optional<PlotRectangle> rectangle_beside(const roads::Road& road, const std::vector<double>& along, double from_m,
                                              bool is_left) {
  const Vec2 a = point_at(road.axis, along, from_m), b = point_at(road.axis, along, from_m + kFrontage_m);
  if (distance(a, b) < kStraight * kFrontage_m) return std::nullopt;
  const Vec2 ahead = unit(b - a), outward = left_of(ahead) * (is_left ? 1.0 : -1.0);
  const double off_m = is_left ? roads::widest_left_m(road) + roads::raised_left_m(road)
                               : roads::widest_right_m(road) + roads::raised_right_m(road);
  return PlotRectangle{.corner = (is_left ? a : b) + outward * (off_m - kBelowPavement_m),
                       .along = is_left ? ahead : ahead * -1.0,
                       .back = outward,
                       .width_m = distance(a, b),
                       .depth_m = kDepth_m};
}

bool is_in_town(const PlotInputs& inputs, Vec2 p) {
  const int buildings = map::values_of(LandCoverClass::kBuilding).priority;
  return ground::clearance_m(inputs.land_cover, p, buildings, kTown_m) < kTown_m;
}

struct StreetPlotter {
  const PlotInputs& inputs;
  Plots& plots;
  std::vector<OrientedRect> taken{};
  std::uint32_t number = 0;

  bool is_apart(const OrientedRect& rect) const {
    return std::ranges::none_of(taken, [&](const OrientedRect& other) {
      return distance(rect.at, other.at) < 2 * kFrontage_m && overlap(rect, other, 0.5);
    });
  }

  void add(const roads::Road& road, const PlotRectangle& r, std::uint32_t station) {
    if (!is_in_tile(inputs, ring_of(r))) return;
    const LeftOver ground = left_over_of(inputs, r.corner, r.along * r.width_m, r.back * r.depth_m);
    if (ground.share < kLeastLeftOver) return;
    if (ground.use == LandCoverClass::kUnknown && !is_in_town(inputs, r.centre())) return;
    const OrientedRect rect{r.centre(), r.back, r.depth_m, r.width_m};
    if (!is_apart(rect)) return;
    const bool is_industry = map::values_of(ground.use).group == map::LandCoverGroup::kIndustry;
    const double usual = is_industry ? kUsualInIndustry : kUsualGreen;
    const double green = green_share_about(inputs, r.centre()).value_or(usual);
    // neighbours are alike
    const RandomSequence draw(inputs.seed, stable_id(stable_id(road.id), "plot", station / 2), "kind");
    const PlotRow* row = drawn_row(ground.use, green, draw.unit(0));
    if (row == nullptr) return;
    taken.push_back(rect);
    add_plot(road, r, ground, *row);
  }

  void add_plot(const roads::Road& road, const PlotRectangle& r, const LeftOver& ground, const PlotRow& row) {
    const bool is_mapped = ground.area != ObjectId{};
    const ObjectId owner{is_mapped ? ground.area.osm : road.id.osm, ++number};
    plots.grounds.push_back(ground_of(r, owner, row.kind, road.country));
    const bool is_paved = row.surface != LandCoverClass::kUnknown;
    add_bushes(inputs, r, derived_id({owner.osm, 0}, number), is_paved ? kRimOfPaved : kRimOfGrass,
               is_paved ? 0 : kInsideGrass, plots);
    if (!is_paved) return;
    PlotRectangle paved = r;
    paved.depth_m -= kGrassRim_m;
    plots.surfaces.push_back(surface_on(row.surface, derived_id({owner.osm, 0}, 0), ground.priority, {ring_of(paved)}));
  }
};

bool has_plots(const roads::Road& road) {
  return map::is_street(road.surface) && road.surface != LandCoverClass::kMotorwayRoad && !road.is_link;
}

}  // namespace

void add_street_plots(const PlotInputs& inputs, Plots& plots) {
  StreetPlotter plotter{inputs, plots};
  for (const roads::Road& road : inputs.roads) {
    if (!has_plots(road)) continue;
    const std::vector<double> along = roads::distances_along(road);
    auto station = static_cast<std::uint32_t>(std::ceil(along.front() / kFrontage_m));
    for (; (station + 1) * kFrontage_m <= along.back(); ++station)
      for (const bool is_left : {true, false})
        if (const auto r = rectangle_beside(road, along, station * kFrontage_m, is_left))
          plotter.add(road, *r, station);
  }
}

}  // namespace citykiln::vacant
