#include "compiler/furniture/road_things.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "compiler/contract/random_sequence.h"
#include "compiler/furniture/walked_paving.h"
#include "compiler/geometry/line_part.h"
#include "compiler/geometry/snap.h"
#include "compiler/roads/pieces/stretches.h"
#include "compiler/roads/width_limits/narrowed_section.h"
#include "compiler/things/facing.h"
#include "compiler/things/front_kinds.h"

namespace citykiln::furniture {
namespace {

using map::CountryGroup;
using map::LandCoverClass;
using roads::Road;

constexpr double kBollard_m = 0.14, kBollardHeight_m = 0.9;
constexpr double kRefugeWidth_m = 1.2, kRefugeLength_m = 1.6, kRefugeHeight_m = 1.1;
constexpr double kPlanterSide_m = 1.2, kPlanterHeight_m = 1.1, kPlanterStep_m = 16;

things::Thing road_thing(const Road& road, std::string_view kind, Vec2 at, Vec2 ahead, Vec3 size_m,
                         std::size_t number) {
  return {.id = {road.id.osm, static_cast<std::uint32_t>(number)},
          .at = snapped(at),
          .direction = things::nearest_direction(ahead),
          .is_in_way = true,
          .form = {.kind = std::string(kind),
                   .width_m = snapped(size_m.x),
                   .depth_m = snapped(size_m.y),
                   .height_m = snapped(size_m.z),
                   .country = road.country}};
}

// A place on a road's axis, and its direction there.
struct AxisPlace {
  Vec2 at, ahead;
};

AxisPlace axis_place(const Road& road, const std::vector<double>& along, double at_m) {
  const double from_m = std::clamp(at_m - 0.5, along.front(), along.back()),
               to_m = std::clamp(at_m + 0.5, along.front(), along.back());
  return {point_at(road.axis, along, std::clamp(at_m, along.front(), along.back())),
          unit(point_at(road.axis, along, to_m) - point_at(road.axis, along, from_m))};
}

// The offset of the line between opposite directions from the axis, to the left positive; the middle of a road that is
// not divided.
double between_directions_m(const Road& road) {
  double edge_m = roads::left_m(road);
  const map::Lane* last = nullptr;
  for (const map::Lane& lane : road.section.lanes) {
    if (lane.is_raised) continue;
    const bool is_driven = lane.kind == map::LaneKind::kDriving || lane.kind == map::LaneKind::kBus;
    if (is_driven && last != nullptr && last->way != lane.way) return edge_m;
    if (is_driven) last = &lane;
    edge_m -= lane.width_m;
  }
  return (roads::left_m(road) - roads::right_m(road)) / 2;
}

bool has_both_directions(const Road& road) {
  const auto flows = [&](map::LaneDirection way) {
    return std::ranges::any_of(road.section.lanes, [&](const map::Lane& lane) {
      return lane.kind == map::LaneKind::kDriving && (lane.way == way || lane.way == map::LaneDirection::kBoth);
    });
  };
  return flows(map::LaneDirection::kForward) && flows(map::LaneDirection::kBackward);
}

bool has_room_for_refuge(const Road& road) {
  return map::is_street(road.surface) && has_both_directions(road) && roads::width_m(road) >= kRefugeRoad_m;
}

bool is_island(const map::TrackPoint& point) {
  return point.kind == map::TrackPointKind::kIsland || (point.traits & map::kCrossingIsland) != 0;
}

// The places of refuges along a road, in metres.
std::vector<double> refuge_places(const Road& road, std::span<const roads::JunctionInterval> intervals, double tile_m) {
  std::vector<double> places_m;
  const std::vector<double> along = roads::distances_along(road);
  for (const roads::RoadStretch& stretch : roads::stretches_of(road, intervals, tile_m))
    if ((stretch.traits & map::kCrossingIsland) != 0)
      for (const double at_m : {stretch.from_m - kRefugeLength_m / 2, stretch.to_m + kRefugeLength_m / 2})
        places_m.push_back(at_m);
  for (const map::TrackPoint& point : road.points)
    if (point.kind == map::TrackPointKind::kIsland) places_m.push_back(along[point.vertex]);
  std::erase_if(places_m, [&](double at_m) {
    return std::ranges::any_of(intervals, [&](const roads::JunctionInterval& each) {
      return at_m + kRefugeLength_m / 2 > each.at_m - each.before_m &&
             at_m - kRefugeLength_m / 2 < each.at_m + each.after_m;
    });
  });
  return places_m;
}

bool has_bollards_usually(CountryGroup country) {
  return country == CountryGroup::kCentralEurope || country == CountryGroup::kSouthernEurope ||
         country == CountryGroup::kNorthernEurope;
}

bool is_driven_street(const Road& road) {
  return map::is_street(road.surface) && road.surface != LandCoverClass::kPedestrianStreet;
}

struct WalkedStreets {
  const roadside::TileRecipes& recipes;
  const roadside::ClearZones& zones;
  const RectIndex& standing;
  std::uint64_t seed;
  const Box2& box;
  std::vector<things::Thing> made{};

  bool is_mapped_near(Vec2 p) const {
    constexpr double kNear_m = 20;
    return std::ranges::any_of(recipes.things, [&](const things::Thing& thing) {
      const std::string_view kind = thing.form.kind;
      return (kind == things::kBollard || kind.ends_with("gate")) && distance(thing.at, p) < kNear_m;
    });
  }

