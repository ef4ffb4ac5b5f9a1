#include "preview/world.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "preview/instance_set.h"
#include "preview/material_texture.h"
#include "preview/mesh_part.h"

namespace citykiln::preview {
namespace {

RTCRay ray_of(Vec3 from, Vec3 direction) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(from.x), ray.org_y = static_cast<float>(from.y),
  ray.org_z = static_cast<float>(from.z);
  ray.dir_x = static_cast<float>(direction.x), ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
  ray.tfar = std::numeric_limits<float>::infinity(), ray.mask = 0xffffffffu;
  return ray;
}

// Embree is built with asserts: one ray that is not finite ends the program.
bool is_sound(const RTCRay& ray) {
  const auto finite = [](float x, float y, float z) {
    return std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
  };
  return finite(ray.org_x, ray.org_y, ray.org_z) && finite(ray.dir_x, ray.dir_y, ray.dir_z) &&
         (ray.dir_x != 0 || ray.dir_y != 0 || ray.dir_z != 0);
}

// Both normals towards where the ray came from; where smoothing has turned the shading normal away, the true one.
void turn_normals(Hit& hit, Vec3 direction) {
  if (dot(hit.geometric_normal, direction) > 0) {
    hit.geometric_normal = hit.geometric_normal * -1;
    hit.shading_normal = hit.shading_normal * -1;
  }
  hit.shading_normal = unit(hit.shading_normal);
  if (!(dot(hit.shading_normal, hit.geometric_normal) > 0)) hit.shading_normal = hit.geometric_normal;
}

// What rounding a point on a plane to single precision moves it off the plane, at most.
double rounding_off_plane_m(Vec3 p, Vec3 normal) {
  constexpr double kRounding = 0x1p-24;
  return kRounding * (std::abs(p.x * normal.x) + std::abs(p.y * normal.y) + std::abs(p.z * normal.z));
}

}  // namespace

struct World::Scene {
  Vec3 origin;
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene top = rtcNewScene(device);
  std::vector<std::unique_ptr<MipTexture>> textures;
  std::vector<std::unique_ptr<MaterialTexture>> surfaces;
  std::vector<std::unique_ptr<FacadeAtlasTexture>> facade_atlas;
  std::vector<MeshPart> fixed;                       // geometry ids 0 … n - 1
  std::vector<std::unique_ptr<InstanceSet>> crowds;  // geometry ids n …

  ~Scene() {
    rtcReleaseScene(top);
    crowds.clear();
    rtcReleaseDevice(device);
  }

  // Tiles with equal sheets share one.
  const MipTexture* texture_of(const bake::BakedTile& tile) {
    if (tile.sheet.texels.empty()) return nullptr;
    const auto same = std::ranges::find_if(textures, [&](const auto& other) { return other->sheet() == tile.sheet; });
    if (same != textures.end()) return same->get();
    return textures.emplace_back(std::make_unique<MipTexture>(tile.sheet)).get();
  }

  // Tiles with equal textures share them.
  const MaterialTexture* surface_of(const bake::BakedTile& tile, materials::Material material) {
    const auto own = std::ranges::find(tile.textures, material, &materials::Texture::material);
    if (own == tile.textures.end()) return nullptr;
    const auto same = std::ranges::find_if(surfaces, [&](const auto& other) { return other->texture() == *own; });
    if (same != surfaces.end()) return same->get();
    return surfaces.emplace_back(std::make_unique<MaterialTexture>(*own)).get();
  }

  std::vector<const MaterialTexture*> surfaces_of(const bake::BakedTile& tile, const bake::InstancedMesh& instanced) {
    std::vector<const MaterialTexture*> of;
    for (const bake::Primitive& primitive : instanced.primitives) of.push_back(surface_of(tile, primitive.material));
    return of;
  }

  // No two tiles have the same.
  const FacadeAtlasTexture* imprint_of(const bake::BakedTile& tile) {
    if (tile.facade_atlas.colour.texels.empty()) return nullptr;
    return facade_atlas.emplace_back(std::make_unique<FacadeAtlasTexture>(tile.facade_atlas)).get();
  }

  void add_fixed(const bake::BakedTile& tile) {
    const MipTexture* texture = texture_of(tile);
    const FacadeAtlasTexture* impostor = imprint_of(tile);
    for (const bake::Primitive& primitive : tile.primitives)
      if (!primitive.triangles.empty())
        fixed.push_back(
            moved(primitive, tile.origin - origin, texture, surface_of(tile, primitive.material), impostor));
  }

  void add_crowds(const bake::BakedTile& tile) {
    const MipTexture* texture = texture_of(tile);
    for (const bake::InstancedMesh& instanced : tile.instanced) {
      const auto surfaces = surfaces_of(tile, instanced);
      auto crowd =
          std::ranges::find_if(crowds, [&](const auto& other) { return other->is_of(instanced, texture, surfaces); });
      if (crowd == crowds.end())
        crowd = crowds.insert(crowd, std::make_unique<InstanceSet>(device, instanced, texture, surfaces));
      (*crowd)->add(instanced, tile.origin - origin);
    }
  }

  void commit() {
    for (const MeshPart& part : fixed) attach(device, top, part);
    unsigned first = 0;
    for (const auto& crowd : crowds) {
      crowd->attach_to(device, top, first);
      first += static_cast<unsigned>(crowd->size());
    }
    // closed edges: a ray between two triangles that share one meets one of them
    rtcSetSceneFlags(top, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(top);
  }

  Hit hit_of(const RTCHit& found, const RayFootprint& beam) const {
    if (found.instID[0] == RTC_INVALID_GEOMETRY_ID) return hit_on(fixed[found.geomID], found, beam);
    const auto after =
        std::ranges::upper_bound(crowds, found.instID[0], {}, [](const auto& crowd) { return crowd->first(); });
    return (*(after - 1))->hit_in_world(found, beam);
  }
};

World::World(std::span<const bake::BakedTile> tiles, Vec3 near) : scene_(std::make_unique<Scene>()) {
  const auto whole = [](double v) { return std::isfinite(v) ? std::round(v) : 0; };
  scene_->origin = {whole(near.x), whole(near.y), whole(near.z)};
  for (const bake::BakedTile& tile : tiles) scene_->add_fixed(tile);
  for (const bake::BakedTile& tile : tiles) scene_->add_crowds(tile);
  scene_->commit();
}
World::~World() = default;
World::World(World&&) noexcept = default;
Vec3 World::origin() const { return scene_->origin; }

std::optional<Hit> World::first_hit(Vec3 from, Vec3 direction, double spread_rad) const {
  RTCRayHit found{ray_of(from, direction), {}};
  if (!is_sound(found.ray)) return std::nullopt;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  found.hit.geomID = found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_->top, &context, &found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  Hit hit = scene_->hit_of(found.hit, {direction, found.ray.tfar * spread_rad});
  turn_normals(hit, direction);
  hit.distance_m = found.ray.tfar;
  hit.rounding_m += rounding_off_plane_m(hit.position, hit.geometric_normal);
  return hit;
}

bool World::is_blocked(Vec3 from, Vec3 direction) const {
  RTCRay ray = ray_of(from, direction);
  if (!is_sound(ray)) return false;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_->top, &context, &ray);
  return ray.tfar < 0;
}

Vec3 leave(const Hit& hit, Vec3 direction) {
  // once for the point that is rounded when the ray is made, once for the plane that it must be clear of
  const double off = 2 * hit.rounding_m;
  return hit.position + hit.geometric_normal * (dot(direction, hit.geometric_normal) > 0 ? off : -off);
}

}  // namespace citykiln::preview
