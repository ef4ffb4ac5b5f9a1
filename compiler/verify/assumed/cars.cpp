#include <array>
#include <optional>
#include <set>

#include "compiler/map/things/thing_role.h"
#include "compiler/verify/assumed/copies.h"
#include "compiler/verify/assumed/measure_assumed.h"

namespace citykiln::verify {
namespace {

using map::LandCoverGroup;

// The distance from a car to a door, and the width of a car's edge that may lie on other ground.
constexpr double kBeforeDoor_m = 1.25, kCarEdge_m = 0.3125;

// Ground on which no part of a car may be; others than mapped spaces must also be paved, or a yard.
bool is_ground_for_cars(const ground::LandCoverPolygon& surface, bool is_in_space) {
  switch (map::values_of(surface.surface).group) {
    case LandCoverGroup::kBuilding:
    case LandCoverGroup::kWater:
    case LandCoverGroup::kRail:
      return false;
    case LandCoverGroup::kRoad:
    case LandCoverGroup::kPaved:
      return true;
    default:
      return is_in_space || ground::is_yard(surface);
  }
}

// The element that bars a car: below a corner or its middle; none if its ground is free.
std::optional<OsmId> bar_of(const OrientedRect& plan, bool is_in_space, const ground::LandCoverIndex& land_cover) {
  const std::array<Vec2, 4> c = corners_of(plan);
  for (const Vec2 p : {c[0], c[1], c[2], c[3], plan.at}) {
    if (!land_cover.box.contains(p)) continue;
    const std::uint32_t top = ground::land_cover_at(land_cover, p);
    if (top == ground::kNoLandCover) {
      if (!is_in_space) return OsmId{};
    } else if (!is_ground_for_cars(land_cover.surfaces[top], is_in_space)) {
      return land_cover.surfaces[top].id.osm;
    }
  }
  return std::nullopt;
}

// The cars of a tile: their plans and elements.
struct CarCopies {
  RectIndex plans;
  std::vector<OsmId> elements;
};

CarCopies car_copies(const bake::BakedTile& tile, double edge_m) {
  CarCopies cars;
  std::vector<OrientedRect> plans;
  for (const bake::InstancedMesh& mesh : tile.instanced) {
    if (kind_of_mesh(mesh.name) != map::name_of(map::ThingRole::kCar)) continue;
    for (std::size_t i = 0; i < mesh.translations.size(); ++i) {
      plans.push_back(plan_of_copy(mesh, i, tile.origin, edge_m));
      cars.elements.push_back(tile.features[mesh.features[i]]);
    }
  }
  if (!plans.empty()) cars.plans = index_rects(std::move(plans));
  return cars;
}

// The element off the carriageways below a car; none if all of it is on them.
std::optional<OsmId> ground_beside(const OrientedRect& plan, const ground::LandCoverIndex& land_cover) {
  const std::array<Vec2, 4> c = corners_of(plan);
  for (const Vec2 p : {c[0], c[1], c[2], c[3], plan.at}) {
    if (!land_cover.box.contains(p)) continue;
    const std::uint32_t top = ground::land_cover_at(land_cover, p);
    if (top == ground::kNoLandCover) return OsmId{};
    const ground::LandCoverPolygon& surface = land_cover.surfaces[top];
    if (map::values_of(surface.surface).group != LandCoverGroup::kRoad &&
        surface.surface != map::LandCoverClass::kParking)
      return surface.id.osm;
  }
  return std::nullopt;
}

// True if a car stands on a yard or a plot.
bool is_on_yard(const OrientedRect& plan, const ground::LandCoverIndex& land_cover) {
  if (!land_cover.box.contains(plan.at)) return false;
  const std::uint32_t top = ground::land_cover_at(land_cover, plan.at);
  return top != ground::kNoLandCover && ground::is_yard(land_cover.surfaces[top]);
}

// Another car in which one stands.
std::optional<OsmId> car_about(const CarCopies& cars, std::uint32_t car) {
  std::optional<OsmId> other;
  any_about(cars.plans.grid, box_of(cars.plans.all[car]), [&](std::uint32_t i) {
    if (i == car || !overlap(cars.plans.all[i], cars.plans.all[car], 0)) return false;
    other = cars.elements[i];
    return true;
  });
  return other;
}

}  // namespace

AssumedTests measure_street_cars(const bake::BakedTile& tile, const scene::Chunk& chunk,
                                 const ground::LandCoverIndex& land_cover) {
  constexpr double kEdge_m = 0.25;
  std::set<OsmId> streets;
  for (const roads::Road& road : chunk.roads) streets.insert(road.id.osm);
  const CarCopies cars = car_copies(tile, kEdge_m);
  AssumedTests found;
  for (std::uint32_t i = 0; i < cars.elements.size(); ++i) {
    if (!streets.contains(cars.elements[i]) || is_on_yard(cars.plans.all[i], land_cover)) continue;
    ++found.tested;
    std::optional<OsmId> bar = ground_beside(cars.plans.all[i], land_cover);
    if (!bar) bar = car_about(cars, i);
    if (!bar || found.conflicts++ > 0) continue;
    found.at = cars.plans.all[i].at, found.element = cars.elements[i], found.obstacle = *bar;
  }
  return found;
}

AssumedTests measure_parked_cars(const bake::BakedTile& tile, const scene::Chunk& chunk,
                                 const ground::LandCoverIndex& land_cover) {
  std::set<OsmId> spaces;
  for (const things::Thing& thing : chunk.things)
    if (map::role_of(thing.form.kind) == map::ThingRole::kCar) spaces.insert(thing.id.osm);
  const Doors doors = doors_of(chunk, kBeforeDoor_m);
  AssumedTests found;
  for (const bake::InstancedMesh& mesh : tile.instanced) {
    if (kind_of_mesh(mesh.name) != map::name_of(map::ThingRole::kCar)) continue;
    for (std::size_t i = 0; i < mesh.translations.size(); ++i) {
      const OrientedRect plan = plan_of_copy(mesh, i, tile.origin, kCarEdge_m);
      const OsmId element = tile.features[mesh.features[i]];
      ++found.tested;
      std::optional<OsmId> bar = bar_of(plan, spaces.contains(element), land_cover);
      if (!bar && is_before_door(plan, doors)) bar = OsmId{};
      if (!bar) continue;
      if (found.conflicts++ == 0) found.at = plan.at, found.element = element, found.obstacle = *bar;
    }
  }
  return found;
}

}  // namespace citykiln::verify
