#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/verify/assumed/measure_assumed.h"

namespace citykiln::verify {
namespace {

using map::LandCoverGroup;

// The distance from a person's middle at which the ground is tested, and the height up to which things are.
constexpr double kFeet_m = 0.2, kBodies_m = 1.5;

bool is_named(std::string_view mesh, std::string_view name) {
  return mesh == name || (mesh.starts_with(name) && mesh.substr(name.size()).starts_with("_") &&
                          mesh.find_first_not_of("0123456789", name.size() + 1) == mesh.npos);
}

bool is_person(const bake::InstancedMesh& mesh) { return is_named(mesh.name, "person"); }

// A copy of a mesh of a thing or a lamp.
struct Copy {
  Vec2 at, right;
  Box2 plan;  // in the frame of the mesh, of its part that is as low as people
  OsmId feature{};
};

Vec2 place_of_copy(const bake::InstancedMesh& mesh, std::size_t copy, Vec3 origin) {
  const bake::Float3& offset = mesh.translations[copy];
  return in_plan(Vec3{offset[0], offset[1], offset[2]} + origin);
}

Copy copy_of(const bake::InstancedMesh& mesh, std::size_t copy, const bake::BakedTile& tile) {
  const bake::Float4& turn = mesh.rotations[copy];
  const double z = turn[2], w = turn[3], norm = z * z + w * w, scale = mesh.scales.empty() ? 1.0 : mesh.scales[copy];
  Box2 plan;
  for (const bake::Primitive& primitive : mesh.primitives)
    for (const bake::Float3& p : primitive.positions)
      if (p[2] * scale < kBodies_m) plan.grow(Vec2{p[0], p[1]} * scale);
  return {place_of_copy(mesh, copy, tile.origin),
          {(w * w - z * z) / norm, 2 * z * w / norm},
          plan,
          tile.features[mesh.features[copy]]};
}

// The copies of things, lamps and cars other than benches, on which people sit.
struct Copies {
  std::vector<Copy> all;
  BoxGrid grid;
};

Copies solid_copies(const bake::BakedTile& tile) {
  Copies copies;
  std::vector<Box2> boxes;
  for (const bake::InstancedMesh& mesh : tile.instanced) {
    const bool is_prop = !mesh.primitives.empty() && mesh.primitives.front().layer == bake::Layer::kProps;
    if (!is_prop || is_person(mesh) || is_named(mesh.name, "bench")) continue;
    for (std::size_t i = 0; i < mesh.translations.size(); ++i) {
      const Copy copy = copy_of(mesh, i, tile);
      if (copy.plan.is_empty()) continue;
      const double reach_m = std::max(length(copy.plan.min), length(copy.plan.max));
      copies.all.push_back(copy);
      boxes.push_back(Box2{copy.at, copy.at}.widened(reach_m));
    }
  }
  if (!boxes.empty()) copies.grid = grid_of(boxes, 8);
  return copies;
}

// The thing in which a person stands.
std::optional<OsmId> thing_about(const Copies& copies, Vec2 at) {
  if (copies.all.empty()) return std::nullopt;
  for (const std::uint32_t i : boxes_about(copies.grid, at)) {
    const Copy& copy = copies.all[i];
    const Vec2 from = at - copy.at;
    if (copy.plan.contains({dot(from, copy.right), cross(copy.right, from)})) return copy.feature;
  }
  return std::nullopt;
}

bool bars_people(const ground::LandCoverPolygon& surface) {
  switch (map::values_of(surface.surface).group) {
    case LandCoverGroup::kBuilding:
    case LandCoverGroup::kWater:
    case LandCoverGroup::kRail:
      return true;
    case LandCoverGroup::kRoad:
      return surface.surface != map::LandCoverClass::kPedestrianStreet;
    default:
      return false;
  }
}

// The element on which a person may not stand.
std::optional<OsmId> ground_that_bars(const ground::LandCoverIndex& land_cover, Vec2 at) {
  for (const Vec2 off : {Vec2{}, Vec2{kFeet_m, 0}, Vec2{-kFeet_m, 0}, Vec2{0, kFeet_m}, Vec2{0, -kFeet_m}}) {
    if (!land_cover.box.contains(at + off)) continue;
    const std::uint32_t top = ground::land_cover_at(land_cover, at + off);
    if (top != ground::kNoLandCover && bars_people(land_cover.surfaces[top])) return land_cover.surfaces[top].id.osm;
  }
  return std::nullopt;
}

}  // namespace

AssumedTests measure_people(const bake::BakedTile& tile, const ground::LandCoverIndex& land_cover) {
  AssumedTests found;
  if (std::ranges::none_of(tile.instanced, is_person)) return found;
  const Copies copies = solid_copies(tile);
  for (const bake::InstancedMesh& mesh : tile.instanced) {
    if (!is_person(mesh)) continue;
    for (std::size_t i = 0; i < mesh.translations.size(); ++i) {
      const Vec2 at = place_of_copy(mesh, i, tile.origin);
      ++found.tested;
      std::optional<OsmId> bar = ground_that_bars(land_cover, at);
      if (!bar) bar = thing_about(copies, at);
      if (!bar || found.conflicts++ > 0) continue;
      found.at = at, found.element = tile.features[mesh.features[i]], found.obstacle = *bar;
    }
  }
  return found;
}

}  // namespace citykiln::verify
