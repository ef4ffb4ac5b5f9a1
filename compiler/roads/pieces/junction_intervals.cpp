// Where junctions lie along roads, and how traffic is controlled there.
#include <algorithm>

#include "compiler/roads/junctions/through_road.h"
#include "compiler/roads/pieces/stretches.h"

namespace citykiln::roads {
namespace {

using map::TrackPointKind;

// A sign or signal up to this far before a junction belongs to it.
constexpr double kSign_m = 20;

std::optional<Control> control_of(TrackPointKind kind) {
  if (kind == TrackPointKind::kSignals) return Control::kSignals;
  if (kind == TrackPointKind::kStop) return Control::kStop;
  return kind == TrackPointKind::kGiveWay ? std::optional(Control::kGiveWay) : std::nullopt;
}

// The control tagged along the arm for traffic towards the junction.
std::optional<Control> posted(const Road& road, const std::vector<double>& along, const Arm& arm, double cut_m) {
  for (const map::TrackPoint& point : road.points) {
    const auto control = control_of(point.kind);
    const double out_m = (along[point.vertex] - along[arm.vertex]) * arm.step;
    const bool is_here = out_m >= 0 && out_m <= cut_m + kSign_m;
    if (control && is_here && point.facing != arm.step) return control;
  }
  return std::nullopt;
}

// Without signs the minor road gives way, and every road gives way to a roundabout. Ramps merge; service roads have no
// lines.
Control usual(const Road& road, const Road& main) {
  if (main.is_roundabout && !road.is_roundabout) return Control::kGiveWay;
  const bool is_paint = priority_of(road) >= map::values_of(map::LandCoverClass::kResidentialRoad).priority;
  return is_paint && !road.is_link && priority_of(road) < priority_of(main) ? Control::kGiveWay : Control::kNone;
}

// The length of the arm inside the junction.
double taken_m(const Road& road, const std::vector<double>& along, const Arm& arm, const Cut& cut,
               const Junction& junction) {
  if (cut.length_m != kWholeLink_m) return cut.length_m;
  return std::abs(along[end_of_link(road, arm, junction.nodes)] - along[arm.vertex]);
}

void add_arm(JunctionInterval arm_gap, std::vector<JunctionInterval>& intervals) {
  const auto same = std::ranges::find(intervals, arm_gap.at_m, &JunctionInterval::at_m);
  if (same == intervals.end()) return intervals.push_back(arm_gap);
  same->before_m = std::max(same->before_m, arm_gap.before_m), same->after_m = std::max(same->after_m, arm_gap.after_m);
  same->is_change = same->is_change && arm_gap.is_change;
  same->before = std::max(same->before, arm_gap.before), same->after = std::max(same->after, arm_gap.after);
}

}  // namespace

std::vector<std::vector<JunctionInterval>> junction_intervals_of(std::span<const Road> roads,
                                                                 std::span<const Junction> junctions) {
  std::vector<std::vector<JunctionInterval>> intervals(roads.size());
  const std::vector<std::vector<Arm>> arms = arms_of(junctions, roads);
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    const bool is_complete = junctions[j].family == Family::kStreet && arms[j].size() == junctions[j].cuts.size();
    if (!is_complete || arms[j].empty()) continue;
    const Road& main = main_road(roads, arms[j]);
    const bool signals = has_signals(roads, arms[j]), is_passed = has_through_road(junctions[j], roads, arms[j]);
    for (std::size_t a = 0; a < arms[j].size(); ++a) {
      const Arm& arm = arms[j][a];
      const Road& road = roads[arm.road];
      if (is_passed && priority_of(road) == priority_of(main)) continue;
      const std::vector<double> along = distances_along(road);
      const double taken = taken_m(road, along, arm, junctions[j].cuts[a], junctions[j]);
      Control control = posted(road, along, arm, taken).value_or(usual(road, main));
      if (signals) control = Control::kSignals;
      JunctionInterval gap{along[arm.vertex]};
      gap.is_change = arms[j].size() == 2;
      (arm.step > 0 ? gap.after_m : gap.before_m) = taken;
      (arm.step > 0 ? gap.after : gap.before) = control;
      add_arm(gap, intervals[arm.road]);
    }
  }
  for (std::vector<JunctionInterval>& list : intervals) std::ranges::sort(list, {}, &JunctionInterval::at_m);
  return intervals;
}

}  // namespace citykiln::roads
