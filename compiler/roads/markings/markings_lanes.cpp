// Lines between neighbouring lanes, edge lines, tints and hatching.
#include <algorithm>
#include <array>
#include <optional>

#include "compiler/roads/markings/marking_rules.h"
#include "compiler/roads/markings/markings.h"
#include "compiler/roads/markings/markings_parts.h"

namespace citykiln::roads {
namespace {

using map::Lane;
using map::LaneDirection;
using map::LaneKind;

constexpr double kEdgeLineInset_m = 0.25;  // from the edge of the asphalt to the centre of the line
constexpr double kWalkersStrip_m = 0.5;    // the same of lines that set off a strip for walkers
constexpr double kNarrowCycleLane_m = 1.25;
constexpr DashPattern kCloseBroken = {1, 2};  // RMS: narrow cycle lanes that lorries may use
constexpr DashPattern kTwoWayTrack = {1, 4};

struct Line {
  double width_m = 0;  // 0: no line
  DashPattern dashes = kSolid;
  bool is_double = false;
  DashPattern second = kSolid;  // of double lines: the one on the right
  materials::TextureImage::Texel colour = kWhite;
};

struct Rules {
  LineMeasures measures;
  bool is_sorted;          // at a junction with control, or with arrows on its lanes: lane changes are over
  bool has_double_centre;  // two or more lanes each way
  bool is_quiet;
};

// Arrows of lanes that end by merging, and of all that continue along the road.
constexpr std::uint16_t kMerging = map::kTurnMergeToLeft | map::kTurnMergeToRight;
constexpr std::uint16_t kAhead = map::kTurnThrough | kMerging;

Rules rules_of(const MarkingLayout& layout) {
  Rules rules{measures_of(layout), layout.control != Control::kNone, false, is_quiet(layout)};
  int forward = 0, backward = 0;
  for (const Lane& lane : layout.lanes) {
    forward += is_driven(lane) && lane.way == LaneDirection::kForward;
    backward += is_driven(lane) && lane.way == LaneDirection::kBackward;
    rules.is_sorted |= lane.turns != 0 && lane.way != LaneDirection::kBackward;
  }
  rules.is_sorted &= layout.stretch == StretchKind::kEnd;
  rules.has_double_centre = forward >= 2 && backward >= 2;
  return rules;
}

bool is_either(LaneKind kind, const Lane& a, const Lane& b) { return a.kind == kind || b.kind == kind; }

bool merges(const Lane& a, const Lane& b) { return ((a.turns | b.turns) & kMerging) != 0; }

// True where one lane continues and the other leaves the motorway.
bool leaves(const Lane& a, const Lane& b) {
  const bool are_marked = a.turns != 0 && b.turns != 0;
  return are_marked && ((a.turns & kAhead) != 0) != ((b.turns & kAhead) != 0);
}

Line cycle_line(const Lane& a, const Lane& b, const Rules& rules) {
  if (a.kind == b.kind) return a.way == b.way ? Line{} : Line{rules.measures.narrow_m, kTwoWayTrack};
  const double width_m = a.kind == LaneKind::kCycle ? a.width_m : b.width_m;
  if (!is_driven(a) && !is_driven(b)) return {rules.measures.narrow_m, kSolid};
  if (rules.is_quiet || width_m < kNarrowCycleLane_m) return {rules.measures.narrow_m, kCloseBroken};
  return {rules.measures.broad_m, kSolid};
}

Line same_way_line(const Lane& a, const Lane& b, const MarkingLayout& layout, const Rules& rules) {
  const LineMeasures& measures = rules.measures;
  if (a.kind != b.kind && is_either(LaneKind::kBus, a, b)) return {measures.broad_m, kSolid};
  const bool is_motorway = layout.surface == map::LandCoverClass::kMotorwayRoad;
  if (merges(a, b) || (is_motorway && leaves(a, b))) return {measures.broad_m, measures.broad_broken};
  const bool is_sorted = rules.is_sorted && a.way == LaneDirection::kForward;
  if (!measures.has_lane_lines && !is_sorted) return {};
  return {measures.narrow_m, is_sorted ? kSolid : measures.broken};
}

// MUTCD 3B.01 to 3B.03: two solid lines on streets with kerbs and of several lanes, a broken one on country roads; a
// lane for turning from both directions lies between broken lines with solid ones outside.
Line american_centre_line(const Lane& a, const Lane& b, const MarkingLayout& layout, const Rules& rules) {
  Line line{rules.measures.narrow_m, kSolid, true, kSolid, kYellow};
  if (a.kind == LaneKind::kTurn) line.dashes = rules.measures.broken;
  if (b.kind == LaneKind::kTurn) line.second = rules.measures.broken;
  if (is_either(LaneKind::kTurn, a, b)) return line;
  const bool is_street = layout.has_kerb_left || layout.has_kerb_right;
  if (rules.has_double_centre || rules.is_sorted || is_street) return line;
  return {rules.measures.narrow_m, rules.measures.broken, false, kSolid, kYellow};
}

Line driven_line(const Lane& a, const Lane& b, const MarkingLayout& layout, const Rules& rules) {
  if (a.way == b.way) return same_way_line(a, b, layout, rules);
  if (!rules.measures.has_lane_lines) return {};
  if (layout.practice == MarkingPractice::kAmerican) return american_centre_line(a, b, layout, rules);
  // a lane for turning from both directions is no lane to overtake on
  if (is_either(LaneKind::kTurn, a, b)) return {rules.measures.narrow_m, kSolid};
  const bool is_either_way = a.way == LaneDirection::kBoth || b.way == LaneDirection::kBoth;
  if (rules.has_double_centre && !is_either_way) return {rules.measures.narrow_m, kSolid, true};
  return {rules.measures.narrow_m, rules.is_sorted ? kSolid : rules.measures.broken};
}

Line shoulder_line(const Lane& a, const Lane& b, const MarkingLayout& layout, const Rules& rules) {
  if (!rules.measures.has_lane_lines || a.kind == b.kind) return {};
  const double width_m = a.kind == LaneKind::kShoulder ? a.width_m : b.width_m;
  constexpr double kEmergencyLane_m = 2;
  const bool is_broad = layout.surface == map::LandCoverClass::kMotorwayRoad && width_m >= kEmergencyLane_m;
  return {is_broad ? rules.measures.broad_m : rules.measures.narrow_m, kSolid};
}

Line lane_line_between(const Lane& a, const Lane& b, const MarkingLayout& layout, const Rules& rules) {
  for (const LaneKind bare :
       {LaneKind::kSidewalk, LaneKind::kFoot, LaneKind::kRail, LaneKind::kParking, LaneKind::kVerge})
    if (is_either(bare, a, b)) return {};
  if (is_either(LaneKind::kBuffer, a, b)) return a.kind == b.kind ? Line{} : Line{rules.measures.narrow_m, kSolid};
  if (is_either(LaneKind::kShoulder, a, b)) return shoulder_line(a, b, layout, rules);
  if (is_either(LaneKind::kCycle, a, b)) return cycle_line(a, b, rules);
  return driven_line(a, b, layout, rules);
}

void add(const Line& line, double u_m, Marks& marks) {
  if (line.width_m <= 0) return;
  if (!line.is_double) return add_line(u_m, line.width_m, line.dashes, marks, line.colour);
  // the gap is as wide as the lines
  add_line(u_m - line.width_m, line.width_m, line.dashes, marks, line.colour);
  add_line(u_m + line.width_m, line.width_m, line.second, marks, line.colour);
}

void add_edge_lines(const MarkingLayout& layout, const LineMeasures& measures, Marks& marks) {
  const bool is_motorway = layout.surface == map::LandCoverClass::kMotorwayRoad;
  const auto has_line = [&](const Lane& lane, bool has_kerb) {
    return measures.has_edge_lines && is_driven(lane) && (is_motorway || !has_kerb) && lane.width_m > 1;
  };
  const double inset_m = is_quiet(layout) ? kWalkersStrip_m : kEdgeLineInset_m;
  if (has_line(layout.lanes.front(), layout.has_kerb_left)) add_line(inset_m, measures.narrow_m, kSolid, marks);
  if (has_line(layout.lanes.back(), layout.has_kerb_right))
    add_line(width_m(layout) - inset_m, measures.narrow_m, kSolid, marks);
}

// Centre lines of two-way cycle tracks, which are one lane.
void add_track_centres(const MarkingLayout& layout, double line_m, Marks& marks) {
  constexpr double kTwoWayTrack_m = 2;
  const std::vector<double> sides_m = lane_sides_m(layout);
  for (std::size_t i = 0; i < layout.lanes.size(); ++i) {
    const Lane& lane = layout.lanes[i];
    if (lane.kind == LaneKind::kCycle && lane.way == LaneDirection::kBoth && lane.width_m >= kTwoWayTrack_m)
      add_line((sides_m[i] + sides_m[i + 1]) / 2, line_m, kTwoWayTrack, marks);
  }
}

}  // namespace

void add_lane_lines(const MarkingLayout& layout, Marks& marks) {
  const Rules rules = rules_of(layout);
  const std::vector<double> sides_m = lane_sides_m(layout);
  add_edge_lines(layout, rules.measures, marks);
  for (std::size_t i = 0; i + 1 < layout.lanes.size(); ++i)
    add(lane_line_between(layout.lanes[i], layout.lanes[i + 1], layout, rules), sides_m[i + 1], marks);
  add_track_centres(layout, rules.measures.narrow_m, marks);
}

void add_tints(const MarkingLayout& layout, Marks& marks) {
  const bool has_cars = std::any_of(layout.lanes.begin(), layout.lanes.end(), is_driven);
  const std::vector<double> sides_m = lane_sides_m(layout);
  // asphalt with a quarter of red aggregate
  const materials::TextureImage::Texel base = base_colour_of(layout);
  const materials::TextureImage::Texel tint = {static_cast<std::uint8_t>(std::min(255, base[0] + 26)), base[1],
                                               static_cast<std::uint8_t>(std::max(0, base[2] - 8))};
  for (std::size_t i = 0; i < layout.lanes.size(); ++i)
    if (has_cars && layout.lanes[i].kind == LaneKind::kCycle && !layout.lanes[i].is_raised)
      marks.push_back({rectangle({sides_m[i], 0}, {sides_m[i + 1], kLayoutLength_m}), tint});
}

void add_hatching(const MarkingLayout& layout, Marks& marks) {
  struct Hatch {
    double stripe_m, period_m;
  };
  constexpr Hatch kNarrow = {0.25, 1}, kWide = {0.5, 1.5};
  constexpr double kLeastHatched_m = 0.4, kWide_m = 1;
  const std::vector<double> sides_m = lane_sides_m(layout);
  for (std::size_t i = 0; i < layout.lanes.size(); ++i) {
    const Lane& lane = layout.lanes[i];
    if (lane.kind != LaneKind::kBuffer || lane.is_raised || lane.width_m < kLeastHatched_m) continue;
    const Hatch hatch = lane.width_m < kWide_m ? kNarrow : kWide;
    // stripes lean backwards as seen from the adjacent traffic, so the strip looks the same from both ends
    const double rise_m = layout.side == map::DrivingSide::kRight ? -lane.width_m : lane.width_m;
    for (double v_m = 0; v_m < kLayoutLength_m; v_m += hatch.period_m) {
      const double low_m = v_m + (hatch.period_m - hatch.stripe_m - rise_m) / 2, high_m = low_m + hatch.stripe_m;
      const double left_m = sides_m[i], right_m = sides_m[i + 1];
      marks.push_back(
          {{{left_m, low_m}, {right_m, low_m + rise_m}, {right_m, high_m + rise_m}, {left_m, high_m}}, kWhite});
    }
  }
}

}  // namespace citykiln::roads
