#include "preview/scene/world.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "preview/scene/instance_set.h"
#include "preview/scene/material_texture.h"
#include "preview/scene/mesh_part.h"

namespace citykiln::preview {
namespace {

RTCRay ray_of(Vec3 from, Vec3 direction) {
  RTCRay ray{};
  set_ray(ray, from, direction);
  ray.tfar = std::numeric_limits<float>::infinity(), ray.mask = 0xffffffffu;
  return ray;
}

// Whether Embree accepts a ray: it is built with asserts, which fail on rays that are not finite.
bool is_sound(const RTCRay& ray) {
  const auto finite = [](float x, float y, float z) {
    return std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
  };
  return finite(ray.org_x, ray.org_y, ray.org_z) && finite(ray.dir_x, ray.dir_y, ray.dir_z) &&
         (ray.dir_x != 0 || ray.dir_y != 0 || ray.dir_z != 0);
}

// Turns both normals towards the ray's origin; the geometric one replaces a shading normal that points away.
void turn_normals(Hit& hit, Vec3 direction) {
  hit.is_front = dot(hit.geometric_normal, direction) <= 0;
  if (!hit.is_front) {
    hit.geometric_normal = hit.geometric_normal * -1;
    hit.shading_normal = hit.shading_normal * -1;
  }
  hit.shading_normal = unit(hit.shading_normal);
  if (!(dot(hit.shading_normal, hit.geometric_normal) > 0)) hit.shading_normal = hit.geometric_normal;
}

// An upper bound of how far rounding a point to single precision moves it off a plane.
double rounding_off_plane_m(Vec3 p, Vec3 normal) {
  constexpr double kRounding = 0x1p-24;
  return kRounding * (std::abs(p.x * normal.x) + std::abs(p.y * normal.y) + std::abs(p.z * normal.z));
}

}  // namespace

struct World::Scene {
  Vec3 origin;
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene top = rtcNewScene(device);
  std::vector<std::unique_ptr<MipTexture>> marking_atlases;
  std::vector<std::unique_ptr<MaterialTexture>> material_textures;
  std::vector<std::unique_ptr<FacadeAtlasTexture>> facade_atlas;
  std::vector<MeshPart> parts;                              // geometry ids 0 … n - 1
  std::vector<std::unique_ptr<InstanceSet>> instance_sets;  // geometry ids n …
  std::vector<Emitter> emitters;

  ~Scene() {
    rtcReleaseScene(top);
    instance_sets.clear();
    rtcReleaseDevice(device);
  }

  // Tiles with equal marking atlases share one.
  const MipTexture* marking_atlas_of(const bake::BakedTile& tile) {
    if (tile.marking_atlas.texels.empty()) return nullptr;
    const auto same =
        std::ranges::find_if(marking_atlases, [&](const auto& other) { return other->image() == tile.marking_atlas; });
    if (same != marking_atlases.end()) return same->get();
    return marking_atlases.emplace_back(std::make_unique<MipTexture>(tile.marking_atlas)).get();
  }

  // Tiles with equal textures share them.
  const MaterialTexture* material_of(const bake::BakedTile& tile, materials::Material material) {
    const auto own = std::ranges::find(tile.textures, material, &materials::Texture::material);
    if (own == tile.textures.end()) return nullptr;
    const auto same =
        std::ranges::find_if(material_textures, [&](const auto& other) { return other->texture() == *own; });
    if (same != material_textures.end()) return same->get();
    return material_textures.emplace_back(std::make_unique<MaterialTexture>(*own)).get();
  }

  std::vector<const MaterialTexture*> materials_of(const bake::BakedTile& tile, const bake::InstancedMesh& instanced) {
    std::vector<const MaterialTexture*> of;
    for (const bake::Primitive& primitive : instanced.primitives) of.push_back(material_of(tile, primitive.material));
    return of;
  }

  // No two tiles have equal facade atlases.
  const FacadeAtlasTexture* facade_atlas_of(const bake::BakedTile& tile) {
    if (tile.facade_atlas.colour.texels.empty()) return nullptr;
    return facade_atlas.emplace_back(std::make_unique<FacadeAtlasTexture>(tile.facade_atlas)).get();
  }

