#include "preview/instance_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace citykiln::preview {
namespace {

// A rotation as its columns: where x, y and z go.
struct Turn {
  Vec3 x, y, z;

  Vec3 out(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
  Vec3 in(Vec3 v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
};

Turn turn_of(const bake::Float4& q) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  return {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
          {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
          {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
}

Vec3 widened(const bake::Float3& v) { return {v[0], v[1], v[2]}; }

void set_from(RTCRay& ray, Vec3 from, Vec3 direction) {
  ray.org_x = static_cast<float>(from.x), ray.org_y = static_cast<float>(from.y),
  ray.org_z = static_cast<float>(from.z);
  ray.dir_x = static_cast<float>(direction.x), ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
}

// The ray in a copy's frame, as long as in the world: distances stay.
RTCRay in_frame(const RTCRay& ray, const InstanceTransform& place) {
  const Turn turn = turn_of(place.rotation);
  const double shrink = 1.0 / place.scale;
  RTCRay local = ray;
  set_from(local, turn.in(Vec3{ray.org_x, ray.org_y, ray.org_z} - widened(place.translation)) * shrink,
           turn.in({ray.dir_x, ray.dir_y, ray.dir_z}) * shrink);
  return local;
}

// Half the extent along an axis of a box that is turned: by its corners, or by the upright cylinder about it, whichever
// is tighter. `row` is how much of the shape's x, y and z goes along the axis.
double half_extent(Vec3 row, Vec3 half) {
  const double corners = std::abs(row.x) * half.x + std::abs(row.y) * half.y + std::abs(row.z) * half.z;
  const double radius = std::sqrt(half.x * half.x + half.y * half.y);
  return std::min(corners, std::sqrt(row.x * row.x + row.y * row.y) * radius + std::abs(row.z) * half.z);
}

}  // namespace

// What Embree calls for one copy: in C, with pointers to what it does not know.
struct InstanceSet::Calls {
  static void bounds(const RTCBoundsFunctionArguments* args) {
    const auto& crowd = *static_cast<const InstanceSet*>(args->geometryUserPtr);
    const InstanceTransform& place = crowd.places_[args->primID];
    const Turn turn = turn_of(place.rotation);
    const Vec3 half = (crowd.high_ - crowd.low_) * (0.5 * place.scale);
    const Vec3 middle = widened(place.translation) + turn.out((crowd.low_ + crowd.high_) * (0.5 * place.scale));
    const Vec3 reach{half_extent({turn.x.x, turn.y.x, turn.z.x}, half),
                     half_extent({turn.x.y, turn.y.y, turn.z.y}, half),
                     half_extent({turn.x.z, turn.y.z, turn.z.z}, half)};
    // single precision may round a bound inwards
    constexpr double kWider = 0x1p-22;
    const auto below = [](double v, double r) { return static_cast<float>(v - r - kWider * (std::abs(v) + r)); };
    const auto above = [](double v, double r) { return static_cast<float>(v + r + kWider * (std::abs(v) + r)); };
    RTCBounds& b = *args->bounds_o;
    b.lower_x = below(middle.x, reach.x), b.lower_y = below(middle.y, reach.y), b.lower_z = below(middle.z, reach.z);
    b.upper_x = above(middle.x, reach.x), b.upper_y = above(middle.y, reach.y), b.upper_z = above(middle.z, reach.z);
  }

  static void intersect(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& crowd = *static_cast<const InstanceSet*>(args->geometryUserPtr);
    RTCRayHit& rayhit = *reinterpret_cast<RTCRayHit*>(args->rayhit);
    RTCRayHit local{in_frame(rayhit.ray, crowd.places_[args->primID]), {}};
    local.hit.geomID = local.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(crowd.scene_, args->context, &local);
    if (local.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
    rayhit.hit = local.hit;
    rayhit.hit.instID[0] = crowd.first_ + args->primID;
    rayhit.ray.tfar = local.ray.tfar;
  }

  static void occluded(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& crowd = *static_cast<const InstanceSet*>(args->geometryUserPtr);
    RTCRay& ray = *reinterpret_cast<RTCRay*>(args->ray);
    RTCRay local = in_frame(ray, crowd.places_[args->primID]);
    rtcOccluded1(crowd.scene_, args->context, &local);
    if (local.tfar < 0) ray.tfar = -std::numeric_limits<float>::infinity();
  }
};

InstanceSet::InstanceSet(RTCDevice device, const bake::InstancedMesh& shape, const MipTexture* texture,
                         std::vector<const MaterialTexture*> surfaces)
    : shape_(&shape), surfaces_(std::move(surfaces)), scene_(rtcNewScene(device)) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  if (!shape.cutout.colour.texels.empty()) cutout_ = std::make_unique<CutoutTexture>(shape.cutout);
  low_ = {kFar, kFar, kFar}, high_ = {-kFar, -kFar, -kFar};
  for (std::size_t i = 0; i < shape.primitives.size(); ++i) {
    const bake::Primitive& primitive = shape.primitives[i];
    if (primitive.triangles.empty()) continue;
    parts_.push_back(moved(primitive, {}, texture, surfaces_[i], nullptr, cutout_.get()));
    for (const bake::Float3& p : primitive.positions) {
      low_ = {std::min<double>(low_.x, p[0]), std::min<double>(low_.y, p[1]), std::min<double>(low_.z, p[2])};
      high_ = {std::max<double>(high_.x, p[0]), std::max<double>(high_.y, p[1]), std::max<double>(high_.z, p[2])};
    }
  }
  for (const MeshPart& part : parts_) attach(device, scene_, part);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene_);
}

InstanceSet::~InstanceSet() { rtcReleaseScene(scene_); }

bool InstanceSet::is_of(const bake::InstancedMesh& shape, const MipTexture* texture,
                        std::span<const MaterialTexture* const> surfaces) const {
  const auto is_on_it = [&](const MeshPart& part) {
    return part.primitive->colour_source != materials::ColourSource::kByMarkingAtlas || part.texture == texture;
  };
  return shape_->primitives == shape.primitives && shape_->cutout == shape.cutout &&
         std::ranges::equal(surfaces_, surfaces) && std::ranges::all_of(parts_, is_on_it);
}

void InstanceSet::add(const bake::InstancedMesh& instanced, Vec3 offset) {
  places_.reserve(places_.size() + instanced.translations.size());
  for (std::size_t i = 0; i < instanced.translations.size(); ++i) {
    const Vec3 at = widened(instanced.translations[i]) + offset;
    const bake::Float3 rounded = {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)};
    places_.push_back({rounded, instanced.scales[i], instanced.rotations[i]});
  }
}

void InstanceSet::attach_to(RTCDevice device, RTCScene top, unsigned first) {
  first_ = first;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  // a shape without triangles has no box
  rtcSetGeometryUserPrimitiveCount(geometry, parts_.empty() ? 0 : static_cast<unsigned>(places_.size()));
  rtcSetGeometryUserData(geometry, this);
  rtcSetGeometryBoundsFunction(
      geometry, [](const RTCBoundsFunctionArguments* args) { Calls::bounds(args); }, nullptr);
  rtcSetGeometryIntersectFunction(geometry, [](const RTCIntersectFunctionNArguments* args) { Calls::intersect(args); });
  rtcSetGeometryOccludedFunction(geometry, [](const RTCOccludedFunctionNArguments* args) { Calls::occluded(args); });
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(top, geometry);
  rtcReleaseGeometry(geometry);
}

Hit InstanceSet::hit_in_world(const RTCHit& found, const RayFootprint& beam) const {
  const InstanceTransform& place = places_[found.instID[0] - first_];
  const Turn turn = turn_of(place.rotation);
  Hit hit = hit_on(parts_[found.geomID], found, {turn.in(beam.direction), beam.across_m / place.scale});
  // in the copy's frame the ray's origin is rounded once more
  constexpr double kRounding = 0x1p-24;
  hit.rounding_m = place.scale * (hit.rounding_m + 2 * kRounding * length(hit.position));
  hit.position = widened(place.translation) + turn.out(hit.position) * place.scale;
  hit.geometric_normal = turn.out(hit.geometric_normal);
  hit.shading_normal = turn.out(hit.shading_normal);
  return hit;
}

}  // namespace citykiln::preview
