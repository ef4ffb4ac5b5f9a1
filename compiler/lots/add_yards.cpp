#include "compiler/lots/add_yards.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/lots/border_yards.h"

namespace citykiln::lots {
namespace {

using map::BarrierKind;

// Plants trees and shrubs in yards.

// A plant of a yard.
struct YardPlant {
  Vec2 at;  ///< Snapped.
  bool is_shrub = false;
  double height_m = 0;  ///< 0: as usual for its species.
};

// The most plants of a yard. Squares are filled row by row from the south; beyond that, the north stays empty.
constexpr std::size_t kMostPlants = 48;
constexpr double kSquare_m = 4, kMostMoved_m = 1.2;
constexpr double kTreeToWall_m = 3, kShrubToWall_m = 2, kToWay_m = 1, kToBorder_m = 0.75, kToTree_m = 2;

// Shrubs of gardens, as they are kept.
constexpr double kLeastShrub_m = 0.75, kHighestShrub_m = 1.75;

// Draws of one square: their first index follows from the square, within the lot.
constexpr std::uint32_t kDraws = 4, kFirstDraw = 16;

struct Planter {
  const Lot& lot;
  const YardRule& rule;
  std::span<const map::Barrier> barriers;
  const BorderObstacles& obstacles;

  map::LandCoverClass surface_at(Vec2 p) const {
    const bool is_front = rule.front != rule.rear && lot.frame.local(p).y <= lot.setback_m;
    return is_front ? rule.front : rule.rear;
  }

  bool is_off_ways(Vec2 p) const {
    const MappedThings& mapped = obstacles.mapped;
    for (const Capsules* ways : {&mapped.roads, &mapped.paths, &mapped.drives, &obstacles.openings})
      if (clearance_m(*ways, p, kToWay_m) < kToWay_m) return false;
    return true;
  }

  bool is_off_barriers(Vec2 p) const {
    return clearance_m(obstacles.mapped.barriers, p, kToBorder_m) >= kToBorder_m &&
           std::ranges::none_of(barriers, [&](const map::Barrier& barrier) {
             return distance_to_polyline(barrier.axis, p) < kToBorder_m;
           });
  }

  bool is_place(Vec2 p, bool is_shrub) const {
    const MappedThings& mapped = obstacles.mapped;
    const double to_wall_m = is_shrub ? kShrubToWall_m : kTreeToWall_m;
    return contains(lot.parcel.polygon, p) && is_planted(surface_at(p)) &&
           distance_to_ring(lot.parcel.polygon.outer, p) >= kToBorder_m &&
           clearance_m(mapped.walls, p, to_wall_m) >= to_wall_m && !is_inside_any(mapped.buildings, p) &&
           !is_inside_any(mapped.pools, p) && is_off_ways(p) && is_off_barriers(p) &&
           clearance_m(mapped.wires, p, 0.25) > 0 && clearance_m(mapped.junction_zones, p, 0.25) > 0 &&
           !is_inside_any(mapped.corners, p) && clearance_m(mapped.trees, p, kToTree_m) >= kToTree_m;
  }

