// Arrows of turn:lanes, 5 m long: a shaft, and from it a branch with a head for each direction.
//
//      A        Drawn as a driver would see them, upright and with even strokes, then stretched lengthwise. Proportions
//    < |        after the drawings of RMS-1 (5 m arrows, 0.15 m strokes) and MUTCD figure 3B-24.
//     \|
//      |
#include <algorithm>
#include <array>
#include <span>

#include "compiler/roads/markings/marking_rules.h"
#include "compiler/roads/markings/markings_parts.h"

namespace citykiln::roads {
namespace {

constexpr double kStretch = 2.5, kFoot_m = 4.5;  // the tail is 7 m before the stop line
constexpr double kShaft = 0.18;
constexpr double kLargestShare = 0.75;  // share of the lane's width

struct Branch {
  std::uint16_t left, right;  // bits of Lane::turns
  std::array<Vec2, 5> line;   // for the right turn; starts on the shaft
  std::size_t points;
  double head_length, head_width;
};

constexpr Branch kBranches[] = {
    {map::kTurnThrough, 0, {{{0, 1.2}, {0, 1.35}}}, 2, 0.65, 0.56},
    {map::kTurnSlightLeft, map::kTurnSlightRight, {{{0, 0.35}, {0, 0.5}, {0.34, 0.98}}}, 3, 0.48, 0.52},
    {map::kTurnLeft, map::kTurnRight, {{{0, 0.5}, {0, 0.7}, {0.1, 0.85}, {0.3, 0.9}, {0.36, 0.9}}}, 5, 0.36, 0.62},
    {map::kTurnSharpLeft,
     map::kTurnSharpRight,
     {{{0, 0.5}, {0, 0.85}, {0.11, 1}, {0.28, 1}, {0.4, 0.86}}},
     5,
     0.42,
     0.52},
    {map::kTurnMergeToLeft, map::kTurnMergeToRight, {{{0, 0.3}, {0, 0.45}, {0.4, 1.25}}}, 3, 0.6, 0.52},
};

// A U-turn points to the side of oncoming traffic and is left out where an arrow points there already. Drawn for
// traffic on the left, where that is the right side.
constexpr Branch kReverse = {
    0, map::kTurnReverse, {{{0, 0.9}, {0, 1.35}, {0.25, 1.6}, {0.5, 1.35}, {0.5, 1.2}}}, 5, 0.6, 0.54};

using Drawing = std::vector<Ring>;

void mirror(Drawing& drawing) {
  for (Ring& ring : drawing)
    for (Vec2& p : ring) p.x = -p.x;
}

Drawing drawn(const Branch& branch, bool is_left) {
  const std::span<const Vec2> line(branch.line.data(), branch.points);
  const Vec2 along = unit(line.back() - line[line.size() - 2]), aside = left_of(along) * (branch.head_width / 2);
  Drawing drawing = {stroke(line, kShaft),
                     {line.back() - aside, line.back() + along * branch.head_length, line.back() + aside}};
  if (is_left) mirror(drawing);
  return drawing;
}

// In drawing units: the tail at (0, 0), the tip of a straight arrow at (0, 2).
Drawing arrow_of(std::uint16_t turns, map::DrivingSide side) {
  Drawing arrow;
  double shaft = 0;
  const auto add = [&](const Branch& branch, bool is_left) {
    for (Ring& ring : drawn(branch, is_left)) arrow.push_back(std::move(ring));
    shaft = std::max(shaft, branch.line[0].y);
  };
  for (const Branch& branch : kBranches) {
    if (turns & branch.left) add(branch, true);
    if (turns & branch.right) add(branch, false);
  }
  const bool is_right_hand = side == map::DrivingSide::kRight;
  const bool has_its_side = (turns & (is_right_hand ? map::kTurnLeft : map::kTurnRight)) != 0;
  if ((turns & kReverse.right) && !has_its_side) add(kReverse, is_right_hand);
  if (!arrow.empty()) arrow.push_back(rectangle({-kShaft / 2, 0}, {kShaft / 2, shaft}));
  return arrow;
}

LaneSpan extent_of(const Drawing& drawing) {
  LaneSpan extent{0, 0};
  for (const Ring& ring : drawing)
    for (const Vec2& p : ring) extent = {std::min(extent.low_m, p.x), std::max(extent.high_m, p.x)};
  return extent;
}

void add_arrow(const Drawing& arrow, LaneSpan lane, Marks& marks) {
  const LaneSpan extent = extent_of(arrow);
  const double scale = std::min(1.0, kLargestShare * (lane.high_m - lane.low_m) / (extent.high_m - extent.low_m));
  const Vec2 origin = {(lane.low_m + lane.high_m) / 2 - scale * (extent.low_m + extent.high_m) / 2, kFoot_m};
  for (const Ring& ring : arrow) {
    Mark mark{{}, kWhite};
    for (const Vec2& p : ring) mark.ring.push_back(origin + Vec2{p.x * scale, p.y * scale * kStretch});
    marks.push_back(std::move(mark));
  }
}

}  // namespace

void add_arrows(const MarkingLayout& layout, Marks& marks) {
  for (std::size_t i = 0; i < layout.lanes.size(); ++i) {
    const LaneSpan lane = arriving_span(layout, i);
    const Drawing arrow = arrow_of(layout.lanes[i].turns, layout.side);
    if (lane.low_m < lane.high_m && !arrow.empty()) add_arrow(arrow, lane, marks);
  }
}

}  // namespace citykiln::roads
