#include "compiler/furniture/front_things.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "compiler/contract/random_sequence.h"
#include "compiler/furniture/walked_paving.h"
#include "compiler/geometry/snap.h"
#include "compiler/things/facing.h"
#include "compiler/things/front_kinds.h"

namespace citykiln::furniture {
namespace {

using things::FrontThingKind;

// The distance of things from the wall, from each other, and from the doors that fronts draw at their ends or middle.
constexpr double kFromWall_m = 0.15, kBetween_m = 0.3, kFrontDoor_m = 1.05;
// The shortest front whose door is in the middle (shop_front.cga).
constexpr double kDoorInMiddle_m = 5;
constexpr std::uint32_t kMostAtFront = 6;

// A front in the plane.
struct FrontLine {
  Vec2 from, along, outward;
  double length_m = 0;
};

FrontLine line_of(const buildings::Building& building, const buildings::Front& front) {
  const Ring& ring = building.footprint.outer;
  const Vec2 a = ring[front.edge], along = unit(ring[(front.edge + 1) % ring.size()] - a);
  return {a + along * front.from_m, along, left_of(along) * -1.0, front.to_m - front.from_m};
}

// The parts of a front where things may stand: beside the door in its middle, or between the doors at its ends.
struct FrontSpan {
  double from_m, to_m;
};
std::vector<FrontSpan> spans_of(const FrontLine& line) {
  if (line.length_m <= kDoorInMiddle_m) return {{kFrontDoor_m, line.length_m - kFrontDoor_m}};
  const double middle_m = line.length_m / 2;
  return {{0.2, middle_m - kFrontDoor_m}, {middle_m + kFrontDoor_m, line.length_m - 0.2}};
}

// Which of the random appearances the things of a front have.
std::uint8_t look_of(double draw) {
  constexpr int kParts = 64;
  return static_cast<std::uint8_t>(static_cast<int>(draw * kParts) % things::kVariants);
}

// Fills the fronts of a tile.
struct FrontDresser {
  const roadside::TileRecipes& recipes;
  const roadside::ClearZones& zones;
  const RectIndex& standing;
  const Box2& box;
  std::vector<things::Thing> made{};

  // Paving below the plan and before it.
  bool has_room(const FrontLine& line, double middle_m, const FrontThingKind& kind) const {
    const double far_m = kFromWall_m + kind.depth_m + kWalkBeforeFront_m;
    for (const double side : {-0.5, 0.5})
      for (const double out_m : {kFromWall_m + 0.1, kFromWall_m + kind.depth_m, (kind.depth_m + far_m) / 2, far_m})
        if (!is_walked_paving(recipes,
                              line.from + line.along * (middle_m + side * kind.width_m) + line.outward * out_m))
          return false;
    return true;
  }

  bool is_free(const OrientedRect& plan) const {
    return roadside::is_clear(zones.streets, plan) && roadside::is_clear(zones.trunks, plan) &&
           roadside::is_clear(zones.doors, plan) && roadside::is_clear(zones.lamps, plan) &&
           !overlaps_any(zones.things, plan, 0) && !overlaps_any(standing, plan, 0) &&
           box.contains_half_open(plan.at) && std::ranges::none_of(made, [&](const things::Thing& other) {
             return overlap(roadside::plan_of(other), plan, 0);
           });
  }

  // The things of one front look alike.
  void add(const OrientedRect& plan, const FrontThingKind& kind, const buildings::Building& building, double draw) {
    made.push_back({.id = {building.id.osm, static_cast<std::uint32_t>(made.size())},
                    .at = plan.at,
                    .direction = things::nearest_direction(plan.ahead),
                    .form = {.kind = std::string(kind.name),
                             .width_m = snapped(kind.width_m),
                             .depth_m = snapped(kind.depth_m),
                             .height_m = snapped(kind.height_m),
                             .variant = look_of(draw)}});
  }

  // Adds things of a kind along a front, and returns their number.
  std::uint32_t line_up(const buildings::Building& building, const FrontLine& line, const FrontThingKind& kind,
                        double draw) {
    const bool is_single = kind.name == "a_board";
    std::uint32_t count = 0;
    for (const FrontSpan& span : spans_of(line))
      for (double at_m = span.from_m; at_m + kind.width_m <= span.to_m && count < kMostAtFront;
           at_m += kind.width_m + kBetween_m) {
        const double middle_m = at_m + kind.width_m / 2;
        const OrientedRect plan{
            .at = snapped(line.from + line.along * middle_m + line.outward * (kFromWall_m + kind.depth_m / 2)),
            .ahead = line.outward,
            .length_m = kind.depth_m,
            .width_m = kind.width_m};
        if (!has_room(line, middle_m, kind) || !is_free(plan)) continue;
        add(plan, kind, building, draw);
        if (++count == 1 && is_single) return count;
      }
    return count;
  }

  void dress(const buildings::Building& building, const buildings::Front& front, double draw) {
    const FrontLine line = line_of(building, front);
    const double look = draw;
    for (const FrontThingKind& kind : things::kFrontThings) {
      if (kind.front != front.kind) continue;
      // a front without room for the larger kind may have the next one
      if (draw * 100 < kind.percent && line_up(building, line, kind, look) > 0) return;
      if (draw * 100 >= kind.percent) draw -= kind.percent / 100;
    }
  }
};

}  // namespace

std::vector<things::Thing> front_things(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones,
                                        const RectIndex& standing, std::uint64_t seed, const Box2& box) {
  FrontDresser dresser{recipes, zones, standing, box};
  for (const buildings::Building& building : recipes.buildings) {
    const RandomSequence draws(seed, stable_id(building.id), "before fronts");
    for (std::uint32_t i = 0; i < building.fronts.size(); ++i)
      if (building.fronts[i].edge < building.footprint.outer.size())
        dresser.dress(building, building.fronts[i], draws.unit(i));
  }
  return std::move(dresser.made);
}

}  // namespace citykiln::furniture
