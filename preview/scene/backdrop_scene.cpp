#include "preview/scene/backdrop_scene.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace citykiln::preview {
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

}  // namespace citykiln::preview