  void add_primitives(const bake::BakedTile& tile) {
    const MipTexture* marking_atlas = marking_atlas_of(tile);
    const FacadeAtlasTexture* facade_atlas = facade_atlas_of(tile);
    for (const bake::Primitive& primitive : tile.primitives) {
      if (primitive.triangles.empty()) continue;
      parts.push_back(mesh_part_of(primitive, tile.origin - origin, marking_atlas,
                                   material_of(tile, primitive.material), facade_atlas));
      if (!primitive.features.empty()) parts.back().features = &tile.features;
    }
  }

  // The cutout's texture, which meshes with equal cutouts share; null where there is none.
  std::shared_ptr<const CutoutTexture> cutout_of(const bake::InstancedMesh& instanced) const {
    if (instanced.cutout->colour.texels.empty()) return nullptr;
    const auto like =
        std::ranges::find_if(instance_sets, [&](const auto& other) { return other->cutout() == instanced.cutout; });
    return like != instance_sets.end() ? (*like)->cutout_texture() : std::make_shared<CutoutTexture>(*instanced.cutout);
  }

  void add_instances(const bake::BakedTile& tile) {
    const MipTexture* marking_atlas = marking_atlas_of(tile);
    for (const bake::InstancedMesh& instanced : tile.instanced) {
      const auto used = materials_of(tile, instanced);
      auto set = std::ranges::find_if(instance_sets,
                                      [&](const auto& other) { return other->is_of(instanced, marking_atlas, used); });
      if (set == instance_sets.end())
        set = instance_sets.insert(
            set, std::make_unique<InstanceSet>(device, instanced, marking_atlas, used, cutout_of(instanced)));
      (*set)->add(instanced, tile.features, tile.origin - origin);
    }
  }

  void commit() {
    for (MeshPart& part : parts) add_emitters(part, emitters);
    for (const MeshPart& part : parts) attach(device, top, part);
    unsigned first = 0;
    for (const auto& set : instance_sets) {
      set->attach_to(device, top, first);
      first += static_cast<unsigned>(set->size());
    }
    // watertight edges: no ray passes between two triangles that share an edge
    rtcSetSceneFlags(top, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(top);
  }

  Hit hit_of(const RTCHit& found, const RayFootprint& footprint) const {
    if (found.instID[0] == RTC_INVALID_GEOMETRY_ID) return hit_on(parts[found.geomID], found, footprint);
    const auto after =
        std::ranges::upper_bound(instance_sets, found.instID[0], {}, [](const auto& set) { return set->first(); });
    return (*(after - 1))->hit_in_world(found, footprint);
  }
};

World::World(std::span<const bake::BakedTile> tiles, Vec3 near) : scene_(std::make_unique<Scene>()) {
  const auto whole = [](double v) { return std::isfinite(v) ? std::round(v) : 0; };
  scene_->origin = {whole(near.x), whole(near.y), whole(near.z)};
  for (const bake::BakedTile& tile : tiles) scene_->add_primitives(tile);
  for (const bake::BakedTile& tile : tiles) scene_->add_instances(tile);
  scene_->commit();
}
World::~World() = default;
World::World(World&&) noexcept = default;
Vec3 World::origin() const { return scene_->origin; }
std::span<const Emitter> World::emitters() const { return scene_->emitters; }

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

bool World::is_blocked(Vec3 from, Vec3 direction, double distance_m) const {
  RTCRay ray = ray_of(from, direction);
  ray.tfar = static_cast<float>(distance_m);
  if (!is_sound(ray)) return false;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_->top, &context, &ray);
  return ray.tfar < 0;
}

Vec3 leave(const Hit& hit, Vec3 direction) {
  // once for the origin, which the ray rounds, once for the plane
  const double off = 2 * hit.rounding_m;
  return hit.position + hit.geometric_normal * (dot(direction, hit.geometric_normal) > 0 ? off : -off);
}

}  // namespace citykiln::preview
