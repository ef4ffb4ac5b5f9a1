#include "preview/scene/world.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>

#include "preview/scene/baked_scene.h"
#include "preview/scene/cell_cache.h"

namespace citykiln::preview {

// The backdrop in Embree. Immutable. A ray that stays over Backdrop::clear, where there is no backdrop, or is above
// all land when it leaves that box, is not tested in Embree. Rays in streets therefore cost a few multiplications.
class BackdropScene {
 public:
  /// @param backdrop  Has a tile, which must outlive this object.
  /// @param origin    The world's origin in plane metres.
  BackdropScene(RTCDevice device, const Backdrop& backdrop, Vec3 origin);

  const SceneGeometry& geometry() const { return scene_.geometry(); }
  std::size_t bytes() const { return scene_.bytes(); }
  /// True if land is nearer than the ray's end. `found` is then updated to the hit on the land.
  bool intersect(RTCRayHit& found) const;
  /// True if land is between the ends of the ray.
  bool is_blocking(RTCRay& ray) const;

 private:
  bool may_meet(const RTCRay& ray) const;

  BakedScene scene_;
  Box2 clear_;        // in the world's frame
  double highest_m_;  // above the origin
};

namespace {

double highest_m(const bake::BakedTile& tile) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const bake::Primitive& primitive : tile.primitives)
    for (const bake::Float3& p : primitive.positions) highest = std::max<double>(highest, p[2]);
  return highest + tile.origin.z;
}

// The distance at which a ray from within the interval leaves it.
double leaves_at(double from, double direction, double low, double high) {
  if (direction == 0) return std::numeric_limits<double>::infinity();
  return ((direction > 0 ? high : low) - from) / direction;
}

}  // namespace

BackdropScene::BackdropScene(RTCDevice device, const Backdrop& backdrop, Vec3 origin)
    : scene_(device, std::span(backdrop.tile, 1), origin),
      clear_(backdrop.clear.is_empty()
                 ? backdrop.clear
                 : Box2{backdrop.clear.min - in_plan(origin), backdrop.clear.max - in_plan(origin)}),
      highest_m_(highest_m(*backdrop.tile) - origin.z) {
  assert(backdrop.tile != nullptr);
}

bool BackdropScene::may_meet(const RTCRay& ray) const {
  if (!clear_.contains({ray.org_x, ray.org_y})) return ray.dir_z < 0 || ray.org_z <= highest_m_;
  const double left_m = std::min(leaves_at(ray.org_x, ray.dir_x, clear_.min.x, clear_.max.x),
                                 leaves_at(ray.org_y, ray.dir_y, clear_.min.y, clear_.max.y));
  if (ray.tfar < left_m) return false;
  return ray.dir_z < 0 || ray.org_z + ray.dir_z * left_m <= highest_m_;
}

bool BackdropScene::intersect(RTCRayHit& found) const {
  if (!may_meet(found.ray)) return false;
  RTCRayHit own{found.ray, {}};
  own.hit.geomID = own.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(geometry().scene(), &context, &own);
  if (own.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  found = own;
  return true;
}

bool BackdropScene::is_blocking(RTCRay& ray) const {
  if (!may_meet(ray)) return false;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(geometry().scene(), &context, &ray);
  return ray.tfar < 0;
}

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
