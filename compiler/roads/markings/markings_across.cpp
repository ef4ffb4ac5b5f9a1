// Marks across the road: zebras, crossings with signals, stop and give-way lines.
// Source: StVO sign 293 and R-FGÜ: bars 0.5 m, gaps 0.5 m. RMS-1: crossings with signals between two broken narrow
// lines, dashes 0.5 m, gaps 0.2 m; stop lines (StVO sign 294) 0.5 m wide; give-way lines (sign 341) dashes 0.5 m
// square, gaps 0.25 m.
#include <cmath>

#include "compiler/roads/markings/marking_rules.h"
#include "compiler/roads/markings/markings_parts.h"

namespace citykiln::roads {
namespace {

constexpr double kStopLine_m = 0.5;
constexpr DashPattern kGiveWayLine = {0.5, 0.75};

bool stops(const map::Lane& lane) { return is_driven(lane) || lane.kind == map::LaneKind::kCycle; }

void add_stop_line(LaneSpan span, Control control, Marks& marks) {
  const double low_m = kLayoutLength_m - kStopLine_m;
  if (control == Control::kGiveWay)
    add_dashes_across(span.low_m, span.high_m, low_m, kLayoutLength_m, kGiveWayLine, marks);
  else
    marks.push_back({rectangle({span.low_m, low_m}, {span.high_m, kLayoutLength_m}), kWhite});
}

}  // namespace

void add_zebra(const MarkingLayout& layout, Marks& marks) {
  constexpr double kBar_m = 0.5, kPeriod_m = 1;
  const double across_m = width_m(layout), bar_m = std::min(kBar_m, across_m);
  const double count = 1 + std::floor((across_m - bar_m) / kPeriod_m);
  const double first_m = (across_m - bar_m - (count - 1) * kPeriod_m) / 2;
  for (double i = 0; i < count; ++i) {
    const double left_m = first_m + i * kPeriod_m;
    marks.push_back({rectangle({left_m, 0}, {left_m + bar_m, kCrossingLength_m}), kWhite});
  }
}

void add_crossing(const MarkingLayout& layout, Marks& marks) {
  constexpr DashPattern kDashes = {0.5, 0.7};
  const double line_m = measures_of(layout).narrow_m;
  add_dashes_across(0, width_m(layout), 0, line_m, kDashes, marks);
  add_dashes_across(0, width_m(layout), kCrossingLength_m - line_m, kCrossingLength_m, kDashes, marks);
}

void add_stop_lines(const MarkingLayout& layout, Marks& marks) {
  if (layout.control == Control::kNone) return;
  // one line across each run of adjacent arriving lanes
  LaneSpan run{0, 0};
  for (std::size_t i = 0; i <= layout.lanes.size(); ++i) {
    const bool is_lane = i < layout.lanes.size() && stops(layout.lanes[i]);
    const LaneSpan span = is_lane ? arriving_span(layout, i) : LaneSpan{0, 0};
    const bool goes_on = run.low_m < run.high_m && span.low_m < span.high_m && span.low_m == run.high_m;
    if (goes_on) {
      run.high_m = span.high_m;
      continue;
    }
    if (run.low_m < run.high_m) add_stop_line(run, layout.control, marks);
    run = span;
  }
}

}  // namespace citykiln::roads
