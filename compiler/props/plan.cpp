#include "compiler/props/plan.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "compiler/geometry/polygons/clip_polyline.h"
#include "compiler/map/plane/plane.h"
#include "compiler/props/mapped_kerbs.h"

namespace citykiln::props {
namespace {

// Trees are planned by plants/, doors by buildings/.
bool is_of_other_room(map::PointKind kind) {
  return kind == map::PointKind::kTree || kind == map::PointKind::kEntrance || kind == map::PointKind::kAddress;
}

// Barriers end this far outside of the extent, so that baking clips their whole width at its border. More than half the
// width of any barrier.
constexpr double kBeyondRegion_m = 4;

// Adds the parts of a barrier within the extent, each with a number.
void add_barrier(const map::Barrier& barrier, const Box2& extent, Props& props, Account& account, Report& report) {
  const bool counts = report.counts(barrier.id.osm);
  account.in += counts;
  const std::vector<Polyline> parts = clipped_to(barrier.axis, extent.widened(kBeyondRegion_m), map::kMapStep_m);
  if (parts.empty()) return report.drop(account, Code::kOutsideBounds, barrier.id.osm);
  if (counts) account.out += parts.size(), account.split += parts.size() - 1;
  for (std::uint32_t i = 0; i < parts.size(); ++i)
    props.barriers.push_back({.id = {barrier.id.osm, barrier.id.part + i},
                              .axis = parts[i],
                              .kind = barrier.kind,
                              .height_m = barrier.height_m,
                              .width_m = barrier.width_m,
                              .fence = barrier.fence});
}

}  // namespace

Props plan(const map::FeatureView& features, std::span<const roads::Road> roads, Report& report) {
  Props props;
  Account barriers, points;
  const std::vector<bool> are_of_streets = kerbs_of_streets(features.barriers, roads);
  for (std::size_t i = 0; i < features.barriers.size(); ++i) {
    const map::Barrier& barrier = features.barriers[i];
    if (!are_of_streets[i]) {
      add_barrier(barrier, features.extent, props, barriers, report);
    } else if (report.counts(barrier.id.osm)) {
      ++barriers.in, ++barriers.merged;
    }
  }
  for (const map::PointFeature& point : features.points) {
    if (is_of_other_room(point.kind)) continue;
    points.in += report.counts(point.id.osm);
    if (point.kind == map::PointKind::kShop) {
      points.without_body += report.counts(point.id.osm);
      continue;
    }
    points.out += report.counts(point.id.osm);
    props.lamps.push_back({.id = point.id, .at = point.at, .height_m = point.height_m, .light = point.lamp_tags});
  }
  std::ranges::sort(props.barriers, {}, &Barrier::id);
  std::ranges::sort(props.lamps, {}, &Lamp::id);
  report.account("props", "barrier") = barriers;
  report.account("props", "point") = points;
  return props;
}

bool has_hedges(const Props& props) {
  return std::ranges::any_of(props.barriers, [](const Barrier& b) { return b.kind == map::BarrierKind::kHedge; });
}

}  // namespace citykiln::props
