// Parking bays: along the kerb, slanted or square to it (bay_rows.h).
#include "compiler/roads/markings/bay_rows.h"
#include "compiler/roads/markings/marking_rules.h"
#include "compiler/roads/markings/markings.h"
#include "compiler/roads/markings/markings_parts.h"

namespace citykiln::roads {
namespace {

using map::Lane;
using map::LaneDirection;

// True where a row has marked bays: not along the kerb of a quiet street, except where the strip is a car park of its
// own.
bool has_bays(const MarkingLayout& layout, const Lane& lane) {
  if (lane.kind != map::LaneKind::kParking) return false;
  return !bays_of(lane, layout.side).is_along || !is_quiet(layout) || layout.surface == map::LandCoverClass::kParking;
}

void add_bays_of(double left_m, double right_m, const BayRow& bays, double line_m, Marks& marks) {
  for (double v_m = 0; v_m < kLayoutLength_m - bays.step_m / 2; v_m += bays.step_m) {
    const double low_m = v_m - (line_m + bays.rise_m) / 2, high_m = low_m + line_m;
    marks.push_back(
        {{{left_m, low_m}, {right_m, low_m + bays.rise_m}, {right_m, high_m + bays.rise_m}, {left_m, high_m}}, kWhite});
  }
}

// The line on the traffic side, where the direction of traffic is known.
void add_bays_edge(const Lane& lane, double left_m, double right_m, map::DrivingSide side, double line_m,
                   Marks& marks) {
  if (lane.way == LaneDirection::kBoth) return;
  const bool is_left = (lane.way == LaneDirection::kForward) == (side == map::DrivingSide::kRight);
  add_line(is_left ? left_m + line_m / 2 : right_m - line_m / 2, line_m, kSolid, marks);
}

}  // namespace

void add_bays(const MarkingLayout& layout, Marks& marks) {
  const double line_m = measures_of(layout).narrow_m;
  const std::vector<double> sides_m = lane_sides_m(layout);
  for (std::size_t i = 0; i < layout.lanes.size(); ++i) {
    const Lane& lane = layout.lanes[i];
    if (!has_bays(layout, lane)) continue;
    const BayRow bays = bays_of(lane, layout.side);
    add_bays_of(sides_m[i], sides_m[i + 1], bays, line_m, marks);
    add_bays_edge(lane, sides_m[i], sides_m[i + 1], layout.side, line_m, marks);
    if (layout.stretch != StretchKind::kEnd) continue;
    const double rise_m = bays.rise_m < 0 ? -bays.rise_m : bays.rise_m;
    const Vec2 low = {sides_m[i], kLastBayEnds_m + (line_m + rise_m) / 2}, high = {sides_m[i + 1], kLayoutLength_m};
    marks.push_back({rectangle(low, high), base_colour_of(layout)});
  }
}

}  // namespace citykiln::roads
