#include "compiler/bake/place_cars.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "compiler/bake/ground_on_top.h"
#include "compiler/cars/parked_cars.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/countries/country_group.h"
#include "compiler/things/facing.h"

namespace citykiln::bake {
namespace {

cars::TileRecipes recipes_of(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover) {
  return {.roads = chunk.roads,
          .junctions = chunk.junctions,
          .yards = chunk.yards,
          .pitches = chunk.pitches,
          .trees = chunk.trees,
          .things = chunk.things,
          .barriers = chunk.barriers,
          .buildings = chunk.buildings,
          .land_cover = land_cover};
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
                     .is_parked = true};
}

}  // namespace

std::vector<PlacedThing> place_cars(const scene::Header& header, const scene::Chunk& chunk,
                                    const ground::LandCoverIndex& land_cover, const ground::GradedTerrain& graded,
                                    const Box2& box) {
  const cars::CarWish wish{.share = header.cars,
                           .time = scene::week_time_of(header),
                           .country = map::country_group_at(header.origin),
                           .seed = header.seed,
                           .tile_m = header.tile_m};
  std::vector<PlacedThing> placed;
  for (const things::Thing& car : cars::parked_cars(recipes_of(chunk, land_cover), wish, box))
    if (std::optional<PlacedThing> standing = stand(car, land_cover, graded)) placed.push_back(std::move(*standing));
  return placed;
}

}  // namespace citykiln::bake
