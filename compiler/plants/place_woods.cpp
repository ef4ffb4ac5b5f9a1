#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/plants/blue_noise.h"
#include "compiler/plants/standing.h"

namespace citykiln::plants {
namespace {

// Water, pitches and squares, paths, rails, roads and buildings, by their classes' priorities (surface_classes.inc).
constexpr int kLeastBarePriority = 50;

// Trees of one wood differ by this share of their mean height.
constexpr double kHeightSpread = 0.3;

// Heights of woods are told for trees that grow so tall; bushes among them stay low.
constexpr double kTall_m = 22;

// Towards the tree line trees get few: as many as asked for up to the first, so few from the second on.
constexpr double kDenseUpTo_m = 2100, kSparseFrom_m = 2500, kSparse = 0.15;

// So near to where a forest ends it is bushes, mostly.
constexpr double kRim_m = 4.5, kRimBushes = 0.55;

/// The woods of a tile by the surfaces that they stand on.
struct WoodMap {
  std::span<const Wood> woods;
  const Land& land;
  std::vector<std::uint32_t> of_surface;  ///< kNoSurface: none.
  std::vector<Seat> seats;                ///< One a wood.
};

/// Surfaces are sorted by id; a building may bear the id of a wood.
std::vector<std::uint32_t> woods_by_surface(std::span<const Wood> woods, std::span<const ground::Surface> surfaces) {
  std::vector<std::uint32_t> of_surface(surfaces.size(), ground::kNoSurface);
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (map::values_of(surfaces[s].surface).group == map::SurfaceGroup::kBuilding) continue;
    const auto found = std::ranges::lower_bound(woods, surfaces[s].id, {}, &Wood::surface);
    if (found != woods.end() && found->surface == surfaces[s].id)
      of_surface[s] = static_cast<std::uint32_t>(found - woods.begin());
  }
  return of_surface;
}

WoodMap map_woods(std::span<const Wood> woods, const Land& land) {
  WoodMap map{woods, land, woods_by_surface(woods, land.surfaces.surfaces), {}};
  for (const Wood& wood : woods) map.seats.push_back(seat_for(wood.per_ha));
  return map;
}

/// The wood on top at a place, or kNoSurface.
std::uint32_t wood_at(const WoodMap& map, Vec2 p) {
  const std::uint32_t surface = ground::surface_at(map.land.surfaces, p);
  return surface == ground::kNoSurface ? ground::kNoSurface : map.of_surface[surface];
}

/// The least spacing of the woods in the buckets that a block touches.
double least_spacing_m(const WoodMap& woods, const Box2& block) {
  const ground::SurfaceMap& map = woods.land.surfaces;
  const auto bucket = [&](double offset_m, int count) {
    return static_cast<int>(std::clamp(std::floor(offset_m / map.bucket_m), 0.0, count - 1.0));
  };
  const int first = bucket(block.min.x - map.corner.x, map.columns),
            last = bucket(block.max.x - map.corner.x, map.columns);
  double least_m = 0;
  for (int row = bucket(block.min.y - map.corner.y, map.rows); row <= bucket(block.max.y - map.corner.y, map.rows);
       ++row)
    for (std::uint32_t e = map.bucket_starts[static_cast<std::size_t>(row) * map.columns + first];
         e < map.bucket_starts[static_cast<std::size_t>(row) * map.columns + last + 1]; ++e) {
      const std::uint32_t wood = woods.of_surface[map.entries[e].surface];
      if (wood == ground::kNoSurface) continue;
      const double spacing_m = woods.seats[wood].spacing_m;
      least_m = least_m > 0 ? std::min(least_m, spacing_m) : spacing_m;
    }
  return least_m;
}

double share_at(double belt_m) {
  const double up = (belt_m - kDenseUpTo_m) / (kSparseFrom_m - kDenseUpTo_m);
  return 1 - (1 - kSparse) * std::clamp(up, 0.0, 1.0);
}

Seat seat_at(const WoodMap& woods, Vec2 p) {
  const Land& land = woods.land;
  if (!land.surfaces.box.contains(p)) return {};
  const std::uint32_t wood = wood_at(woods, p);
  if (wood == ground::kNoSurface) return {};
  if (clearance_m(land.surfaces, p, kLeastBarePriority, kTrunkClearance_m) < kTrunkClearance_m) return {};
  Seat seat = woods.seats[wood];
  seat.owner = wood;
  seat.height_m = height_m_at(land.ground.terrain, p);
  const Vec3 normal = normal_at(land.ground.terrain, p);
  seat.upright = normal.z;
  seat.share *= share_at(habitat_at(land.latitude_deg, p, seat.height_m, normal, false).belt_m);
  return seat;
}

bool is_forest(const WoodMap& woods, Vec2 p) {
  const std::uint32_t surface = ground::surface_at(woods.land.surfaces, p);
  if (surface == ground::kNoSurface) return false;
  return map::values_of(woods.land.surfaces.surfaces[surface].surface).group == map::SurfaceGroup::kForest;
}

bool is_at_rim(const WoodMap& woods, Vec2 p) {
  constexpr std::array<Vec2, 4> kAbout = {{{kRim_m, 0}, {0, kRim_m}, {-kRim_m, 0}, {0, -kRim_m}}};
  return is_forest(woods, p) && std::ranges::any_of(kAbout, [&](Vec2 offset) { return !is_forest(woods, p + offset); });
}

/// A lane's segments by place.
struct Lanes {
  struct Segment {
    Vec2 a, b;
    double half_m;
  };
  std::vector<Segment> segments;
  BoxGrid grid;
};

Lanes sort_lanes(std::span<const Lane> lanes, const Box2& box) {
  constexpr double kBucket_m = 32;
  Lanes sorted;
  std::vector<Box2> boxes;
  for (const Lane& lane : lanes)
    for (std::size_t i = 0; i + 1 < lane.axis.size(); ++i) {
      const Box2 about = box_of(std::array{lane.axis[i], lane.axis[i + 1]}).widened(lane.width_m / 2);
      if (!about.touches(box)) continue;
      sorted.segments.push_back({lane.axis[i], lane.axis[i + 1], lane.width_m / 2});
      boxes.push_back(about);
    }
  // a long span's box holds much that is far from it
  sorted.grid = grid_of(boxes, kBucket_m);
  return sorted;
}

double distance_to(const Lanes::Segment& s, Vec2 p) {
  const Vec2 along = s.b - s.a;
  const double t = std::clamp(dot(p - s.a, along) / std::max(dot(along, along), 1e-300), 0.0, 1.0);
  return distance(p, s.a + along * t);
}

bool is_in_lane(const Lanes& lanes, Vec2 p) {
  return std::ranges::any_of(boxes_about(lanes.grid, p), [&](std::uint32_t i) {
    return distance_to(lanes.segments[i], p) < lanes.segments[i].half_m;
  });
}

void grow(Placed& placed, const WoodMap& woods, const Site& site) {
  const Wood& wood = woods.woods[site.seat.owner];
  const Land& land = woods.land;
  const Draw draw(land.seed, site.id, "tree");
  const Habitat habitat = habitat_of(land, site.at);
  Species species = draw_species(wood.stock, habitat, land.seed, draw.unit(kSpeciesDice));
  if (draw.unit(kKeptDice) < kRimBushes && is_at_rim(woods, site.at)) species = Species::kBush;
  const double height_m = wood.height_m * std::min(values_of(species).height_m / kTall_m, 1.4) * vigour(habitat) *
                          draw.between(1 - kHeightSpread, 1 + kHeightSpread, kHeightDice);
  stand(placed, land, species, site.at, height_m, draw, wood.surface.osm);
}

}  // namespace

void place_woods(Placed& placed, std::span<const Wood> woods, std::span<const Obstacle> trees,
                 std::span<const Lane> lanes, const Land& land) {
  if (woods.empty()) return;
  const WoodMap map = map_woods(woods, land);
  const std::vector<Site> sites = blue_noise(
      land.seed, land.box, [&](const Box2& block) { return least_spacing_m(map, block); },
      [&](Vec2 p) { return seat_at(map, p); });
  const Obstacles obstacles = sort_obstacles(trees);
  const Lanes kept_free = sort_lanes(lanes, land.box);
  for (const Site& site : sites)
    if (!is_taken(obstacles, site.at) && !is_in_lane(kept_free, site.at)) grow(placed, map, site);
}

}  // namespace citykiln::plants
