#include "exporters/kiln/road_kinds.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace citykiln::exporters {
namespace {

auto as_tuple(const map::Lane& lane) {
  return std::tuple(lane.kind, lane.way, lane.width_m, lane.turns, lane.is_raised);
}

struct LaneOrder {
  bool operator()(const map::Lane& a, const map::Lane& b) const { return as_tuple(a) < as_tuple(b); }
};

struct KindOrder {
  bool operator()(const RoadKind& a, const RoadKind& b) const {
    const auto plain = [](const RoadKind& k) {
      return std::tuple(k.surface, k.side, k.is_lit, k.is_link, k.is_roundabout, k.section.axis_offset_m,
                        k.section.axis_drift, k.country, k.assumed, k.assumed_sides, k.kerb_parking);
    };
    if (plain(a) != plain(b)) return plain(a) < plain(b);
    return std::ranges::lexicographical_compare(a.section.lanes, b.section.lanes, LaneOrder());
  }
};

}  // namespace

RoadKind kind_of(const roads::Road& road) {
  return {road.surface,       road.section, road.side,    road.is_lit,        road.is_link,
          road.is_roundabout, road.country, road.assumed, road.assumed_sides, road.kerb_parking};
}

void set_kind(const RoadKind& kind, roads::Road& road) {
  road.surface = kind.surface, road.section = kind.section, road.side = kind.side;
  road.is_lit = kind.is_lit, road.is_link = kind.is_link, road.is_roundabout = kind.is_roundabout;
  road.country = kind.country, road.assumed = kind.assumed, road.assumed_sides = kind.assumed_sides;
  road.kerb_parking = kind.kerb_parking;
}

RoadKinds kinds_of(std::span<const roads::Road> roads) {
  std::map<RoadKind, std::uint32_t, KindOrder> counts;
  for (const roads::Road& road : roads) ++counts[kind_of(road)];
  RoadKinds all;
  for (const auto& [kind, count] : counts) all.kinds.push_back(kind);
  std::ranges::stable_sort(all.kinds, std::greater(), [&](const RoadKind& kind) { return counts[kind]; });
  for (std::uint32_t k = 0; k < all.kinds.size(); ++k) counts[all.kinds[k]] = k;
  for (const roads::Road& road : roads) all.of_road.push_back(counts[kind_of(road)]);
  return all;
}

bool is_sound(const map::CrossSection& section) {
  constexpr double kWidestLane_m = 4096;
  for (const map::Lane& lane : section.lanes)
    if (!(lane.width_m > 0 && lane.width_m <= kWidestLane_m)) return false;
  const auto is_raised = [](const map::Lane& lane) { return lane.is_raised; };
  const auto first = std::ranges::find_if_not(section.lanes, is_raised);
  const auto last = std::find_if(first, section.lanes.end(), is_raised);
  return first != section.lanes.end() && std::all_of(last, section.lanes.end(), is_raised) &&
         section.axis_offset_m >= 0 && section.axis_offset_m <= map::carriageway_width_m(section);
}

}  // namespace citykiln::exporters
