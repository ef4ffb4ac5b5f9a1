// Parking bays: along the kerb, angled or perpendicular, by the depth of the row.
#include "compiler/roads/markings/marking_rules.h"
#include "compiler/roads/markings/markings.h"
#include "compiler/roads/markings/markings_parts.h"

namespace citykiln::roads {
namespace {

using map::Lane;
using map::LaneDirection;

// Kerb lengths of a car after RAST 06: 5.5, 2.9 and 2.4 m, rounded up to divide kLayoutLength_m.
struct Bays {
  double period_m;
  double rise_m;  // of the line between two bays, from the strip's left edge to its right one
};

bool is_along(const Lane& lane) { return lane.width_m < 3; }

Bays bays_of(const Lane& lane, map::DrivingSide side) {
  constexpr double kSquare_m = 4.75, kSlant = 0.577;  // 60 degrees from the kerb
  if (is_along(lane)) return {6, 0};
  if (lane.width_m >= kSquare_m) return {2.4, 0};
  // drivers turn half into angled bays: both kerbs' bays lean in the direction of traffic
  return {3, side == map::DrivingSide::kRight ? lane.width_m * kSlant : -lane.width_m * kSlant};
}

// True where a row has marked bays: not along the kerb of a quiet street, except where the strip is a car park of its
// own.
bool has_bays(const MarkingLayout& layout, const Lane& lane) {
  if (lane.kind != map::LaneKind::kParking) return false;
  return !is_along(lane) || !is_quiet(layout) || layout.surface == map::LandCoverClass::kParking;
}

void add_bays_of(double left_m, double right_m, const Bays& bays, double line_m, Marks& marks) {
  for (double v_m = 0; v_m < kLayoutLength_m - bays.period_m / 2; v_m += bays.period_m) {
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
  constexpr double kLastBayEnds_m = 6;  // StVO § 12: no parking within 5 m of a junction
  const double line_m = measures_of(layout).narrow_m;
  const std::vector<double> sides_m = lane_sides_m(layout);
  for (std::size_t i = 0; i < layout.lanes.size(); ++i) {
    const Lane& lane = layout.lanes[i];
    if (!has_bays(layout, lane)) continue;
    const Bays bays = bays_of(lane, layout.side);
    add_bays_of(sides_m[i], sides_m[i + 1], bays, line_m, marks);
    add_bays_edge(lane, sides_m[i], sides_m[i + 1], layout.side, line_m, marks);
    if (layout.stretch != StretchKind::kEnd) continue;
    const double rise_m = bays.rise_m < 0 ? -bays.rise_m : bays.rise_m;
    const Vec2 low = {sides_m[i], kLastBayEnds_m + (line_m + rise_m) / 2}, high = {sides_m[i + 1], kLayoutLength_m};
    marks.push_back({rectangle(low, high), base_colour_of(layout)});
  }
}

}  // namespace citykiln::roads
