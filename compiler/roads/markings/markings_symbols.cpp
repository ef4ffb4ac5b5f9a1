// Lane symbols: a bicycle, or BUS, upright for arriving drivers. Drawn with even strokes, then stretched lengthwise.
// Proportions from the drawings of RMS-1 and MUTCD figures 3B-23 and 9C-3.
#include <algorithm>
#include <array>
#include <span>

#include "compiler/geometry/trig.h"
#include "compiler/roads/markings/marking_rules.h"
#include "compiler/roads/markings/markings_parts.h"

namespace citykiln::roads {
namespace {

using Drawing = std::vector<Ring>;

struct Symbol {
  Drawing rings;  // origin at the middle of the foot
  double width;
  double stretch;
};

Ring circle_line(Vec2 middle, double radius) {
  constexpr int kSides = 20;
  Ring line;
  for (int i = 0; i <= kSides; ++i)
    line.push_back(middle + direction_of(i == kSides ? 0 : static_cast<double>(i) / kSides) * radius);
  return line;
}

Symbol bicycle() {
  constexpr double kStroke = 0.075, kWheel = 0.25;
  constexpr Vec2 kRearHub = {-0.31, 0.29}, kFrontHub = {0.31, 0.29}, kCrank = {-0.04, 0.27}, kSeat = {-0.14, 0.7},
                 kHead = {0.19, 0.68};
  constexpr std::array<Vec2, 2> kStrokes[] = {
      {{kRearHub, kCrank}},
      {{kRearHub, {-0.12, 0.62}}},
      {{kCrank, kSeat}},
      {{kCrank, kHead}},
      {{{-0.12, 0.62}, kHead}},
      {{{0.16, 0.82}, kFrontHub}},
      {{{0.16, 0.82}, {0.32, 0.86}}},
      {{{-0.27, 0.73}, {-0.03, 0.73}}},
  };
  Symbol symbol{{}, 2 * (kFrontHub.x + kWheel) + kStroke, 1.8};
  for (const Vec2 hub : {kRearHub, kFrontHub}) symbol.rings.push_back(stroke(circle_line(hub, kWheel), kStroke));
  for (const auto& line : kStrokes) symbol.rings.push_back(stroke(line, kStroke));
  return symbol;
}

constexpr double kLetterStroke = 0.12, kLetterWidth = 0.4, kLetterStep = 0.66;

// The outline of a letter as x, y of its points; kLetterWidth wide and 0.76 high. An x below 0 begins another line.
constexpr double kNext = -1;
constexpr double kB[] = {0,    0,   0,    0.76, 0.3, 0.76, 0.4, 0.67,  0.4, 0.47, 0.32, 0.39, 0.4,
                         0.31, 0.4, 0.09, 0.3,  0,   0,    0,   kNext, 0,   0.06, 0.39, 0.3,  0.39};
constexpr double kU[] = {0, 0.82, 0, 0.12, 0.1, 0, 0.3, 0, 0.4, 0.12, 0.4, 0.82};
constexpr double kS[] = {0.4,  0.6,  0.4, 0.66, 0.3, 0.76, 0.1, 0.76, 0,   0.66, 0, 0.5, 0.08, 0.42,
                         0.32, 0.34, 0.4, 0.26, 0.4, 0.1,  0.3, 0,    0.1, 0,    0, 0.1, 0,    0.16};

std::vector<Ring> lines_of(std::span<const double> letter) {
  std::vector<Ring> lines(1);
  for (std::size_t i = 0; i < letter.size(); i += 2)
    if (letter[i] < 0)
      lines.emplace_back();
    else
      lines.back().push_back({letter[i], letter[i + 1]});
  return lines;
}

Symbol bus() {
  Symbol symbol{{}, 2 * kLetterStep + kLetterWidth + kLetterStroke, 3.2};
  double left = -kLetterStep - kLetterWidth / 2;
  for (const std::span<const double> letter :
       {std::span<const double>(kB), std::span<const double>(kU), std::span<const double>(kS)}) {
    for (Ring line : lines_of(letter)) {
      for (Vec2& p : line) p = p + Vec2{left, kLetterStroke / 2};
      symbol.rings.push_back(stroke(line, kLetterStroke));
    }
    left += kLetterStep;
  }
  return symbol;
}

void add_symbol(const Symbol& symbol, LaneSpan lane, double foot_m, Marks& marks) {
  constexpr double kLargestShare = 0.8;  // share of the lane's width
  const double scale = std::min(1.0, kLargestShare * (lane.high_m - lane.low_m) / symbol.width);
  const Vec2 origin = {(lane.low_m + lane.high_m) / 2, foot_m};
  for (const Ring& ring : symbol.rings) {
    Mark mark{{}, kWhite};
    for (const Vec2& p : ring) mark.ring.push_back(origin + Vec2{p.x * scale, p.y * scale * symbol.stretch});
    marks.push_back(std::move(mark));
  }
}

bool has_symbol(const map::Lane& lane) {
  return lane.kind == map::LaneKind::kCycle || lane.kind == map::LaneKind::kBus;
}

// Symbols for traffic towards the layout's end, placed before any arrow.
void add_arriving_symbols(const MarkingLayout& layout, double foot_m, Marks& marks) {
  for (std::size_t i = 0; i < layout.lanes.size(); ++i) {
    const LaneSpan lane = arriving_span(layout, i);
    if (!has_symbol(layout.lanes[i]) || !(lane.low_m < lane.high_m)) continue;
    add_symbol(layout.lanes[i].kind == map::LaneKind::kBus ? bus() : bicycle(), lane, foot_m, marks);
  }
}

}  // namespace

void add_symbols(const MarkingLayout& layout, Marks& marks) {
  constexpr double kArrivingFoot_m = 1, kLeavingFoot_m = 2.5;
  add_arriving_symbols(layout, kArrivingFoot_m, marks);
  // and for traffic that leaves the junction
  Marks leaving;
  add_arriving_symbols(turned_round(layout), kLeavingFoot_m, leaving);
  for (Mark& mark : turned_round(leaving, width_m(layout), kLayoutLength_m)) marks.push_back(std::move(mark));
}

}  // namespace citykiln::roads
