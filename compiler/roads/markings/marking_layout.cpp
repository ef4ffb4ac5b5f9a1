#include "compiler/roads/markings/marking_layout.h"

#include <algorithm>
#include <tuple>

namespace citykiln::roads {
namespace {

std::strong_ordering compared(const map::Lane& a, const map::Lane& b) {
  const auto ranks = [](const map::Lane& lane) { return std::tuple(lane.kind, lane.way, lane.turns, lane.is_raised); };
  if (const auto order = ranks(a) <=> ranks(b); order != 0) return order;
  return std::strong_order(a.width_m, b.width_m);
}

std::strong_ordering compared(const Mark& a, const Mark& b) {
  if (const auto order = a.colour <=> b.colour; order != 0) return order;
  return std::lexicographical_compare_three_way(a.ring.begin(), a.ring.end(), b.ring.begin(), b.ring.end(),
                                                [](Vec2 p, Vec2 q) {
                                                  const auto order = std::strong_order(p.x, q.x);
                                                  return order != 0 ? order : std::strong_order(p.y, q.y);
                                                });
}

map::LaneDirection turned(map::LaneDirection way) {
  if (way == map::LaneDirection::kBoth) return way;
  return way == map::LaneDirection::kForward ? map::LaneDirection::kBackward : map::LaneDirection::kForward;
}

StretchKind turned(StretchKind stretch) {
  if (stretch == StretchKind::kStart) return StretchKind::kEnd;
  return stretch == StretchKind::kEnd ? StretchKind::kStart : stretch;
}

}  // namespace

std::strong_ordering operator<=>(const MarkingLayout& a, const MarkingLayout& b) {
  const auto ranks = [](const MarkingLayout& p) {
    return std::tuple(p.surface, p.stretch, p.control, p.side, p.practice, p.has_kerb_left, p.has_kerb_right);
  };
  if (const auto order = ranks(a) <=> ranks(b); order != 0) return order;
  if (const auto order = std::strong_order(a.gauge_m, b.gauge_m); order != 0) return order;
  if (const auto order = std::strong_order(a.panel_m, b.panel_m); order != 0) return order;
  const auto in_order = [](const auto& x, const auto& y) { return compared(x, y); };
  if (const auto order = std::lexicographical_compare_three_way(a.panel.begin(), a.panel.end(), b.panel.begin(),
                                                                b.panel.end(), in_order);
      order != 0)
    return order;
  return std::lexicographical_compare_three_way(a.lanes.begin(), a.lanes.end(), b.lanes.begin(), b.lanes.end(),
                                                in_order);
}

double width_m(const MarkingLayout& layout) {
  return layout.panel_m > 0 ? layout.panel_m : lane_sides_m(layout).back();
}

std::vector<double> lane_sides_m(const MarkingLayout& layout) {
  std::vector<double> sides = {0};
  for (const map::Lane& lane : layout.lanes) sides.push_back(sides.back() + lane.width_m);
  return sides;
}

double length_m(const MarkingLayout& layout) {
  const bool is_crossing = layout.stretch == StretchKind::kZebra || layout.stretch == StretchKind::kCrossing;
  return is_crossing || is_hump(layout.stretch) ? kCrossingLength_m : kLayoutLength_m;
}

MarkingLayout turned_round(const MarkingLayout& layout) {
  MarkingLayout other = layout;
  std::reverse(other.lanes.begin(), other.lanes.end());
  for (map::Lane& lane : other.lanes) lane.way = turned(lane.way);
  other.stretch = turned(layout.stretch);
  std::swap(other.has_kerb_left, other.has_kerb_right);
  other.panel = turned_round(layout.panel, layout.panel_m, kLayoutLength_m);
  // the order and the first point of rings do not depend on the direction
  for (Mark& mark : other.panel) std::rotate(mark.ring.begin(), std::ranges::min_element(mark.ring), mark.ring.end());
  std::ranges::sort(other.panel, {}, &Mark::ring);
  return other;
}

CanonicalLayout canonical_layout(const MarkingLayout& layout) {
  MarkingLayout other = turned_round(layout);
  const bool is_turned = other < layout;
  return {is_turned ? other : layout, is_turned};
}

}  // namespace citykiln::roads
