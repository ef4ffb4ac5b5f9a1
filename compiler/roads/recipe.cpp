#include "compiler/roads/recipe.h"

#include <algorithm>

namespace citykiln::roads {
namespace {

template <typename Lanes>
double raised_before_kerb_m(const Lanes& lanes) {
  double width = 0;
  for (const map::Lane& lane : lanes) {
    if (!lane.is_raised) break;
    width += lane.width_m;
  }
  return width;
}

}  // namespace

double left_m(const Road& road) { return road.section.axis_offset_m; }
double right_m(const Road& road) { return map::carriageway_width_m(road.section) - road.section.axis_offset_m; }

double raised_left_m(const Road& road) { return raised_before_kerb_m(road.section.lanes); }
double raised_right_m(const Road& road) {
  return raised_before_kerb_m(std::vector(road.section.lanes.rbegin(), road.section.lanes.rend()));
}

double breadth_m(const Road& road) {
  // a mitre of less than a right angle lies within 1.42 of what it bends
  return 1.5 * std::max(left_m(road) + raised_left_m(road), right_m(road) + raised_right_m(road));
}

Strip carriageway_of(const Road& road) { return {road.id, road.axis, road.surface, left_m(road), right_m(road)}; }

}  // namespace citykiln::roads
