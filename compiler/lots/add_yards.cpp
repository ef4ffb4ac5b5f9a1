#include "compiler/lots/add_yards.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/segment.h"
#include "compiler/lots/border_yards.h"
#include "compiler/lots/draw_yard.h"
#include "compiler/lots/lay_yard.h"

namespace citykiln::lots {
namespace {

// The most plants of a yard. Squares are filled row by row from the south; beyond that, the north stays empty.
constexpr std::size_t kMostPlants = 48;
constexpr double kTreeToWall_m = 3, kShrubToWall_m = 2, kToWay_m = 1, kToBorder_m = 0.75, kToTree_m = 2;
// The part of an entrance's id: the last one of a yard.
constexpr std::uint32_t kEntrancePart = kPartsOfYard - 1;

// Decides which plants of a yard stand.
struct Planter {
  const Polygon& lot;
  std::span<const Polyline> barriers;
  const BorderObstacles& obstacles;

  bool is_off_ways(Vec2 p) const {
    const MappedThings& mapped = obstacles.mapped;
    for (const Capsules* ways : {&mapped.roads, &mapped.paths, &mapped.drives, &obstacles.openings})
      if (clearance_m(*ways, p, kToWay_m) < kToWay_m) return false;
    return true;
  }

  bool is_off_barriers(Vec2 p) const {
    return clearance_m(obstacles.mapped.barriers, p, kToBorder_m) >= kToBorder_m &&
           std::ranges::none_of(barriers,
                                [&](const Polyline& axis) { return distance_to_polyline(axis, p) < kToBorder_m; });
  }

  bool is_place(Vec2 p, bool is_shrub) const {
    const MappedThings& mapped = obstacles.mapped;
    const double to_wall_m = is_shrub ? kShrubToWall_m : kTreeToWall_m;
    return clearance_m(mapped.walls, p, to_wall_m) >= to_wall_m && !is_inside_any(mapped.buildings, p) &&
           !is_inside_any(mapped.pools, p) && is_off_ways(p) && is_off_barriers(p) &&
           clearance_m(mapped.wires, p, 0.25) > 0 && clearance_m(mapped.junction_zones, p, 0.25) > 0 &&
           !is_inside_any(mapped.corners, p) && clearance_m(mapped.trees, p, kToTree_m) >= kToTree_m;
  }

  bool has_mapped_tree() const {
    const Capsules& trees = obstacles.mapped.trees;
    return !trees.all.empty() && std::ranges::any_of(boxes_about(trees.grid, box_of(lot.outer)), [&](std::uint32_t i) {
      return contains(lot, trees.all[i].a) || contains(lot, trees.all[i].b);
    });
  }
};

// Returns for each plant that the seed draws in a yard whether it stands. It does at least
//
// - 3 m (shrubs 2 m) from walls: a crown of 2 m reaches no roof, and eaves are at most 1.5 m wide;
// - 1 m from pavements, paths and drives, 0.75 m from barriers, 2 m from mapped trees;
// - outside of pools, of the corridors of wires (kClearOfWires_m), of the zones about junctions (kSight_m), and of
//   the surfaces of junctions and the outer corners of bends.
// No trees stand where one is mapped in the lot.
// @param yard  With its borders.
std::vector<bool> standing_plants(const Yard& yard, const YardRule& rule, const BorderObstacles& obstacles,
                                  std::uint64_t seed) {
  const std::vector<BorderSegment> segments = border_segments(yard.polygon.outer);
  std::vector<Polyline> barriers;
  for (const BorderRun& run : yard.borders) barriers.push_back(border_line(segments, run));
  const Planter planter{yard.polygon, barriers, obstacles};
  const bool has_tree = planter.has_mapped_tree();
  std::vector<bool> standing;
  std::size_t count = 0;
  for (const YardPlant& plant : plants_drawn(yard, rule, seed)) {
    const bool is_wanted = count < kMostPlants && (plant.is_shrub || !has_tree);
    standing.push_back(is_wanted && planter.is_place(plant.at, plant.is_shrub));
    count += standing.back();
  }
  return standing;
}

bool is_arid(climate::ClimateClass climate) {
  using enum climate::ClimateClass;
  return climate == kBSh || climate == kBSk || climate == kBWh || climate == kBWk;
}

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
  std::vector<std::optional<YardRule>> rules{};  // one for each lot, as `made` has

