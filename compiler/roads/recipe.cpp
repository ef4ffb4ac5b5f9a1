#include "compiler/roads/recipe.h"

#include <algorithm>

#include "compiler/geometry/snap.h"

namespace citykiln::roads {
namespace {

// @param lanes  From an outer edge inwards.
double raised_before_kerb_m(const std::vector<map::Lane>& lanes) {
  double width = 0;
  for (const map::Lane& lane : lanes) {
    if (!lane.is_raised) break;
    width += lane.width_m;
  }
  return width;
}

double verges_before_pavement_m(const std::vector<map::Lane>& lanes) {
  double width = 0;
  for (const map::Lane& lane : lanes) {
    if (!lane.is_raised || lane.kind != map::LaneKind::kVerge) break;
    width += lane.width_m;
  }
  return width;
}

std::vector<map::Lane> from_the_right(const Road& road) {
  return {road.section.lanes.rbegin(), road.section.lanes.rend()};
}

}  // namespace

double left_m(const Road& road) { return road.section.axis_offset_m; }
double right_m(const Road& road) { return map::carriageway_width_m(road.section) - road.section.axis_offset_m; }

double raised_left_m(const Road& road) { return raised_before_kerb_m(road.section.lanes); }
double raised_right_m(const Road& road) { return raised_before_kerb_m(from_the_right(road)); }

double paved_left_m(const Road& road) { return raised_left_m(road) - verges_before_pavement_m(road.section.lanes); }
double paved_right_m(const Road& road) { return raised_right_m(road) - verges_before_pavement_m(from_the_right(road)); }

std::vector<double> distances_along(const Polyline& axis, double start_along_m) {
  std::vector<double> along = {start_along_m};
  for (std::size_t i = 0; i + 1 < axis.size(); ++i)
    along.push_back(along.back() + snapped(distance(axis[i], axis[i + 1])));
  return along;
}

std::vector<double> distances_along(const Road& road) { return distances_along(road.axis, road.start_along_m); }

double max_offset_m(const Road& road) {
  // the mitre of a bend under a right angle lies within 1.42 half widths
  return 1.5 * std::max(left_m(road) + raised_left_m(road), right_m(road) + raised_right_m(road));
}

Strip carriageway_of(const Road& road) { return {road.id, road.axis, road.surface, left_m(road), right_m(road)}; }

}  // namespace citykiln::roads
