#include "compiler/furniture/stations.h"

#include <cmath>
#include <optional>

#include "compiler/geometry/line_part.h"
#include "compiler/roads/width_limits/narrowed_section.h"

namespace citykiln::furniture {
namespace {

using map::Lane;
using map::LaneKind;

bool is_pavement(const Lane& lane) { return lane.is_raised && lane.kind == LaneKind::kSidewalk; }

// A pavement: off_m is the distance of its inner edge from the axis, positive to the left.
struct PavementEdge {
  double off_m = 0, width_m = 0, verge_m = 0;
};

// The first run of pavement lanes from the kerb outwards, on one side.
std::optional<PavementEdge> pavement_at(const roads::Road& road, double along_m, bool is_left) {
  const roads::NarrowedSection section = roads::narrowed_section_at(road, along_m);
  const std::vector<Lane>& lanes = road.section.lanes;
  double edge_m = section.left_m;
  std::optional<PavementEdge> found;
  bool was_level = false;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const double from_m = edge_m;
    edge_m -= section.widths_m[i];
    was_level |= !lanes[i].is_raised;
    if (!is_pavement(lanes[i]) || was_level == is_left) continue;
    const std::size_t inner = is_left ? i + 1 : i - 1;
    const bool has_verge = inner < lanes.size() && lanes[inner].kind == LaneKind::kVerge;
    const double verge_m = has_verge ? section.widths_m[inner] : 0;
    if (is_left)
      found = PavementEdge{edge_m, section.widths_m[i], verge_m};
    else if (!found)
      found = PavementEdge{from_m, section.widths_m[i], verge_m};
  }
  return found;
}

bool has_pavement(const roads::Road& road) {
  return map::is_street(road.surface) && std::ranges::any_of(road.section.lanes, is_pavement);
}

}  // namespace

std::vector<Station> stations_along(const roads::Road& road, const Box2& box, double step_m) {
  std::vector<Station> stations;
  const Box2 about = box.widened(kStationStep_m);
  if (!has_pavement(road) || !box_of(road.axis).widened(roads::max_offset_m(road)).touches(about)) return stations;
  const std::vector<double> along = roads::distances_along(road);
  const auto first = static_cast<std::int64_t>(std::ceil(along.front() / step_m));
  for (std::int64_t k = first; static_cast<double>(k) * step_m < along.back(); ++k) {
    const double at_m = static_cast<double>(k) * step_m;
    const Vec2 at = point_at(road.axis, along, at_m);
    if (!about.widened(roads::max_offset_m(road)).contains(at)) continue;
    const Vec2 ahead = unit(point_at(road.axis, along, std::min(at_m + 1, along.back())) - at);
    if (ahead == Vec2{}) continue;
    for (const bool is_left : {true, false}) {
      const std::optional<PavementEdge> edge = pavement_at(road, at_m, is_left);
      if (!edge || edge->width_m < kFreeWidth_m) continue;
      const Vec2 inner_edge = at + left_of(ahead) * edge->off_m;
      if (!about.contains(inner_edge)) continue;
      const StableId side = stable_id(stable_id(road.id), is_left ? "left pavement" : "right pavement", 0);
      stations.push_back({.key = stable_id(side, "station", static_cast<std::uint64_t>(k)),
                          .inner_edge = inner_edge,
                          .outward = left_of(ahead) * (is_left ? 1.0 : -1.0),
                          .traffic = map::flows_back(road.section, road.side, is_left) ? ahead * -1.0 : ahead,
                          .room_m = edge->width_m,
                          .verge_m = edge->verge_m,
                          .side = side,
                          .number = static_cast<std::uint32_t>(2 * k + (is_left ? 0 : 1))});
    }
  }
  return stations;
}

}  // namespace citykiln::furniture
