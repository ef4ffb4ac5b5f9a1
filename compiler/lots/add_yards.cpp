#include "compiler/lots/add_yards.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/for_each_slot.h"
#include "compiler/geometry/centroid.h"
#include "compiler/lots/border_yards.h"
#include "compiler/lots/plant_yard.h"

namespace citykiln::lots {
namespace {

using map::BarrierKind;

// Parts of ids of one building: areas and plants are numbered, barriers have room for pieces at the extent's border.
constexpr std::uint32_t kPartsOfBuilding = 256, kPartsOfBarrier = 4, kEntrancePart = 255;

// The name that rows of bays have in pitches/fields.inc.
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
