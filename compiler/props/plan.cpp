#include "compiler/props/plan.h"

#include <algorithm>

namespace citykiln::props {
namespace {

// Trees are planned by plants/, doors by buildings/.
bool is_of_other_room(map::PointKind kind) {
  return kind == map::PointKind::kTree || kind == map::PointKind::kEntrance || kind == map::PointKind::kAddress;
}

}  // namespace

Props plan(const map::Features& features, Report& report) {
  Props props;
  Account barriers, points;
  for (const map::Barrier& barrier : features.barriers) {
    ++barriers.in, ++barriers.out;
    props.barriers.push_back({.id = barrier.id,
                              .axis = barrier.axis,
                              .kind = barrier.kind,
                              .height_m = barrier.height_m,
                              .width_m = barrier.width_m});
  }
  for (const map::PointFeature& point : features.points) {
    if (is_of_other_room(point.kind)) continue;
    ++points.in;
    if (point.kind != map::PointKind::kStreetLamp) {
      report.drop(points, Code::kNotModelled, point.id.osm);
      continue;
    }
    ++points.out;
    props.lamps.push_back({point.id, point.at, point.height_m});
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