  void add_mouth(const roads::Arm& arm, const roads::Cut& cut) {
    constexpr double kBehindMouth_m = 1, kShare = 0.7, kFromEdge_m = 0.4;
    const Road& road = recipes.roads[arm.road];
    if (road.surface != LandCoverClass::kPedestrianStreet || cut.length_m == roads::kWholeLink_m) return;
    if (!has_bollards_usually(road.country)) return;
    const std::vector<double> along = roads::distances_along(road);
    const double at_m = along[arm.vertex] + arm.step * (cut.length_m + kBehindMouth_m);
    if (at_m <= along.front() || at_m >= along.back()) return;
    const RandomSequence draws(seed, stable_id(road.id), "bollards");
    const AxisPlace place = axis_place(road, along, at_m);
    if (draws.unit(arm.vertex) >= kShare || is_mapped_near(place.at)) return;
    const roads::RoadEdges edges = roads::road_edges_at(road, at_m);
    const double width_m = edges.kerb_left_m + edges.kerb_right_m - 2 * kFromEdge_m;
    const auto steps = static_cast<int>(std::ceil(width_m / kBollardStep_m));
    for (int i = 0; i <= steps && steps > 0; ++i) {
      const double off_m = edges.kerb_left_m - kFromEdge_m - width_m * i / steps;
      add(road, things::kBollard, place.at + left_of(place.ahead) * off_m, place.ahead,
          {kBollard_m, kBollard_m, kBollardHeight_m});
    }
  }

  void add(const Road& road, std::string_view kind, Vec2 at, Vec2 ahead, Vec3 size_m) {
    if (!box.contains_half_open(snapped(at))) return;
    things::Thing thing = road_thing(road, kind, at, ahead, size_m, made.size());
    const OrientedRect plan = roadside::plan_of(thing);
    const bool is_bollard = kind == things::kBollard;
    const auto is_paving = [&](Vec2 p) { return is_walked_paving(recipes, p); };
    if (!is_paving(plan.at) || !std::ranges::all_of(corners_of(plan), is_paving)) return;
    if (overlaps_any(zones.things, plan, 0) || overlaps_any(standing, plan, 0) ||
        !roadside::is_clear(zones.trunks, plan) || !roadside::is_clear(zones.lamps, plan) ||
        !roadside::is_clear(zones.doors, plan))
      return;
    if (!is_bollard && !roadside::is_clear(zones.streets, plan)) return;
    made.push_back(std::move(thing));
  }

  // Planters at 0.3 and 0.7 of the width, on alternating sides.
  void add_planters(const Road& road) {
    constexpr double kLeastWidth_m = 7, kShare = 0.6;
    if (road.surface != LandCoverClass::kPedestrianStreet) return;
    const std::vector<double> along = roads::distances_along(road);
    const RandomSequence draws(seed, stable_id(road.id), "planters");
    const auto first = static_cast<std::int64_t>(std::ceil(along.front() / kPlanterStep_m));
    for (std::int64_t k = first; static_cast<double>(k) * kPlanterStep_m < along.back(); ++k) {
      if (draws.unit(static_cast<std::uint32_t>(k)) >= kShare) continue;
      const double at_m = static_cast<double>(k) * kPlanterStep_m;
      const roads::RoadEdges edges = roads::road_edges_at(road, at_m);
      const double width_m = edges.kerb_left_m + edges.kerb_right_m;
      if (width_m < kLeastWidth_m) continue;
      const AxisPlace place = axis_place(road, along, at_m);
      const double off_m = edges.kerb_left_m - width_m * (k % 2 == 0 ? 0.3 : 0.7);
      add(road, things::kPlanter, place.at + left_of(place.ahead) * off_m, place.ahead,
          {kPlanterSide_m, kPlanterSide_m, kPlanterHeight_m});
    }
  }
};

}  // namespace

std::vector<things::Thing> refuges(const roadside::TileRecipes& recipes, const Box2& box) {
  std::vector<things::Thing> made;
  std::vector<std::vector<roads::JunctionInterval>> intervals;
  for (std::size_t i = 0; i < recipes.roads.size(); ++i) {
    const Road& road = recipes.roads[i];
    if (std::ranges::none_of(road.points, is_island) || !has_room_for_refuge(road)) continue;
    if (intervals.empty()) intervals = roads::junction_intervals_of(recipes.roads, recipes.junctions);
    const std::vector<double> along = roads::distances_along(road);
    for (const double at_m : refuge_places(road, intervals[i], recipes.tile_m)) {
      if (at_m < along.front() || at_m > along.back()) continue;
      const AxisPlace place = axis_place(road, along, at_m);
      const Vec2 at = snapped(place.at + left_of(place.ahead) * between_directions_m(road));
      if (box.contains_half_open(at))
        made.push_back(road_thing(road, things::kRefuge, at, place.ahead,
                                  {kRefugeWidth_m, kRefugeLength_m, kRefugeHeight_m}, made.size()));
    }
  }
  return made;
}

std::vector<things::Thing> things_of_walked_streets(const roadside::TileRecipes& recipes,
                                                    const roadside::ClearZones& zones, const RectIndex& standing,
                                                    std::uint64_t seed, const Box2& box) {
  WalkedStreets streets{recipes, zones, standing, seed, box};
  const std::vector<std::vector<roads::Arm>> arms = roads::arms_of(recipes.junctions, recipes.roads);
  for (std::size_t j = 0; j < recipes.junctions.size(); ++j) {
    const std::vector<roads::Cut>& cuts = recipes.junctions[j].cuts;
    const bool is_met =
        std::ranges::any_of(arms[j], [&](const roads::Arm& arm) { return is_driven_street(recipes.roads[arm.road]); });
    for (std::size_t a = 0; is_met && arms[j].size() == cuts.size() && a < cuts.size(); ++a)
      streets.add_mouth(arms[j][a], cuts[a]);
  }
  for (const Road& road : recipes.roads) streets.add_planters(road);
  return std::move(streets.made);
}

}  // namespace citykiln::furniture
