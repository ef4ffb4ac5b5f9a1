#include "compiler/roads/recipe.h"

#include <algorithm>
#include <cassert>

#include "compiler/geometry/snap.h"

namespace citykiln::roads {
namespace {

// The width of the outermost raised lanes of a kind. @param first,end  Lanes from an outer edge inwards.
template <typename Iterator, typename IsOutside>
double outer_width_m(Iterator first, Iterator end, IsOutside is_outside) {
  double width = 0;
  for (auto lane = first; lane != end && lane->is_raised && is_outside(*lane); ++lane) width += lane->width_m;
  return width;
}

template <typename IsOutside>
double outer_left_m(const Road& road, IsOutside is_outside) {
  return outer_width_m(road.section.lanes.begin(), road.section.lanes.end(), is_outside);
}

template <typename IsOutside>
double outer_right_m(const Road& road, IsOutside is_outside) {
  return outer_width_m(road.section.lanes.rbegin(), road.section.lanes.rend(), is_outside);
}

bool is_any_lane(const map::Lane&) { return true; }
bool is_verge(const map::Lane& lane) { return lane.kind == map::LaneKind::kVerge; }

}  // namespace

double left_m(const Road& road) { return road.section.axis_offset_m; }
double right_m(const Road& road) { return map::carriageway_width_m(road.section) - road.section.axis_offset_m; }

// A bound by the whole width is the same for all parts of a way: tiles agree.
double widest_left_m(const Road& road) { return road.section.axis_drift == 0 ? left_m(road) : width_m(road); }
double widest_right_m(const Road& road) { return road.section.axis_drift == 0 ? right_m(road) : width_m(road); }

double raised_left_m(const Road& road) { return outer_left_m(road, is_any_lane); }
double raised_right_m(const Road& road) { return outer_right_m(road, is_any_lane); }

double paved_left_m(const Road& road) { return raised_left_m(road) - outer_left_m(road, is_verge); }
double paved_right_m(const Road& road) { return raised_right_m(road) - outer_right_m(road, is_verge); }

std::vector<double> distances_along(const Polyline& axis, double start_along_m) {
  assert(!axis.empty());
  std::vector<double> along = {start_along_m};
  for (std::size_t i = 0; i + 1 < axis.size(); ++i)
    along.push_back(along.back() + snapped(distance(axis[i], axis[i + 1])));
  return along;
}

std::vector<double> distances_along(const Road& road) { return distances_along(road.axis, road.start_along_m); }

double max_offset_m(const Road& road) {
  // the mitre of a bend under a right angle lies within 1.42 half widths
  return 1.5 * std::max(widest_left_m(road) + raised_left_m(road), widest_right_m(road) + raised_right_m(road));
}

Strip carriageway_of(const Road& road) {
  assert(road.section.axis_drift == 0);
  return {.id = road.id, .axis = road.axis, .surface = road.surface, .left_m = left_m(road), .right_m = right_m(road)};
}

}  // namespace citykiln::roads
