#include "compiler/bake/far/far_buildings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "compiler/buildings/styles/building_materials.h"
#include "compiler/geometry/snap.h"
#include "compiler/surroundings/curvature.h"

namespace citykiln::bake {
namespace {

using materials::Material;
using materials::MaterialMesh;

constexpr double kLeastArea_m2 = 30, kHighest_m = 32, kSteepestSite = 0.5, kStep_m = 0x1p-7;
// Walls reach below the lowest ground, which is a plane only within a cell.
constexpr double kBelow_m = 1.5;
// The shares of the light of walls with windows, and of roofs with joints and shaded tiles.
constexpr double kWithWindows = 0.82, kOfTiles = 0.7;

// A rectangle in the plane, as wide as the building is long.
struct Rectangle {
  Vec2 middle, along;  // unit
  double length_m = 0, width_m = 0;
};

Rectangle rectangle_of(const buildings::Building& building) {
  const Ring& ring = building.footprint.outer;
  Vec2 along{1, 0};
  double longest_m = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i];
    if (length(edge) > longest_m) longest_m = length(edge), along = edge * (1 / longest_m);
  }
  double low = 1e30, high = -1e30, left = 1e30, right = -1e30, twice_m2 = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 p = ring[i] - ring[0];
    low = std::min(low, dot(p, along)), high = std::max(high, dot(p, along));
    left = std::min(left, dot(p, left_of(along))), right = std::max(right, dot(p, left_of(along)));
    twice_m2 += cross(p, ring[(i + 1) % ring.size()] - ring[0]);
  }
  const Vec2 middle = ring[0] + along * ((low + high) / 2) + left_of(along) * ((left + right) / 2);
  const double box_m2 = (high - low) * (right - left), area_m2 = std::abs(twice_m2) / 2;
  const double shrunk = box_m2 > 0 ? std::sqrt(std::min(1.0, area_m2 / box_m2)) : 0;
  Rectangle all{middle, along, (high - low) * shrunk, (right - left) * shrunk};
  if (all.width_m > all.length_m) all = {middle, left_of(along), all.width_m, all.length_m};
  return all;
}

// A building beyond the edge.
struct FarBuilding {
  const buildings::Building* building;
  Rectangle plan;
  double away_m;
};

// The mirror images of a place at the sides and corners of a box.
std::vector<std::pair<Vec2, std::array<double, 2>>> images_of(const Box2& box, Vec2 p) {
  const auto along = [](double v, double low, double high) {
    std::vector<std::pair<double, double>> all = {{v, 1.0}};
    const double depth = std::min(kMirrored_m, (high - low) / 2);
    // to and fro: turned, as it is, turned …
    for (double from = 0; from < kFarBuildings_m; from += 2 * depth) {
      if (v - low < depth) all.push_back({low - from - (v - low), -1.0}), all.push_back({v - from - 2 * depth, 1.0});
      if (high - v < depth) all.push_back({high + from + (high - v), -1.0}), all.push_back({v + from + 2 * depth, 1.0});
    }
    return all;
  };
  std::vector<std::pair<Vec2, std::array<double, 2>>> images;
  for (const auto& [x, turn_x] : along(p.x, box.min.x, box.max.x))
    for (const auto& [y, turn_y] : along(p.y, box.min.y, box.max.y))
      if (const Vec2 at{x, y}; !box.contains(at) && surroundings::away_m(box, at) <= kFarBuildings_m)
        images.push_back({at, {turn_x, turn_y}});
  return images;
}

bool may_stand_on(const surroundings::Patch* patch) {
  if (patch == nullptr || patch->raised_m > 0) return false;
  switch (map::values_of(patch->cover).group) {
    case map::LandCoverGroup::kForest:
    case map::LandCoverGroup::kWater:
    case map::LandCoverGroup::kWetland:
      return false;
    default:
      return true;
  }
}

std::array<Vec2, 4> plan_corners_of(const Rectangle& r) {
  const Vec2 a = r.along * (r.length_m / 2), b = left_of(r.along) * (r.width_m / 2);
  return {r.middle - a - b, r.middle + a - b, r.middle + a + b, r.middle - a + b};
}

// The lowest and the highest ground at the corners; empty where a corner is not on land, or the site is steep.
std::optional<std::pair<double, double>> site_of(const Rectangle& plan, const surroundings::AroundSurface& surface) {
  double low = 1e30, high = -1e30;
  for (const Vec2 corner : plan_corners_of(plan)) {
    const auto height_m = surface.height_m_at(corner);
    if (!height_m || !may_stand_on(surface.patch_at(corner))) return std::nullopt;
    low = std::min(low, *height_m), high = std::max(high, *height_m);
  }
  if (high - low > kSteepestSite * plan.length_m) return std::nullopt;
  return std::pair(low, high);
}

materials::Tint darkened(materials::Tint tint, double share) {
  for (std::size_t c = 0; c < 3; ++c) tint[c] = static_cast<std::uint8_t>(tint[c] * share + 0.5);
  return tint;
}

class BoxWriter {
 public:
  explicit BoxWriter(std::uint64_t seed) : seed_(seed) {}

