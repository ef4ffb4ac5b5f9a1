#include "compiler/bake/ground/ground_uvs.h"

#include <algorithm>
#include <cmath>

#include "compiler/bake/ground/ground_material.h"
#include "compiler/bake/merge.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/trig.h"
#include "compiler/map/locate.h"
#include "compiler/map/row_direction.h"
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

// The corners of a triangle on its plane.
std::array<Vec2, 3> uvs_on_plane(const Mesh& mesh, const Triangle& t) {
  const Vec3 normal = normal_of(mesh, t);
  const Vec2 level{-normal.y, normal.x};
  const double across = length(level);
  const auto at = [&](std::size_t i) {
    const Vec3 p = mesh.positions[t[i]];
    if (std::abs(normal.z) >= kSteepCosine || !(across > 0)) return uv_on_land(in_plan(p), {1, 0});
    return on_grid({dot(in_plan(p), level) / across, p.z});
  };
  const std::array<Vec2, 3> uvs{at(0), at(1), at(2)};
  const Vec2 off = periods_below(uvs);
  return {uvs[0] - off, uvs[1] - off, uvs[2] - off};
}

}  // namespace

Vec2 texture_direction(ObjectId surface, materials::Material material, std::uint64_t seed) {
  if (!has_rows(material)) return {1, 0};
  return direction_of(RandomSequence(seed, stable_id(surface), "rows").unit(0));
}

Vec2 texture_direction(const ground::LandCoverPolygon& surface, materials::Material material, std::uint64_t seed) {
  if (has_rows(material) && map::is_field(surface.surface)) return left_of(map::row_direction(surface.row_heading));
  return texture_direction(surface.id, material, seed);
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

void add_planar_uvs(materials::MaterialMesh& mesh) {
  if (!mesh.uvs.empty() || mesh.colour_source != materials::ColourSource::kByMaterial) return;
  const materials::MaterialMesh shared = std::move(mesh);
  mesh = {{}, shared.material, shared.tint, shared.feature};
  for (const Triangle& t : shared.mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.mesh.positions.size());
    const std::array<Vec2, 3> uvs = uvs_on_plane(shared.mesh, t);
    for (std::size_t i = 0; i < uvs.size(); ++i) {
      mesh.mesh.positions.push_back(shared.mesh.positions[t[i]]), mesh.uvs.push_back(uvs[i]);
      if (!shared.mesh.normals.empty()) mesh.mesh.normals.push_back(shared.mesh.normals[t[i]]);
      if (!shared.tints.empty()) mesh.tints.push_back(shared.tints[t[i]]);
    }
    mesh.mesh.triangles.push_back({first, first + 1, first + 2});
  }
}

}  // namespace citykiln::bake
