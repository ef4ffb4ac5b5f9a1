#include "compiler/lots/fill_lots.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "compiler/contract/random_sequence.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/snap.h"
#include "compiler/lots/house_room.h"
#include "compiler/lots/land_use.h"
#include "compiler/lots/mapped_things.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/parcels/divide.h"
#include "grammars/derivation/derive.h"

namespace citykiln::lots {
namespace {

using map::BuildingClass;
using map::CountryGroup;

// The group of rows for all groups without rows of their own.
constexpr auto kAnyGroup = CountryGroup::kCount;
// Houses keep these distances from mapped things and from pavements, which is tested at places this far apart.
constexpr double kHouseToMapped_m = 1, kHouseToPavement_m = 0.2, kTestStep_m = 1;
// A body whose bottom is lower than this stands on the ground.
constexpr double kOnGround_m = 0.01;
constexpr double kStorey_m = 3;
// A house has a few shapes: rules that go on without an end stop soon.
constexpr grammars::Limits kLimits{.depth = 32, .shapes = 2000, .steps = 200'000};

struct HouseRow {
  CountryGroup group;
  std::uint32_t weight;
  const char* rules;
  std::uint32_t least_levels, most_levels;
  RoomSizes room;
};

constexpr HouseRow kHouseRows[] = {
#define HOUSES(group, weight, rules, least, most, setback, beside, width, depth) \
  {CountryGroup::group, weight, rules, least, most, {setback, beside, width, depth}},
#define HOUSES_ANYWHERE(weight, rules, least, most, setback, beside, width, depth) \
  {kAnyGroup, weight, rules, least, most, {setback, beside, width, depth}},
#include "compiler/lots/houses.inc"
};

// The row for a side of a street.
const HouseRow& row_for(CountryGroup group, const RandomSequence& draw, std::uint32_t side) {
  const auto weight_of = [](CountryGroup of) {
    std::uint32_t sum = 0;
    for (const HouseRow& row : kHouseRows) sum += row.group == of ? row.weight : 0;
    return sum;
  };
  if (weight_of(group) == 0) group = kAnyGroup;
  std::uint32_t drawn = draw.below(weight_of(group), side);
  for (const HouseRow& row : kHouseRows) {
    if (row.group != group) continue;
    if (drawn < row.weight) return row;
    drawn -= row.weight;
  }
  return kHouseRows[0];
}

std::optional<BuildingClass> class_named(std::string_view terminal) {
  if (terminal.ends_with('.')) terminal.remove_suffix(1);
  constexpr std::pair<std::string_view, BuildingClass> kNames[] = {{"House", BuildingClass::kHouse},
                                                                   {"Flats", BuildingClass::kApartments},
                                                                   {"Shop", BuildingClass::kShop},
                                                                   {"Garage", BuildingClass::kGarage}};
  const auto found = std::ranges::find(kNames, terminal, &std::pair<std::string_view, BuildingClass>::first);
  return found == std::end(kNames) ? std::nullopt : std::optional(found->second);
}

// A face in the plane, counter-clockwise; nothing if it has no area.
std::optional<Polygon> plan_of(const grammars::Face& face) {
  const auto flat = [](const grammars::Ring3& ring, bool is_outer) {
    Ring plan;
    for (const Vec3 p : ring)
      if (const Vec2 at = snapped(Vec2{p.x, p.y}); plan.empty() || plan.back() != at) plan.push_back(at);
    if (plan.size() > 1 && plan.front() == plan.back()) plan.pop_back();
    if ((signed_area_m2(plan) > 0) != is_outer) std::ranges::reverse(plan);
    return plan;
  };
  Polygon plan{.outer = flat(face.outer, true), .holes = {}};
  for (const grammars::Ring3& hole : face.holes) plan.holes.push_back(flat(hole, false));
  if (plan.outer.size() < 3 || signed_area_m2(plan.outer) <= 0) return std::nullopt;
  return plan;
}

// A body that the rules made.
struct Body {
  Polygon plan;
  double height_m;
  BuildingClass building_class;
};

std::optional<Body> body_of(const grammars::Terminal& terminal) {
  const std::optional<BuildingClass> own = class_named(terminal.name);
  if (!own) return std::nullopt;
  const grammars::Face* bottom = nullptr;
  double height_m = 0;
  for (const grammars::Face& face : terminal.faces) {
    bool is_on_ground = !face.outer.empty();
    for (const Vec3 p : face.outer) is_on_ground &= std::abs(p.z) <= kOnGround_m, height_m = std::max(height_m, p.z);
    if (is_on_ground) bottom = &face;
  }
  const std::optional<Polygon> plan = bottom ? plan_of(*bottom) : std::nullopt;
  if (!plan || height_m < 1) return std::nullopt;
  return Body{*plan, height_m, *own};
}

struct LotFiller {
  const map::FeatureView& features;
  const MapLand& land;
  const LotInputs& inputs;
  const HouseRules& rules;
  LandUse uses = index_land_use(features);
  MappedThings mapped = mapped_things(features, inputs.roads, inputs.junctions, inputs.private_ways);

  bool is_free(Vec2 p) const {
    if (is_inside_any(mapped.buildings, p) || is_inside_any(mapped.pools, p)) return false;
    for (const Capsules* things : {&mapped.walls, &mapped.paths, &mapped.drives, &mapped.barriers, &mapped.trees,
                                   &mapped.wires, &mapped.parking})
      if (clearance_m(*things, p, kHouseToMapped_m) < kHouseToMapped_m) return false;
    return clearance_m(mapped.roads, p, kHouseToPavement_m) >= kHouseToPavement_m;
  }

  bool is_free(const Frame& frame, const Box2& box) const {
    const auto steps = [](double length) { return std::max(1, static_cast<int>(std::ceil(length / kTestStep_m))); };
    const int columns = steps(box.width()), rows = steps(box.height());
    for (int i = 0; i <= columns; ++i)
      for (int j = 0; j <= rows; ++j)
        if (!is_free(frame.plane({box.min.x + box.width() * i / columns, box.min.y + box.height() * j / rows})))
          return false;
    return true;
  }

  std::vector<Body> bodies_on(const Polygon& rectangle, const parcels::Lot& lot, const HouseRow& row) const {
    const RandomSequence draw(inputs.seed, lot.id, "house");
    const std::uint32_t levels = row.least_levels + draw.below(row.most_levels - row.least_levels + 1, 0);
    grammars::DeriveOptions options;
    options.start = "Lot";
    options.attributes = {{"levels", static_cast<double>(levels)}};
    options.seed = inputs.seed;
    options.limits = kLimits;
    const grammars::Derivation derived =
        grammars::derive(rules.at(row.rules), grammars::lot(rectangle, 0, 0, lot.id, {0}), options);
    std::vector<Body> bodies;
    for (const grammars::Terminal& terminal : derived.terminals)
      if (std::optional<Body> body = body_of(terminal)) bodies.push_back(std::move(*body));
    return bodies;
  }

  const roads::Road& road_of(const parcels::Lot& lot) const { return inputs.roads[land.roads[lot.frontage.line]]; }

  // By the land use, or by the street where none is mapped.
  bool is_residential(const parcels::Lot& lot, Vec2 middle) const {
    const map::LandCoverClass use = land_use_at(uses, middle), street = road_of(lot).surface;
    return use == map::LandCoverClass::kResidential ||
           (use == map::LandCoverClass::kUnknown && street == map::LandCoverClass::kResidentialRoad);
  }

  std::vector<map::Footprint> houses_on(const parcels::Lot& lot) const {
    const Vec2 middle = centroid(lot.polygon);
    if (!lot.footprints.empty() || !is_residential(lot, middle)) return {};
    const parcels::Line& line = land.land.lines[lot.frontage.line];
    const std::optional<Frame> frame = frame_of(lot.frontage, line, middle);
    if (!frame) return {};
    const CountryGroup country = road_of(lot).country;
    const HouseRow& row =
        row_for(country, {inputs.seed, line.id, "houses"}, static_cast<std::uint32_t>(lot.frontage.side));
    RoomSizes sizes = row.room;
    sizes.setback_m += kUnderPavement_m;
    const std::optional<Box2> room = room_for_house(lot.polygon, *frame, sizes);
    if (!room || !is_free(*frame, *room)) return {};
    return footprints_of(bodies_on(plane_rectangle(*frame, *room), lot, row), lot, country);
  }

  static std::vector<map::Footprint> footprints_of(std::vector<Body> bodies, const parcels::Lot& lot,
                                                   CountryGroup country) {
    // 44 bits: exact in outputs that hold numbers of double precision, and short in manifests
    const auto number = static_cast<std::int64_t>(static_cast<std::uint64_t>(lot.id) >> 20);
    std::vector<map::Footprint> footprints;
    for (Body& body : bodies) {
      map::Footprint& made = footprints.emplace_back();
      made.id = {{OsmType::kLot, number}, static_cast<std::uint32_t>(footprints.size() - 1)};
      made.polygon = std::move(body.plan);
      made.height_m = body.height_m;
      made.levels = std::max(1.0, std::round(body.height_m / kStorey_m));
      made.building_class = static_cast<std::uint8_t>(body.building_class);
      made.country = country;
      made.assumed = bit_of(Assumption::kHouses);
    }
    return footprints;
  }
};

}  // namespace

Result<HouseRules> read_house_rules(const grammars::Loader& load) {
  HouseRules rules;
  for (const HouseRow& row : kHouseRows) {
    if (rules.contains(row.rules)) continue;
    Result<grammars::Program> program = grammars::read_rules(row.rules, load);
    if (!program) return program.error();
    rules.emplace(row.rules, std::move(*program));
  }
  return rules;
}

std::vector<map::Footprint> with_houses(const map::FeatureView& features, const LotInputs& inputs,
                                        const HouseRules& rules, Report& report) {
  MapLand land = land_of(features, inputs.roads, inputs.private_ways);
  land.land.split_empty = true;
  const parcels::Parcels parcels = parcels::divide(land.land, inputs.threads);
  const LotFiller filler{features, land, inputs, rules};
  const auto houses = for_each_slot<std::vector<map::Footprint>>(
      parcels.lots.size(), inputs.threads, [&](std::size_t i) { return filler.houses_on(parcels.lots[i]); });
  std::vector<map::Footprint> all(features.footprints.begin(), features.footprints.end());
  for (const std::vector<map::Footprint>& of_lot : houses)
    for (const map::Footprint& house : of_lot) {
      if (!features.extent.contains(centroid(house.polygon))) continue;
      all.push_back(house);
      report.count_assumed(Assumption::kHouses, house.id.osm);
    }
  std::ranges::stable_sort(all, {}, &map::Footprint::id);
  return all;
}

}  // namespace citykiln::lots
