#include "compiler/bake/place_generated.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "compiler/bake/ground_on_top.h"
#include "compiler/bake/place_people.h"
#include "compiler/cars/car_mesh.h"
#include "compiler/cars/moving_cars.h"
#include "compiler/cars/parked_cars.h"
#include "compiler/furniture/front_things.h"
#include "compiler/furniture/plot_fences.h"
#include "compiler/furniture/road_things.h"
#include "compiler/furniture/street_furniture.h"
#include "compiler/furniture/street_trees.h"
#include "compiler/furniture/utility_poles.h"
#include "compiler/furniture/yard_things.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/countries/country_group.h"
#include "compiler/people/people.h"
#include "compiler/plants/species_mix.h"
#include "compiler/things/facing.h"
#include "compiler/things/generate.h"
#include "compiler/things/yard_kinds.h"

namespace citykiln::bake {
namespace {

static_assert(roadside::kHalo_m <= scene::kHalo_m);

roadside::TileRecipes recipes_of(const scene::Header& header, const scene::Chunk& chunk, const TileGround& ground) {
  return {.roads = chunk.roads,
          .junctions = chunk.junctions,
          .yards = chunk.yards,
          .plots = ground.plots,
          .pitches = chunk.pitches,
          .trunks = ground.trunks,
          .things = chunk.things,
          .lamps = ground.lamps.standing,
          .barriers = chunk.barriers,
          .buildings = chunk.buildings,
          .land_cover = ground.land_cover,
          .tile_m = header.tile_m};
}

// The steepest ground on which cars stand, along them and across.
constexpr double kSteepestAlong = 0.25, kSteepestAcross = 0.125;

// A car on its wheels: the heights below them decide its height and its slopes along and across. None where the ground
// is steeper.
std::optional<PlacedThing> stand(const things::Thing& car, const ground::LandCoverIndex& land_cover,
                                 const ground::GradedTerrain& graded) {
  constexpr double kAxle = 0.31, kWheel = 0.42;
  const Vec2 ahead = things::unit_vector(car.direction), left = left_of(ahead);
  const double axle_m = kAxle * car.form.depth_m, wheel_m = kWheel * car.form.width_m;
  std::array<double, 4> z_m{};  // front left, front right, rear left, rear right
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 wheel = ahead * (i < 2 ? axle_m : -axle_m) + left * (i % 2 == 0 ? wheel_m : -wheel_m);
    z_m[i] = ground_on_top_m(land_cover, graded, car.at + wheel);
  }
  const double along = (z_m[0] + z_m[1] - z_m[2] - z_m[3]) / (4 * axle_m),
               across = (z_m[0] + z_m[2] - z_m[1] - z_m[3]) / (4 * wheel_m);
  if (std::abs(along) > kSteepestAlong || std::abs(across) > kSteepestAcross) return std::nullopt;
  const double middle_m = (z_m[0] + z_m[1] + z_m[2] + z_m[3]) / 4;
  const Vec2 slope = ahead * along + left * across;
  // the mesh faces -y
  return PlacedThing{.form = car.form,
                     .placement = {.at = at_height(car.at, snapped(middle_m)),
                                   .cos_yaw = left.x,
                                   .sin_yaw = left.y,
                                   .feature = car.id.osm},
                     .up = unit(Vec3{-slope.x, -slope.y, 1}),
                     .source = ThingSource::kCar};
}

cars::CarSettings car_settings_of(const scene::Header& header) {
  return {.share = header.cars,
          .time = scene::week_time_of(header),
          .country = map::country_group_at(header.origin),
          .seed = header.seed};
}

bool has_rules(const scene::Header& header, const things::Form& form) {
  return std::ranges::any_of(header.things, [&](const buildings::RuleText& text) { return text.name == form.kind; });
}

PlacedThing upright(const things::Thing& thing, const TileGround& ground) {
  return {.form = thing.form, .placement = things::place(thing, ground.graded), .source = ThingSource::kFurniture};
}

// How far the ground rises above the foot of a thing, below it.
double rise_m(const things::Thing& thing, const Placement& foot, const ground::GradedTerrain& graded) {
  double most_m = 0;
  for (const Vec2 corner : corners_of(roadside::plan_of(thing)))
    most_m = std::max(most_m, land_m(graded, corner) - foot.at.z);
  return most_m;
}

// The species of a street's trees. They do not stand in groups as wild ones do.
plants::SpeciesMix street_species(const scene::Header& header, const TileGround& ground, Vec2 foot, double street) {
  const plants::Habitat habitat =
      plants::habitat_at(climate::climate_mix_at(header.climate, foot), header.origin.lat_deg, {},
                         land_m(ground.graded, foot), {0, 0, 1}, false);
  const auto community = plants::species_mix_of(plants::PlantCommunity::kTownTrees);
  return plants::species_mix_of(plants::draw_species(community, habitat, header.seed, street));
}

// All that a tile's things are drawn from.
struct Generator {
  const scene::Header& header;
  const TileGround& ground;
  const Box2& box;
  roadside::TileRecipes recipes;
  roadside::ClearZones zones = roadside::clear_zones_of(recipes);
  GeneratedThings made{};

  // A car and its parts.
  void add_car(PlacedThing car) {
    made.placed.push_back(car);
    car.form = cars::parts_of(car.form);
    made.placed.push_back(std::move(car));
  }

  void add_cars() {
    for (const things::Thing& car : cars::parked_cars(recipes, zones, car_settings_of(header), box))
      if (std::optional<PlacedThing> standing = stand(car, ground.land_cover, ground.graded))
        add_car(std::move(*standing));
  }

