#include "compiler/people/people.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"
#include "compiler/people/groups.h"
#include "compiler/things/facing.h"

namespace citykiln::people {
namespace {

using map::LandCoverClass;

// Spots of the tile overlap those up to this far outside.
constexpr double kSpotOverlap_m = 2 * kSpotRadius_m;
constexpr double kTrunkRadius_m = 0.375;

const ground::LandCoverPolygon* polygon_on_top(const ground::LandCoverIndex& land_cover, Vec2 p) {
  if (!land_cover.box.contains(p)) return nullptr;
  const std::uint32_t top = ground::land_cover_at(land_cover, p);
  return top == ground::kNoLandCover ? nullptr : &land_cover.surfaces[top];
}

bool is_ground_for_walkers(const ground::LandCoverPolygon* polygon) {
  switch (polygon ? polygon->surface : LandCoverClass::kUnknown) {
    case LandCoverClass::kPavement:
    case LandCoverClass::kSquare:
    case LandCoverClass::kPlatform:
    case LandCoverClass::kFootPath:
    case LandCoverClass::kPavedFootPath:
    case LandCoverClass::kPedestrianStreet:
      return true;
    default:
      return false;
  }
}

bool is_on_free_ground(const ground::LandCoverIndex& land_cover, Vec2 at) {
  const auto is_free = [&](Vec2 p) { return is_ground_for_walkers(polygon_on_top(land_cover, p)); };
  if (!is_free(at)) return false;
  for (int i = 0; i < 6; ++i)
    if (!is_free(at + direction_of(i / 6.0) * kPersonRadius_m)) return false;
  return true;
}

std::vector<lots::Capsule> shop_fronts_of(std::span<const buildings::Building> buildings) {
  std::vector<lots::Capsule> fronts;
  for (const buildings::Building& building : buildings)
    for (const buildings::Front& front : building.fronts) {
      const Ring& ring = building.footprint.outer;
      if (front.edge >= ring.size()) continue;
      const Vec2 a = ring[front.edge], along = unit(ring[(front.edge + 1) % ring.size()] - a);
      fronts.push_back({a + along * front.from_m, a + along * front.to_m, 0});
    }
  return fronts;
}

std::vector<lots::Capsule> obstacles_of(const StreetLife& life) {
  std::vector<lots::Capsule> all;
  for (const Solid& solid : life.solids) {
    const double radius_m = std::min(solid.width_m, solid.depth_m) / 2;
    const bool is_wide = solid.width_m > solid.depth_m;
    const Vec2 reach =
        (is_wide ? solid.right : left_of(solid.right)) * (std::max(solid.width_m, solid.depth_m) / 2 - radius_m);
    all.push_back({solid.at - reach, solid.at + reach, radius_m});
  }
  for (const Vec2 trunk : life.trunks) all.push_back({trunk, trunk, kTrunkRadius_m});
  for (const props::Barrier& barrier : life.barriers)
    for (std::size_t i = 0; barrier.kind != map::BarrierKind::kKerb && i + 1 < barrier.axis.size(); ++i)
      all.push_back({barrier.axis[i], barrier.axis[i + 1], barrier.width_m / 2});
  return all;
}

bool is_park(LandCoverClass surface) {
  return surface == LandCoverClass::kPark || surface == LandCoverClass::kVillageGreen ||
         surface == LandCoverClass::kPlayground;
}

std::vector<const ground::LandCoverPolygon*> parks_of(const ground::LandCoverIndex& land_cover) {
  std::vector<const ground::LandCoverPolygon*> parks;
  for (const ground::LandCoverPolygon& surface : land_cover.surfaces)
    if (is_park(surface.surface)) parks.push_back(&surface);
  return parks;
}

struct SpotFinder {
  const StreetLife& life;
  const PeopleWish& wish;
  lots::Capsules fronts = lots::index_capsules(shop_fronts_of(life.buildings));
  std::vector<const ground::LandCoverPolygon*> parks = parks_of(life.land_cover);

  // The spots of streets and squares, which all tiles near them know.
  std::vector<Spot> shared_spots(const Box2& box) const {
    std::vector<Spot> spots = spots_at_crossings(life.roads, life.junctions, wish.tile_m, box);
    const auto append = [&](const std::vector<Spot>& more) { spots.insert(spots.end(), more.begin(), more.end()); };
    for (const roads::Road& road : life.roads) append(spots_along(road, box));
    for (const ground::LandCoverPolygon& surface : life.land_cover.surfaces)
      if (surface.surface == LandCoverClass::kSquare) append(spots_on_square(surface, box));
    std::erase_if(spots,
                  [&](const Spot& spot) { return !is_ground_for_walkers(polygon_on_top(life.land_cover, spot.at)); });
    std::ranges::sort(spots, {}, [](const Spot& spot) { return std::tuple(spot.key, spot.at); });
    return spots;
  }

