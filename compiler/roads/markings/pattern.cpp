#include "compiler/roads/markings/pattern.h"

#include <algorithm>
#include <tuple>

namespace citykiln::roads {
namespace {

std::strong_ordering compared(const map::Lane& a, const map::Lane& b) {
  const auto ranks = [](const map::Lane& lane) { return std::tuple(lane.kind, lane.way, lane.turns, lane.is_raised); };
  if (const auto order = ranks(a) <=> ranks(b); order != 0) return order;
  return std::strong_order(a.width_m, b.width_m);
}

map::LaneWay turned(map::LaneWay way) {
  if (way == map::LaneWay::kBoth) return way;
  return way == map::LaneWay::kForward ? map::LaneWay::kBackward : map::LaneWay::kForward;
}

Stretch turned(Stretch stretch) {
  if (stretch == Stretch::kStart) return Stretch::kEnd;
  return stretch == Stretch::kEnd ? Stretch::kStart : stretch;
}

}  // namespace

std::strong_ordering operator<=>(const Pattern& a, const Pattern& b) {
  const auto ranks = [](const Pattern& p) {
    return std::tuple(p.surface, p.stretch, p.control, p.side, p.has_kerb_left, p.has_kerb_right);
  };
  if (const auto order = ranks(a) <=> ranks(b); order != 0) return order;
  if (const auto order = std::strong_order(a.gauge_m, b.gauge_m); order != 0) return order;
  return std::lexicographical_compare_three_way(a.lanes.begin(), a.lanes.end(), b.lanes.begin(), b.lanes.end(),
                                                compared);
}

double width_m(const Pattern& pattern) { return lane_sides_m(pattern).back(); }

std::vector<double> lane_sides_m(const Pattern& pattern) {
  std::vector<double> sides = {0};
  for (const map::Lane& lane : pattern.lanes) sides.push_back(sides.back() + lane.width_m);
  return sides;
}

double length_m(const Pattern& pattern) {
  const bool is_crossing = pattern.stretch == Stretch::kZebra || pattern.stretch == Stretch::kCrossing;
  return is_crossing ? kCrossingLength_m : kPatternLength_m;
}

Pattern turned_round(const Pattern& pattern) {
  Pattern other = pattern;
  std::reverse(other.lanes.begin(), other.lanes.end());
  for (map::Lane& lane : other.lanes) lane.way = turned(lane.way);
  other.stretch = turned(pattern.stretch);
  std::swap(other.has_kerb_left, other.has_kerb_right);
  return other;
}

CanonicalPattern canonical(const Pattern& pattern) {
  Pattern other = turned_round(pattern);
  const bool is_turned = other < pattern;
  return {is_turned ? std::move(other) : pattern, is_turned};
}

}  // namespace citykiln::roads