  void add(const FarBuilding& far, double low_m, double high_m) {
    const buildings::Building& b = *far.building;
    const double eaves_m = high_m + std::max(2.5, buildings::eaves_m(b) - b.floor_m);
    const double rise_m = b.roof_shape.height_m;
    const auto corners = plan_corners_of(far.plan);
    const materials::Tint wall = darkened(buildings::wall_tint(b, seed_), kWithWindows);
    const materials::Tint roof = darkened(buildings::roof_tint(b, seed_), rise_m >= 1 ? kOfTiles : 1);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2 from = corners[i], to = corners[(i + 1) % 4];
      quad(b.wall, wall, {at(from, low_m - kBelow_m), at(to, low_m - kBelow_m), at(to, eaves_m), at(from, eaves_m)});
    }
    const bool is_pitched = rise_m >= 1;
    if (!is_pitched) {
      const double top_m = eaves_m + rise_m;
      quad(b.roof, roof, {at(corners[0], top_m), at(corners[1], top_m), at(corners[2], top_m), at(corners[3], top_m)});
      return;
    }
    const Vec2 west = (corners[0] + corners[3]) * 0.5, east = (corners[1] + corners[2]) * 0.5;
    const Vec3 ridge_a = at(west, eaves_m + rise_m), ridge_b = at(east, eaves_m + rise_m);
    quad(b.roof, roof, {at(corners[0], eaves_m), at(corners[1], eaves_m), ridge_b, ridge_a});
    quad(b.roof, roof, {at(corners[2], eaves_m), at(corners[3], eaves_m), ridge_a, ridge_b});
    triangle(b.wall, wall, {at(corners[1], eaves_m), at(corners[2], eaves_m), ridge_b});
    triangle(b.wall, wall, {at(corners[3], eaves_m), at(corners[0], eaves_m), ridge_a});
  }

  std::vector<MaterialMesh> take() {
    std::vector<MaterialMesh> meshes;
    for (auto& [material, mesh] : meshes_) meshes.push_back(std::move(mesh));
    return meshes;
  }

 private:
  static Vec3 at(Vec2 p, double z) {
    return {snapped_to(kStep_m, p.x), snapped_to(kStep_m, p.y), snapped_to(kStep_m, z)};
  }

  std::uint32_t vertex(MaterialMesh& mesh, Vec3 p, materials::Tint tint) {
    mesh.mesh.positions.push_back(p), mesh.tints.push_back(tint);
    return static_cast<std::uint32_t>(mesh.mesh.positions.size() - 1);
  }

  void quad(Material material, materials::Tint tint, const std::array<Vec3, 4>& p) {
    MaterialMesh& mesh = mesh_of(material);
    const std::uint32_t a = vertex(mesh, p[0], tint), b = vertex(mesh, p[1], tint), c = vertex(mesh, p[2], tint);
    add_quad(mesh.mesh, a, b, c, vertex(mesh, p[3], tint));
  }

  void triangle(Material material, materials::Tint tint, const std::array<Vec3, 3>& p) {
    MaterialMesh& mesh = mesh_of(material);
    const std::uint32_t a = vertex(mesh, p[0], tint), b = vertex(mesh, p[1], tint);
    mesh.mesh.triangles.push_back({a, b, vertex(mesh, p[2], tint)});
  }

  MaterialMesh& mesh_of(Material material) {
    MaterialMesh& mesh = meshes_[material];
    mesh.material = material;
    return mesh;
  }

  std::uint64_t seed_;
  std::map<Material, MaterialMesh> meshes_;
};

std::vector<FarBuilding> mirrored_buildings(const scene::Scene& scene, const Patchwork& patchwork) {
  const Box2& box = patchwork.box();
  std::vector<FarBuilding> all;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const buildings::Building& building : chunk.buildings) {
      // towers and steeples are landmarks: one does not expect a second one
      if (!building.stands_on_ground || building.top_m - building.floor_m > kHighest_m) continue;
      const Rectangle own = rectangle_of(building);
      if (own.length_m * own.width_m < kLeastArea_m2 || !box.contains(own.middle)) continue;
      for (const auto& [image, turn] : images_of(box, own.middle)) {
        const Vec2 middle = image - patchwork.shift_at(image);
        all.push_back({&building,
                       {middle, {own.along.x * turn[0], own.along.y * turn[1]}, own.length_m, own.width_m},
                       surroundings::away_m(box, middle)});
      }
    }
  std::ranges::stable_sort(all, {}, &FarBuilding::away_m);
  return all;
}

}  // namespace

std::vector<MaterialMesh> far_buildings(const scene::Scene& scene, const Patchwork& patchwork,
                                        const surroundings::AroundSurface& surface) {
  BoxWriter writer(scene.header.seed);
  std::size_t count = 0;
  for (const FarBuilding& far : mirrored_buildings(scene, patchwork)) {
    if (count >= kMostFarBuildings) break;
    const auto site = site_of(far.plan, surface);
    if (!site) continue;
    writer.add(far, site->first, site->second);
    ++count;
  }
  return writer.take();
}

}  // namespace citykiln::bake
