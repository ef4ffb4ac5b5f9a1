#include "compiler/bake/ground/ground_uvs.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/trig.h"
#include "compiler/map/locate.h"
#include "compiler/materials/texture.h"

namespace citykiln::bake {
namespace {

bool has_rows(materials::Material material) {
  return material == materials::Material::kFarmland || material == materials::Material::kOrchard;
}

double rounded(double v) {
  return std::floor(v / materials::kTextureCoordinateStep_m + 0.5) * materials::kTextureCoordinateStep_m;
}

Vec2 periods_below_place(Vec2 place) {
  const auto below = [](double v) { return std::floor(v / materials::kTexturePeriod_m) * materials::kTexturePeriod_m; };
  return {below(place.x), below(place.y)};
}

}  // namespace

Vec2 texture_direction(ObjectId surface, materials::Material material, std::uint64_t seed) {
  if (!has_rows(material)) return {1, 0};
  return direction_of(RandomSequence(seed, stable_id(surface), "rows").unit(0));
}

Vec2 uv_on_land(Vec2 at, Vec2 direction) { return on_grid({dot(at, direction), cross(direction, at)}); }

Vec2 uv_on_wall(Vec3 at, Vec3 normal) {
  const bool faces_east = std::abs(normal.x) > std::abs(normal.y);
  return on_grid({faces_east ? at.y : at.x, at.z});
}

Vec2 on_grid(Vec2 place) { return {rounded(place.x), rounded(place.y)}; }

Vec2 periods_below(const std::array<Vec2, 3>& places) {
  return periods_below_place(
      {std::min({places[0].x, places[1].x, places[2].x}), std::min({places[0].y, places[1].y, places[2].y})});
}

Vec2 periods_below_cell(Vec2 at, Vec2 direction) {
  const auto low = [](double v) { return std::floor(v / map::kCell_m) * map::kCell_m; };
  const Vec2 corner{low(at.x), low(at.y)};
  Vec2 lowest = uv_on_land(corner, direction);
  for (const Vec2 other : {Vec2{map::kCell_m, 0}, Vec2{0, map::kCell_m}, Vec2{map::kCell_m, map::kCell_m}}) {
    const Vec2 place = uv_on_land(corner + other, direction);
    lowest = {std::min(lowest.x, place.x), std::min(lowest.y, place.y)};
  }
  return periods_below_place(lowest);
}

}  // namespace citykiln::bake