  std::vector<Spot> spots_on_square(const ground::LandCoverPolygon& square, const Box2& box) const {
    const Box2 about = box_of(square.rings.front());
    const Box2 both{{std::max(box.min.x, about.min.x), std::max(box.min.y, about.min.y)},
                    {std::min(box.max.x, about.max.x), std::min(box.max.y, about.max.y)}};
    std::vector<Spot> spots = spots_of_square(square.id.osm, wish.country, both);
    std::erase_if(spots, [&](const Spot& spot) { return polygon_on_top(life.land_cover, spot.at) != &square; });
    return spots;
  }

  std::vector<Spot> own_spots(const Box2& box) const {
    std::vector<Spot> spots;
    for (const Solid& solid : life.solids) {
      std::vector<Spot> more;
      if (solid.is_stop) more = spots_at_stop(solid, wish.country);
      if (solid.is_seat) more = spots_on_seat(solid, wish.country);
      std::ranges::copy_if(more, std::back_inserter(spots),
                           [&](const Spot& spot) { return box.contains_half_open(spot.at); });
    }
    std::ranges::sort(spots, {}, [](const Spot& spot) { return std::tuple(spot.key, spot.at); });
    return spots;
  }

  bool is_in_park(Vec2 p) const {
    return std::ranges::any_of(parks, [&](const ground::LandCoverPolygon* park) {
      int winding = 0;
      for (const Ring& ring : park->rings) winding += winding_number(ring, p);
      return winding != 0;
    });
  }

  SpotUse use_of(const Spot& spot) const {
    if (spot.use != SpotUse::kOpen) return spot.use;
    if (!fronts.all.empty() && lots::clearance_m(fronts, spot.at, kBeforeShops_m) < kBeforeShops_m)
      return SpotUse::kShops;
    const int buildings = map::values_of(LandCoverClass::kBuilding).priority;
    if (ground::clearance_m(life.land_cover, spot.at, buildings, kBesideHouses_m) < kBesideHouses_m)
      return SpotUse::kHouses;
    return is_in_park(spot.at) ? SpotUse::kPark : SpotUse::kOpen;
  }
};

// The spots of sorted ones in a box that overlap no earlier one.
std::vector<Spot> first_of_crowded(const std::vector<Spot>& spots, const Box2& box) {
  if (spots.empty()) return {};
  std::vector<Box2> boxes;
  for (const Spot& spot : spots) boxes.push_back(Box2{spot.at, spot.at}.widened(kSpotRadius_m));
  const BoxGrid grid = grid_of(boxes, 8);
  std::vector<Spot> first;
  for (std::uint32_t i = 0; i < spots.size(); ++i) {
    if (!box.contains_half_open(spots[i].at)) continue;
    const bool is_later = any_about(grid, boxes[i], [&](std::uint32_t other) {
      return other < i && distance(spots[other].at, spots[i].at) < kSpotOverlap_m;
    });
    if (!is_later) first.push_back(spots[i]);
  }
  return first;
}

// Who sits on a bench is in it.
bool may_stand(const Spot& spot, const Member& member, const StreetLife& life, const lots::Capsules& obstacles) {
  if (spot.use == SpotUse::kSeat) return true;
  return is_on_free_ground(life.land_cover, member.at) &&
         (obstacles.all.empty() || lots::clearance_m(obstacles, member.at, kPersonRadius_m) >= kPersonRadius_m);
}

}  // namespace

std::vector<Spot> spots_in(const StreetLife& life, const PeopleWish& wish, const Box2& box) {
  const SpotFinder finder{life, wish};
  std::vector<Spot> spots = first_of_crowded(finder.shared_spots(box.widened(kSpotOverlap_m)), box);
  const std::vector<Spot> own = finder.own_spots(box);
  // those of things come first
  std::vector<Spot> all = own;
  std::ranges::copy_if(spots, std::back_inserter(all), [&](const Spot& spot) {
    return std::ranges::none_of(own, [&](const Spot& o) { return distance(o.at, spot.at) < kSpotOverlap_m; });
  });
  for (Spot& spot : all) spot.use = finder.use_of(spot);
  return all;
}

std::vector<things::Thing> people_in(const StreetLife& life, const PeopleWish& wish, const Box2& box) {
  std::vector<things::Thing> people;
  if (!has_people(wish.share)) return people;
  const lots::Capsules obstacles = lots::index_capsules(obstacles_of(life));
  for (const Spot& spot : spots_in(life, wish, box)) {
    if (!is_somebody_at(spot, wish.share, wish.time, wish.seed)) continue;
    for (const Member& member : members_at(spot, wish.seed))
      if (may_stand(spot, member, life, obstacles))
        people.push_back({.id = {spot.feature, static_cast<std::uint32_t>(people.size())},
                          .at = snapped(member.at),
                          .direction = things::nearest_direction(member.facing),
                          .form = form_of({member.body, wish.country, wish.season})});
  }
  return people;
}

}  // namespace citykiln::people
