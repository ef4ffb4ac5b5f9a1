#include "compiler/props/plan.h"

#include <algorithm>

namespace citykiln::props {

Props plan(const map::Features& features, Report& report) {
  Props props;
  Account barriers, points;
  for (const map::Barrier& barrier : features.barriers) {
    ++barriers.in, ++barriers.out;
    props.barriers.push_back({barrier.id, barrier.axis, barrier.kind, barrier.height_m, barrier.width_m});
  }
  for (const map::PointFeature& point : features.points) {
    if (point.kind == map::PointKind::kTree) continue;                                                // plants/
    if (point.kind == map::PointKind::kEntrance || point.kind == map::PointKind::kAddress) continue;  // buildings/
    ++points.in;
    if (point.kind != map::PointKind::kStreetLamp) {
      report.drop(points, Code::kNotModelled, point.id.osm);
      continue;
    }
    ++points.out;
    props.lamps.push_back({point.id, point.at, point.height_m});
  }
  std::sort(props.barriers.begin(), props.barriers.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  std::sort(props.lamps.begin(), props.lamps.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  report.account("props", "barrier") = barriers;
  report.account("props", "point") = points;
  return props;
}

bool has_hedges(const Props& props) {
  return std::ranges::any_of(props.barriers, [](const Barrier& b) { return b.kind == map::BarrierKind::kHedge; });
}

}  // namespace citykiln::props