  bool has_mapped_tree() const {
    const Capsules& trees = obstacles.mapped.trees;
    return !trees.all.empty() &&
           std::ranges::any_of(boxes_about(trees.grid, box_of(lot.parcel.polygon.outer)), [&](std::uint32_t i) {
             return contains(lot.parcel.polygon, trees.all[i].a) || contains(lot.parcel.polygon, trees.all[i].b);
           });
  }
};

// A number of a square that does not depend on the lot's extent.
std::uint32_t draw_index(std::int64_t column, std::int64_t row) {
  const auto square = static_cast<std::uint32_t>((column & 0x3fff) << 14 | (row & 0x3fff));
  return kFirstDraw + kDraws * square;
}

// Returns the plants of a yard: one candidate in the middle of each square of 4 m of a grid of the plane, moved at
// random by up to 1.2 m, so that two are at least 1.6 m apart. A candidate is kept with the rule's density on lawn,
// gravel and earth. It stands at least
//
// - 3 m (shrubs 2 m) from walls: a crown of 2 m reaches no roof, and eaves are at most 1.5 m wide;
// - 1 m from pavements, paths and drives, 0.75 m from barriers and the lot's border, 2 m from mapped trees;
// - outside of pools, of the corridors of wires (kClearOfWires_m) of the zones about junctions (kSight_m), and of
//   the surfaces of junctions and the outer corners of bends.
// No trees stand where one is mapped in the lot.
// @param barriers  The barriers of the lot (barriers_of()).
// @param draw      The random numbers of the lot; indices from 16 on are used.
std::vector<YardPlant> plants_of(const Lot& lot, const YardRule& rule, std::span<const map::Barrier> barriers,
                                 const BorderObstacles& obstacles, const RandomSequence& draw) {
  std::vector<YardPlant> plants;
  const double per_square = (rule.trees + rule.shrubs) * kSquare_m * kSquare_m / 100;
  if (per_square <= 0) return plants;
  const Planter planter{lot, rule, barriers, obstacles};
  const bool has_tree = planter.has_mapped_tree();
  const Box2 box = box_of(lot.parcel.polygon.outer);
  const auto first = [](double v) { return static_cast<std::int64_t>(std::floor(v / kSquare_m)); };
  for (std::int64_t row = first(box.min.y); row <= first(box.max.y); ++row)
    for (std::int64_t column = first(box.min.x); column <= first(box.max.x); ++column) {
      const std::uint32_t index = draw_index(column, row);
      const double kept = draw.unit(index);
      if (kept >= per_square || plants.size() >= kMostPlants) continue;
      const bool is_shrub = kept >= rule.trees * kSquare_m * kSquare_m / 100;
      const Vec2 moved{draw.between(-kMostMoved_m, kMostMoved_m, index + 1),
                       draw.between(-kMostMoved_m, kMostMoved_m, index + 2)};
      const Vec2 at = snapped(
          Vec2{(static_cast<double>(column) + 0.5) * kSquare_m, (static_cast<double>(row) + 0.5) * kSquare_m} + moved);
      if ((!is_shrub && has_tree) || !planter.is_place(at, is_shrub)) continue;
      const double height_m = is_shrub ? draw.between(kLeastShrub_m, kHighestShrub_m, index + 3) : 0;
      plants.push_back({at, is_shrub, std::floor(height_m * 8) / 8});
    }
  return plants;
}

// Parts of ids of one building: areas and plants are numbered, barriers have room for pieces at the extent's border.
constexpr std::uint32_t kPartsOfBuilding = 256, kPartsOfBarrier = 4, kEntrancePart = 255;

// The name that rows of bays have in pitches/pitches.inc.
constexpr const char* kBays = "parking";

double width_of(BarrierKind kind) {
  switch (kind) {
    case BarrierKind::kHedge:
      return 0.625;
    case BarrierKind::kWall:
      return 0.25;
    default:
      return 0.125;
  }
}

// The yard of one lot.
struct Yard {
  YardGround ground;
  std::vector<map::Barrier> barriers{};
  std::vector<YardPlant> plants{};
};

Capsules street_fronts(const std::vector<parcels::Line>& lines) {
  std::vector<Capsule> strips;
  for (const parcels::Line& line : lines) {
    if (line.kind != parcels::LineKind::kStreet) continue;
    for (std::size_t i = 0; i + 1 < line.axis.size(); ++i) {
      const Vec2 a = line.axis[i], b = line.axis[i + 1];
      const Vec2 aside = left_of(unit(b - a)) * ((line.left_m - line.right_m) / 2);
      strips.push_back({a + aside, b + aside, (line.left_m + line.right_m) / 2});
    }
  }
  return index_capsules(std::move(strips));
}

bool wants_entrance(const Lot& lot, const map::Footprint& main) {
  return (lot.kind == LotKind::kDetached || lot.kind == LotKind::kRow) && lot.door && !lot.door->is_mapped &&
         !main.has_shop && !has(main.assumed, Assumption::kFronts);
}

struct YardMaker {
  const map::FeatureView& features;
  const LotInputs& inputs;
  const MapLand land;
  const std::vector<Lot> lots;
  const MappedThings mapped;
  std::vector<std::optional<YardRule>> rules{};

  RandomSequence draw_of(const Lot& lot) const {
    return {inputs.seed, stable_id(features.footprints[lot.main].id), "yard"};
  }

  std::vector<Yard> yards() {
    for (const Lot& lot : lots) rules.push_back(rule_for(lot, draw_of(lot)));
    auto yards = for_each_slot<Yard>(lots.size(), inputs.threads, [&](std::size_t i) {
      return rules[i] ? Yard{.ground = lay_yard(features, lots[i], *rules[i], mapped)} : Yard{};
    });
    std::vector<Capsule> openings;
    for (const Yard& yard : yards)
      openings.insert(openings.end(), yard.ground.openings.begin(), yard.ground.openings.end());
    const BorderObstacles obstacles{mapped, index_capsules(std::move(openings)), street_fronts(land.land.lines)};
    const SharedEdges edges = index_edges(lots);
    for_each_index(lots.size(), inputs.threads, [&](std::size_t i) {
      if (!rules[i]) return;
      yards[i].barriers = barriers_of(static_cast<std::uint32_t>(i), lots, rules, edges, obstacles);
      yards[i].plants = plants_of(lots[i], *rules[i], yards[i].barriers, obstacles, draw_of(lots[i]));
    });
    return yards;
  }
};

struct YardAdder {
  Yards& yards;

