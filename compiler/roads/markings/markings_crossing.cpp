// Pedestrian crossings. Source: StVO sign 293 and R-FGÜ: bars 0.5 m, gaps 0.5 m; RMS-1: signal-controlled crossings
// between two broken narrow lines, dashes 0.5 m, gaps 0.2 m.
#include <cmath>

#include "compiler/roads/markings/marking_rules.h"
#include "compiler/roads/markings/markings_parts.h"

namespace citykiln::roads {

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

}  // namespace citykiln::roads