  // The yard of a lot without what stands and lies on it.
  Yard empty_yard(const Lot& lot) const {
    return {.building = features.footprints[lot.main].id,
            .country = lot.country,
            .kind = lot.kind,
            .is_arid = is_arid(lot.climate),
            .polygon = lot.parcel.polygon,
            .frame = lot.frame,
            .setback_m = lot.setback_m};
  }

  std::optional<YardRule> rule_for(const Yard& yard) const {
    const Box2 box = box_of(yard.polygon.outer);
    const bool is_fit = !box.is_empty() && std::max(box.width(), box.height()) <= kLargestYard_m;
    return is_fit ? rule_of(yard, inputs.seed) : std::nullopt;
  }

  // One yard for each lot; those without a rule stay empty.
  std::vector<Yard> yards() {
    std::vector<Yard> made;
    for (const Lot& lot : lots) rules.push_back(rule_for(made.emplace_back(empty_yard(lot))));
    for_each_index(lots.size(), inputs.threads, [&](std::size_t i) {
      if (!rules[i]) return;
      YardLayout layout = lay_yard(features, lots[i], *rules[i], mapped);
      made[i].strips = std::move(layout.strips), made[i].has_bays = layout.has_bays;
    });
    std::vector<Capsule> openings;
    for (const Yard& yard : made)
      for (const Capsule& opening : openings_of(yard)) openings.push_back(opening);
    const BorderObstacles obstacles{mapped, index_capsules(std::move(openings)), street_fronts(land.land.lines)};
    const SharedEdges edges = index_edges(lots);
    for_each_index(lots.size(), inputs.threads, [&](std::size_t i) {
      if (!rules[i]) return;
      made[i].borders = borders_of(static_cast<std::uint32_t>(i), lots, rules, edges, obstacles);
      made[i].plants = standing_plants(made[i], *rules[i], obstacles, inputs.seed);
    });
    return made;
  }
};

template <typename Feature>
void append(std::vector<Feature>& all, std::vector<Feature>&& more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

// Adds the features of a lot's yard, and its recipe.
void add_yard(const Lot& lot, Yard&& yard, std::uint64_t seed, Yards& yards) {
  DrawnYard drawn = draw_yard(yard, seed);
  append(yards.areas, std::move(drawn.areas)), append(yards.sports_areas, std::move(drawn.bays));
  append(yards.barriers, std::move(drawn.barriers)), append(yards.points, std::move(drawn.plants));
  map::Footprint& main = yards.footprints[lot.main];
  if (wants_entrance(lot, main))
    yards.points.push_back({.id = derived_id(main.id, kPartsOfYard, kEntrancePart),
                            .at = lot.door->at,
                            .kind = map::PointKind::kEntrance});
  main.assumed |= bit_of(Assumption::kYards);
  yards.recipes.push_back(std::move(yard));
}

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
  std::vector<Yard> made = maker.yards();
  Yards yards{.footprints = {features.footprints.begin(), features.footprints.end()},
              .areas = {features.areas.begin(), features.areas.end()},
              .sports_areas = {features.sports_areas.begin(), features.sports_areas.end()},
              .barriers = {features.barriers.begin(), features.barriers.end()},
              .points = {features.points.begin(), features.points.end()},
              .recipes = {}};
  for (std::size_t i = 0; i < made.size(); ++i) {
    const Lot& lot = maker.lots[i];
    if (!maker.rules[i] || !is_in_extent(features, lot)) continue;
    report.count_assumed(Assumption::kYards, made[i].building.osm);
    add_yard(lot, std::move(made[i]), inputs.seed, yards);
  }
  add_bays(maker.mapped, yards, report);
  std::ranges::stable_sort(yards.areas, {}, &map::AreaFeature::id);
  std::ranges::stable_sort(yards.sports_areas, {}, &map::SportsArea::id);
  std::ranges::stable_sort(yards.barriers, {}, &map::Barrier::id);
  std::ranges::stable_sort(yards.points, {}, &map::PointFeature::id);
  return yards;
}

}  // namespace citykiln::lots
