// Marks across the road: zebras, crossings with signals, stop and give-way lines.
// Source: StVO sign 293 and R-FGÜ: bars 0.5 m, gaps 0.5 m. RMS-1: crossings with signals between two broken narrow
// lines, dashes 0.5 m, gaps 0.2 m; stop lines (StVO sign 294) 0.5 m wide; give-way lines (sign 341) dashes 0.5 m
// square, gaps 0.25 m. MUTCD 3B.16 and 3B.18: triangles 0.3 to 0.6 m wide and half as high again, crossings between
// solid lines of 0.15 to 0.6 m.
#include <algorithm>
#include <cmath>

#include "compiler/roads/markings/marking_rules.h"
#include "compiler/roads/markings/markings_parts.h"

namespace citykiln::roads {
namespace {

constexpr double kStopLine_m = 0.5;
constexpr DashPattern kGiveWayLine = {0.5, 0.75};
constexpr double kYieldBase_m = 0.6, kYieldHeight_m = 0.9, kYieldPeriod_m = 0.9;
constexpr double kCrossingLine_m = 0.3;

bool stops(const map::Lane& lane) { return is_driven(lane) || lane.kind == map::LaneKind::kCycle; }

// Triangles that point to the traffic which gives way.
void add_yield_triangles(LaneSpan span, Marks& marks) {
  const double count = std::max(1.0, std::floor((span.high_m - span.low_m) / kYieldPeriod_m)),
               first_m = (span.low_m + span.high_m - count * kYieldPeriod_m) / 2;
  for (double i = 0; i < count; ++i) {
    const double middle_m = first_m + (i + 0.5) * kYieldPeriod_m;
    marks.push_back({{{middle_m - kYieldBase_m / 2, kLayoutLength_m},
                      {middle_m, kLayoutLength_m - kYieldHeight_m},
                      {middle_m + kYieldBase_m / 2, kLayoutLength_m}},
                     kWhite});
  }
}

void add_stop_line(LaneSpan span, const MarkingLayout& layout, Marks& marks) {
  const double low_m = kLayoutLength_m - kStopLine_m;
  if (layout.control != Control::kGiveWay)
    marks.push_back({rectangle({span.low_m, low_m}, {span.high_m, kLayoutLength_m}), kWhite});
  else if (layout.practice == MarkingPractice::kAmerican)
    add_yield_triangles(span, marks);
  else
    add_dashes_across(span.low_m, span.high_m, low_m, kLayoutLength_m, kGiveWayLine, marks);
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
  if (layout.practice == MarkingPractice::kAmerican) {
    const double across_m = width_m(layout);
    marks.push_back({rectangle({0, 0}, {across_m, kCrossingLine_m}), kWhite});
    marks.push_back({rectangle({0, kCrossingLength_m - kCrossingLine_m}, {across_m, kCrossingLength_m}), kWhite});
    return;
  }
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
    if (run.low_m < run.high_m) add_stop_line(run, layout, marks);
    run = span;
  }
}

}  // namespace citykiln::roads