  void add(const Lot& lot, const Yard& yard) {
    const ObjectId building = yards.footprints[lot.main].id;
    const auto id_of = [&](std::uint32_t n) { return derived_id(building, kPartsOfBuilding, n); };
    std::uint32_t part = 0;
    for (const YardArea& area : yard.ground.areas) {
      const ObjectId id = id_of(part++);
      yards.areas.push_back(
          {.id = id, .polygon = area.polygon, .surface = area.surface, .area_m2 = area_m2(area.polygon)});
      if (area.has_bays) yards.sports_areas.push_back({id, kBays});
    }
    part = 0;
    for (std::size_t i = 0; i < yard.barriers.size() && i < kPartsOfBuilding / kPartsOfBarrier; ++i) {
      const map::Barrier& barrier = yard.barriers[i];
      yards.barriers.push_back({.id = id_of(part),
                                .axis = barrier.axis,
                                .kind = barrier.kind,
                                .height_m = barrier.height_m,
                                .width_m = width_of(barrier.kind)});
      part += kPartsOfBarrier;
    }
    part = 0;
    for (const YardPlant& plant : yard.plants) {
      const map::PlantKind kind = plant.is_shrub ? map::PlantKind::kBush : map::PlantKind::kUnknown;
      yards.points.push_back({.id = id_of(part++),
                              .at = plant.at,
                              .kind = map::PointKind::kTree,
                              .height_m = plant.height_m,
                              .plant_tags = {.kind = kind}});
    }
    if (wants_entrance(lot, yards.footprints[lot.main]))
      yards.points.push_back({.id = id_of(kEntrancePart), .at = lot.door->at, .kind = map::PointKind::kEntrance});
  }
};

// Car parks without mapped lanes have bays.
void add_bays(const MappedThings& mapped, Yards& yards, Report& report) {
  for (const map::AreaFeature& area : yards.areas) {
    if (area.surface != map::LandCoverClass::kParking || is_derived(area.id)) continue;
    if (axis_enters(mapped.roads, area.polygon) || axis_enters(mapped.drives, area.polygon)) continue;
    yards.sports_areas.push_back({area.id, kBays});
    report.count_assumed(Assumption::kYards, area.id.osm);
  }
}

MapLand land_with(const map::FeatureView& features, const LotInputs& inputs) {
  return land_of(features, inputs.roads, inputs.private_ways);
}

std::vector<Lot> lots_on(const map::FeatureView& features, const MapLand& land, const LotInputs& inputs) {
  return plan_lots(features, land, parcels::divide(land.land, inputs.threads), inputs.climate_at, inputs.threads);
}

// Yards belong to the extent by their building's centroid, as buildings do.
bool is_in_extent(const map::FeatureView& features, const Lot& lot) {
  return features.extent.contains(centroid(features.footprints[lot.main].polygon));
}

}  // namespace

std::vector<Lot> lots_of_map(const map::FeatureView& features, const LotInputs& inputs) {
  return lots_on(features, land_with(features, inputs), inputs);
}

map::FeatureView seen_with(map::FeatureView features, const Yards& yards) {
  features.footprints = yards.footprints, features.areas = yards.areas, features.sports_areas = yards.sports_areas;
  features.barriers = yards.barriers, features.points = yards.points;
  return features;
}

Yards with_yards(const map::FeatureView& features, const LotInputs& inputs, Report& report) {
  MapLand land = land_with(features, inputs);
  std::vector<Lot> lots = lots_on(features, land, inputs);
  YardMaker maker{features, inputs, std::move(land), std::move(lots),
                  mapped_things(features, inputs.roads, inputs.junctions, inputs.private_ways)};
  const std::vector<Yard> made = maker.yards();
  Yards yards{.footprints = {features.footprints.begin(), features.footprints.end()},
              .areas = {features.areas.begin(), features.areas.end()},
              .sports_areas = {features.sports_areas.begin(), features.sports_areas.end()},
              .barriers = {features.barriers.begin(), features.barriers.end()},
              .points = {features.points.begin(), features.points.end()}};
  YardAdder adder{yards};
  for (std::size_t i = 0; i < made.size(); ++i) {
    const Lot& lot = maker.lots[i];
    if (!maker.rules[i] || !is_in_extent(features, lot)) continue;
    adder.add(lot, made[i]);
    map::Footprint& main = yards.footprints[lot.main];
    main.assumed |= bit_of(Assumption::kYards);
    report.count_assumed(Assumption::kYards, main.id.osm);
  }
  add_bays(maker.mapped, yards, report);
  std::ranges::stable_sort(yards.areas, {}, &map::AreaFeature::id);
  std::ranges::stable_sort(yards.sports_areas, {}, &map::SportsArea::id);
  std::ranges::stable_sort(yards.barriers, {}, &map::Barrier::id);
  std::ranges::stable_sort(yards.points, {}, &map::PointFeature::id);
  return yards;
}

}  // namespace citykiln::lots
