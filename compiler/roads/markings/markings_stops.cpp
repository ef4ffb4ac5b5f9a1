// Stop and give-way lines at the end of a strip.
// Source: RMS-1: stop lines (StVO sign 294) 0.5 m wide; give-way lines (sign 341) dashes 0.5 m square, gaps 0.25 m.
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
