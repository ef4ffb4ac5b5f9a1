#include "preview/scene/world.h"

#include <atomic>
#include <cmath>
#include <limits>

#include "preview/scene/backdrop_scene.h"
#include "preview/scene/baked_scene.h"
#include "preview/scene/cell_cache.h"

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
  // one of them
  std::unique_ptr<BakedScene> baked{};
  std::unique_ptr<CellCache> cells{};
  std::unique_ptr<BackdropScene> backdrop{};      // beside either; null: none
  std::atomic<std::int64_t> hierarchy_bytes = 0;  // of baked tiles

  explicit Scene(Vec3 near) {
    const auto whole = [](double v) { return std::isfinite(v) ? std::round(v) : 0; };
    origin = {whole(near.x), whole(near.y), whole(near.z)};
  }
  void add(const Backdrop& around) {
    if (around.tile != nullptr) backdrop = std::make_unique<BackdropScene>(device, around, origin);
  }
  ~Scene() {
    baked.reset(), cells.reset(), backdrop.reset();
    rtcReleaseDevice(device);
  }
};

World::World(std::span<const bake::BakedTile> tiles, Vec3 near, const Backdrop& backdrop)
    : scene_(std::make_unique<Scene>(near)) {
  const auto count = [](void* scene, ssize_t bytes, bool) {
    static_cast<Scene*>(scene)->hierarchy_bytes += bytes;
    return true;
  };
  rtcSetDeviceMemoryMonitorFunction(scene_->device, count, scene_.get());
  scene_->baked = std::make_unique<BakedScene>(scene_->device, tiles, scene_->origin);
  scene_->add(backdrop);
}
World::World(std::shared_ptr<const CellSource> source, Vec3 near, std::size_t budget_bytes, const Backdrop& backdrop)
    : scene_(std::make_unique<Scene>(near)) {
  scene_->cells = std::make_unique<CellCache>(scene_->device, std::move(source), scene_->origin, budget_bytes);
  scene_->add(backdrop);
}
World::~World() = default;
World::World(World&&) noexcept = default;
Vec3 World::origin() const { return scene_->origin; }

std::span<const Emitter> World::emitters() const {
  return scene_->baked ? scene_->baked->emitters() : std::span<const Emitter>();
}

std::optional<CellCounters> World::counters() const {
  if (!scene_->cells) return std::nullopt;
  return scene_->cells->counters();
}

std::size_t World::bytes() const {
  if (scene_->baked) return scene_->baked->bytes() + static_cast<std::size_t>(scene_->hierarchy_bytes);
  const CellCounters now = scene_->cells->counters();
  return static_cast<std::size_t>(now.geometry_bytes + now.hierarchy_bytes + now.texture_bytes);
}

std::optional<Hit> World::first_hit(Vec3 from, Vec3 direction, double spread_rad) const {
  RTCRayHit found{ray_of(from, direction), {}};
  if (!is_sound(found.ray)) return std::nullopt;
  found.hit.geomID = found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  std::optional<Hit> hit;
  const auto take = [&](const SceneGeometry* geometry) {
    if (found.hit.geomID != RTC_INVALID_GEOMETRY_ID)
      hit = geometry->hit_of(found.hit, {direction, found.ray.tfar * spread_rad, spread_rad >= kScattered_rad});
  };
  if (scene_->cells) {
    CellRay ray(scene_->cells->readers());
    rtcIntersect1(scene_->cells->scene(), &ray, &found);
    take(ray.hit != nullptr ? &ray.hit->geometry() : nullptr);
  } else {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_->baked->geometry().scene(), &context, &found);
    take(&scene_->baked->geometry());
  }
  if (scene_->backdrop && scene_->backdrop->intersect(found)) take(&scene_->backdrop->geometry());
  if (!hit) return std::nullopt;
  turn_normals(*hit, direction);
  hit->distance_m = found.ray.tfar;
  hit->rounding_m += rounding_off_plane_m(hit->position, hit->geometric_normal);
  return hit;
}

bool World::is_blocked(Vec3 from, Vec3 direction, double distance_m) const {
  RTCRay ray = ray_of(from, direction);
  ray.tfar = static_cast<float>(distance_m);
  if (!is_sound(ray)) return false;
  if (scene_->cells) {
    CellRay state(scene_->cells->readers());
    rtcOccluded1(scene_->cells->scene(), &state, &ray);
  } else {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene_->baked->geometry().scene(), &context, &ray);
  }
  return ray.tfar < 0 || (scene_->backdrop && scene_->backdrop->is_blocking(ray));
}

Vec3 leave(const Hit& hit, Vec3 direction) {
  // once for the origin, which the ray rounds, once for the plane
  const double off = 2 * hit.rounding_m;
  return hit.position + hit.geometric_normal * (dot(direction, hit.geometric_normal) > 0 ? off : -off);
}

}  // namespace citykiln::preview
