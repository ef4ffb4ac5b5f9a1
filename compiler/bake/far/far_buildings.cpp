#include "compiler/bake/far/far_buildings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "compiler/bake/far/far_windows.h"
#include "compiler/buildings/styles/building_materials.h"
#include "compiler/geometry/snap.h"
#include "compiler/surroundings/curvature.h"

namespace citykiln::bake {
namespace {

using materials::Material;
using materials::MaterialMesh;

constexpr double kLeastArea_m2 = 40, kHighest_m = 32, kSteepestSite = 0.5, kStep_m = 0x1p-7;
// Walls reach below the lowest ground, which is a plane only within a cell.
constexpr double kBelow_m = 1.5;
// The shares of the light of walls with windows that are not drawn, and of roofs with joints and shaded tiles.
constexpr double kWithWindows = 0.82, kOfTiles = 0.7;

// The material of walls that show the picture of windows, which has their colour.
constexpr Material kUnderWindows = Material::kPaint;

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

// The tint that gives a white picture the colour of a tinted material.
materials::Tint on_white(Material material, materials::Tint tint) {
  const auto& colour = materials::values_of(material).base_colour;
  for (std::size_t c = 0; c < 3; ++c)
    tint[c] = static_cast<std::uint8_t>(std::min(255.0, tint[c] * static_cast<double>(colour[c]) + 0.5));
  return tint;
}

// A corner of a polygon, and its place on the picture of windows.
struct BoxCorner {
  Vec3 at;
  Vec2 uv{};
};
using Outline = std::vector<BoxCorner>;

class BoxWriter {
 public:
  explicit BoxWriter(std::uint64_t seed) : seed_(seed) {}

  void add(const FarBuilding& far, double low_m, double high_m) {
    const buildings::Building& b = *far.building;
    const double rise_m = b.roof_shape.height_m;
    const Box box{.corners = plan_corners_of(far.plan),
                  .foot_m = low_m - kBelow_m,
                  .ground_m = high_m,
                  .eaves_m = high_m + std::max(2.5, buildings::eaves_m(b) - b.floor_m),
                  .rise_m = rise_m};
    add_walls(box, b.wall, buildings::wall_tint(b, seed_));
    add_roof(box, b.roof, darkened(buildings::roof_tint(b, seed_), box.is_pitched() ? kOfTiles : 1));
  }

  std::vector<MaterialMesh> take() {
    std::vector<MaterialMesh> meshes;
    for (auto& [key, mesh] : meshes_) meshes.push_back(std::move(mesh));
    return meshes;
  }

 private:
  struct Box {
    std::array<Vec2, 4> corners;
    double foot_m, ground_m, eaves_m, rise_m;
    bool is_pitched() const { return rise_m >= 1; }
  };

  static Vec3 at(Vec2 p, double z) {
    return {snapped_to(kStep_m, p.x), snapped_to(kStep_m, p.y), snapped_to(kStep_m, z)};
  }

  // Walls of glass have no windows.
  void add_walls(const Box& box, Material material, materials::Tint tint) {
    const auto& c = box.corners;
    const FarWindowPart part = window_part(std::max(1.0, distance(c[0], c[1])), std::max(1.0, distance(c[1], c[2])),
                                           box.eaves_m - box.ground_m, box.ground_m - box.foot_m);
    std::vector<Outline> walls;
    for (std::size_t i = 0; i < 4; ++i) walls.push_back(wall_of(box, part, i));
    if (material == Material::kGlassFacade)
      add_polygons(mesh_of(material, false), darkened(tint, kWithWindows), walls);
    else
      add_polygons(mesh_of(kUnderWindows, true), on_white(material, tint), walls);
  }

  static Outline wall_of(const Box& box, const FarWindowPart& part, std::size_t side) {
    const std::size_t next = (side + 1) % 4;
    const Vec2 from = box.corners[side], to = box.corners[next];
    const double u = part.corners_m[side], v = part.corners_m[next];
    Outline wall = {{at(from, box.eaves_m), {u, part.eaves_m}},
                    {at(from, box.foot_m), {u, part.below_m}},
                    {at(to, box.foot_m), {v, part.below_m}},
                    {at(to, box.eaves_m), {v, part.eaves_m}}};
    // a gable is wall alone
    if (box.is_pitched() && side % 2 == 1)
      wall.push_back({at((from + to) * 0.5, box.eaves_m + box.rise_m), {(u + v) / 2, part.eaves_m}});
    return wall;
  }

  void add_roof(const Box& box, Material material, materials::Tint tint) {
    MaterialMesh& mesh = mesh_of(material, false);
    const auto& c = box.corners;
    const double ridge_m = box.eaves_m + box.rise_m;
    if (!box.is_pitched())
      return add_polygons(mesh, tint,
                          {{{at(c[0], ridge_m)}, {at(c[1], ridge_m)}, {at(c[2], ridge_m)}, {at(c[3], ridge_m)}}});
    const Vec3 west = at((c[0] + c[3]) * 0.5, ridge_m), east = at((c[1] + c[2]) * 0.5, ridge_m);
    add_polygons(mesh, tint,
                 {{{at(c[0], box.eaves_m)}, {at(c[1], box.eaves_m)}, {east}, {west}},
                  {{at(c[2], box.eaves_m)}, {at(c[3], box.eaves_m)}, {west}, {east}}});
  }

  // Convex polygons, counter-clockwise. Their triangles take turns, so that they stay one object whose polygons share
  // vertices in files without normals (object_runs.h).
  static void add_polygons(MaterialMesh& mesh, materials::Tint tint, const std::vector<Outline>& polygons) {
    std::vector<std::uint32_t> first;
    std::size_t most = 0;
    for (const Outline& outline : polygons) {
      first.push_back(static_cast<std::uint32_t>(mesh.mesh.positions.size()));
      most = std::max(most, outline.size());
      add_vertices(mesh, tint, outline);
    }
    for (std::uint32_t i = 2; i < most; ++i)
      for (std::size_t k = 0; k < polygons.size(); ++k)
        if (i < polygons[k].size()) mesh.mesh.triangles.push_back({first[k], first[k] + i - 1, first[k] + i});
  }

  static void add_vertices(MaterialMesh& mesh, materials::Tint tint, const Outline& outline) {
    const Vec3 across = cross(outline[1].at - outline[0].at, outline[2].at - outline[0].at);
    const Vec3 normal = across == Vec3{} ? Vec3{0, 0, 1} : unit(across);
    for (const BoxCorner& corner : outline) {
      mesh.mesh.positions.push_back(corner.at), mesh.mesh.normals.push_back(normal), mesh.tints.push_back(tint);
      if (mesh.colour_source == materials::ColourSource::kByAtlas) mesh.uvs.push_back(corner.uv);
    }
  }

  MaterialMesh& mesh_of(Material material, bool has_windows) {
    MaterialMesh& mesh = meshes_[{material, has_windows}];
    mesh.material = material;
    if (has_windows) mesh.colour_source = materials::ColourSource::kByAtlas;
    return mesh;
  }

  std::uint64_t seed_;
  std::map<std::pair<Material, bool>, MaterialMesh> meshes_;
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