  void add_traffic() {
    const cars::TrafficSettings traffic{header.traffic, scene::week_time_of(header), header.seed};
    for (const things::Thing& car : cars::moving_cars(recipes, zones, traffic, car_settings_of(header), box))
      if (std::optional<PlacedThing> standing = stand(car, ground.land_cover, ground.graded))
        add_car(std::move(*standing));
  }

  void add_upright(std::span<const things::Thing> pieces) {
    for (const things::Thing& piece : pieces)
      if (has_rules(header, piece.form)) made.placed.push_back(upright(piece, ground));
  }

  void add_furniture() {
    std::vector<OrientedRect> standing;
    const auto add = [&](const std::vector<things::Thing>& pieces) {
      for (const things::Thing& piece : pieces) standing.push_back(roadside::plan_of(piece));
      add_upright(pieces);
    };
    add(furniture::street_furniture(recipes, zones, header.seed, box));
    add(furniture::front_things(recipes, zones, index_rects(standing), header.seed, box));
    add(furniture::things_of_walked_streets(recipes, zones, index_rects(standing), header.seed, box));
  }

  void add_yard_things() {
    std::vector<things::Thing> all = furniture::yard_things(recipes, zones, header.seed, box);
    std::ranges::move(furniture::plot_fences(recipes, header.seed, box), std::back_inserter(all));
    add_on_even_ground(all);
  }

  void add_on_even_ground(std::span<const things::Thing> things) {
    constexpr double kMostRise_m = 0.4;
    for (const things::Thing& thing : things) {
      if (!has_rules(header, thing.form)) continue;
      PlacedThing placed = upright(thing, ground);
      if (rise_m(thing, placed.placement, ground.graded) <= kMostRise_m) made.placed.push_back(std::move(placed));
    }
  }

  void add_cranes() {
    std::vector<things::Thing> all = furniture::plot_fences(recipes, header.seed, box);
    std::erase_if(all, [](const things::Thing& thing) { return thing.form.kind != things::kSiteCrane; });
    add_on_even_ground(all);
  }

  void add_poles() {
    const furniture::UtilityPoles line = furniture::utility_poles(recipes, zones, header.seed, box);
    if (line.poles.empty() || !has_rules(header, line.poles.front().form)) return;
    std::vector<Placement> feet;
    for (const things::Thing& pole : line.poles) {
      PlacedThing placed = upright(pole, ground);
      feet.push_back(placed.placement);
      if (box.contains_half_open(pole.at)) made.placed.push_back(std::move(placed));
    }
    for (const furniture::PoleSpan& span : line.spans)
      made.pole_spans.push_back({span.id, line.poles[span.from].form, feet[span.from], feet[span.to]});
  }
};

}  // namespace

std::vector<plants::Tree> trees_with_street_trees(const scene::Header& header, const scene::Chunk& chunk,
                                                  const TileGround& ground, const Box2& box) {
  std::vector<plants::Tree> trees = chunk.trees;
  if (!header.has_street_furniture) return trees;
  const roadside::TileRecipes recipes = recipes_of(header, chunk, ground);
  const auto draw_species = [&](Vec2 foot, double street) { return street_species(header, ground, foot, street); };
  std::ranges::copy(
      furniture::street_trees(recipes, roadside::clear_zones_of(recipes),
                              {.trees = chunk.trees, .rows = chunk.tree_rows}, draw_species, header.seed, box),
      std::back_inserter(trees));
  return trees;
}

double leave_out_drawn(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m,
                       std::vector<PlacedThing>& things) {
  if (!scene::shows(header, scene::SceneLayer::kThings)) return 0;
  double highest_m = 0;
  const auto leave_out = [&](bool may_be_there, double height_m, auto is_kind) {
    if (tolerance_m < height_m || !may_be_there) return;
    std::erase_if(things, is_kind);
    highest_m = std::max(highest_m, height_m);
  };
  const auto is_from = [](ThingSource source) {
    return [source](const PlacedThing& thing) { return thing.source == source; };
  };
  const auto is_crane = [](const PlacedThing& thing) {
    return thing.source == ThingSource::kFurniture && thing.form.kind == things::kSiteCrane;
  };
  leave_out(people::has_people(header.people), kShowsPeople_m, is_from(ThingSource::kPerson));
  leave_out(cars::has_cars(header.cars) || cars::has_cars(header.traffic), kShowsCars_m, is_from(ThingSource::kCar));
  leave_out(header.has_street_furniture || !chunk.yards.empty(), kShowsFurniture_m,
            [&](const PlacedThing& thing) { return thing.source == ThingSource::kFurniture && !is_crane(thing); });
  leave_out(has_rules(header, {.kind = std::string(things::kSiteCrane)}), kShowsCranes_m, is_crane);
  return highest_m;
}

GeneratedThings place_generated(const scene::Header& header, const scene::Chunk& chunk, const TileGround& ground,
                                const Box2& box, const WantedThings& wanted) {
  if (!wanted.cars && !wanted.furniture && !wanted.cranes) return {};
  Generator generator{header, ground, box, recipes_of(header, chunk, ground)};
  if (wanted.cars && cars::has_cars(header.cars)) generator.add_cars();
  if (wanted.cars && cars::has_cars(header.traffic)) generator.add_traffic();
  if (wanted.furniture) generator.add_yard_things();
  if (wanted.cranes && !wanted.furniture) generator.add_cranes();
  if (wanted.furniture) generator.add_upright(furniture::refuges(generator.recipes, box));
  if (wanted.furniture && header.has_street_furniture) generator.add_furniture(), generator.add_poles();
  return std::move(generator.made);
}

}  // namespace citykiln::bake
