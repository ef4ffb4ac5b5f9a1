#include "preview/scene/instance_set.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>

#include "preview/user_geometry.h"

namespace citykiln::preview {

MeshScene::MeshScene(RTCDevice device, const std::vector<bake::Primitive>& primitives, const MipTexture* marking_atlas,
                     std::vector<const MaterialTexture*> materials, std::shared_ptr<const CutoutTexture> cutout)
    : primitives_(&primitives),
      materials_(std::move(materials)),
      cutout_(std::move(cutout)),
      scene_(rtcNewScene(device)) {
  assert(materials_.size() == primitives.size());
  constexpr double kFar = std::numeric_limits<double>::infinity();
  low_ = {kFar, kFar, kFar}, high_ = {-kFar, -kFar, -kFar};
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    if (primitives[i].triangles.empty()) continue;
    parts_.push_back(mesh_part_of(primitives[i], {}, marking_atlas, materials_[i], nullptr, cutout_.get()));
    for (const bake::Float3& p : primitives[i].positions) {
      low_ = {std::min<double>(low_.x, p[0]), std::min<double>(low_.y, p[1]), std::min<double>(low_.z, p[2])};
      high_ = {std::max<double>(high_.x, p[0]), std::max<double>(high_.y, p[1]), std::max<double>(high_.z, p[2])};
    }
  }
  for (const MeshPart& part : parts_) attach(device, scene_, part);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene_);
}

MeshScene::~MeshScene() { rtcReleaseScene(scene_); }

bool MeshScene::is_of(const bake::InstancedMesh& mesh, const MipTexture* marking_atlas,
                      std::span<const MaterialTexture* const> materials) const {
  const auto is_on_it = [&](const MeshPart& part) {
    return part.primitive->colour_source != materials::ColourSource::kByMarkingAtlas ||
           part.marking_atlas == marking_atlas;
  };
  // many meshes have the same large picture, so it is compared last
  if (*primitives_ != mesh.primitives || !std::ranges::equal(materials_, materials)) return false;
  if (!std::ranges::all_of(parts_, is_on_it)) return false;
  const bool has_cutout = !mesh.cutout->colour.texels.empty();
  if (has_cutout != (cutout_ != nullptr)) return false;
  return !has_cutout || &cutout_->cutout() == &*mesh.cutout || cutout_->cutout() == *mesh.cutout;
}

std::size_t MeshScene::bytes() const {
  std::size_t bytes = 0;
  for (const MeshPart& part : parts_) bytes += part.corners.capacity() * sizeof(bake::Float3);
  return bytes;
}

namespace {

// A rotation as its columns: the images of x, y and z.
struct Rotation {
  Vec3 x, y, z;

  Vec3 out(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
  Vec3 in(Vec3 v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
};

Rotation rotation_of(const bake::Float4& q) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  return {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
          {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
          {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
}

// The ray in an instance's frame. Its direction is scaled, so that distances along it stay.
RTCRay in_frame(const RTCRay& ray, const InstanceTransform& transform) {
  const Rotation rotation = rotation_of(transform.rotation);
  const double shrink = 1.0 / transform.scale;
  RTCRay local = ray;
  set_ray(local, rotation.in(Vec3{ray.org_x, ray.org_y, ray.org_z} - bake::widened(transform.translation)) * shrink,
          rotation.in({ray.dir_x, ray.dir_y, ray.dir_z}) * shrink);
  return local;
}

// Half the extent of a rotated box along an axis: by its corners, or by the vertical cylinder around it, whichever is
// smaller. @param row  The components along the axis of the rotated x, y and z.
double half_extent(Vec3 row, Vec3 half) {
  const double corners = std::abs(row.x) * half.x + std::abs(row.y) * half.y + std::abs(row.z) * half.z;
  const double radius = std::sqrt(half.x * half.x + half.y * half.y);
  return std::min(corners, std::sqrt(row.x * row.x + row.y * row.y) * radius + std::abs(row.z) * half.z);
}

}  // namespace

// Embree's callbacks for one instance.
struct InstanceSet::Calls {
  static void bounds(const RTCBoundsFunctionArguments* args) {
    *args->bounds_o = static_cast<const InstanceSet*>(args->geometryUserPtr)->box_of(args->primID);
  }

  static void intersect(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& set = *static_cast<const InstanceSet*>(args->geometryUserPtr);
    RTCRayHit& rayhit = *reinterpret_cast<RTCRayHit*>(args->rayhit);
    RTCRayHit local{in_frame(rayhit.ray, set.transforms_[args->primID]), {}};
    local.hit.geomID = local.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(set.mesh_->scene(), args->context, &local);
    if (local.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
    rayhit.hit = local.hit;
    rayhit.hit.instID[0] = set.first_ + args->primID;
    rayhit.ray.tfar = local.ray.tfar;
  }

  static void occluded(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& set = *static_cast<const InstanceSet*>(args->geometryUserPtr);
    RTCRay& ray = *reinterpret_cast<RTCRay*>(args->ray);
    RTCRay local = in_frame(ray, set.transforms_[args->primID]);
    rtcOccluded1(set.mesh_->scene(), args->context, &local);
    if (local.tfar < 0) ray.tfar = -std::numeric_limits<float>::infinity();
  }
};

void InstanceSet::add(const bake::InstancedMesh& instanced, const std::vector<OsmId>& features, Vec3 offset) {
  assert(instanced.scales.size() == instanced.translations.size() &&
         instanced.rotations.size() == instanced.translations.size());
  batches_.push_back({transforms_.size(), &instanced, &features});
  transforms_.reserve(transforms_.size() + instanced.translations.size());
  for (std::size_t i = 0; i < instanced.translations.size(); ++i) {
    const Vec3 at = bake::widened(instanced.translations[i]) + offset;
    const bake::Float3 rounded = {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)};
    transforms_.push_back({rounded, instanced.scales[i], instanced.rotations[i]});
  }
}

void InstanceSet::attach_to(RTCDevice device, RTCScene top, unsigned first) {
  first_ = first;
  // a mesh without triangles has no bounds
  attach_user_geometry<Calls>(device, top, mesh_->parts().empty() ? 0 : transforms_.size(), this);
}

RTCBounds InstanceSet::box_of(std::size_t instance) const {
  const InstanceTransform& transform = transforms_[instance];
  const Rotation rotation = rotation_of(transform.rotation);
  const Vec3 half = (mesh_->high() - mesh_->low()) * (0.5 * transform.scale);
  const Vec3 middle =
      bake::widened(transform.translation) + rotation.out((mesh_->low() + mesh_->high()) * (0.5 * transform.scale));
  const Vec3 reach{half_extent({rotation.x.x, rotation.y.x, rotation.z.x}, half),
                   half_extent({rotation.x.y, rotation.y.y, rotation.z.y}, half),
                   half_extent({rotation.x.z, rotation.y.z, rotation.z.z}, half)};
  // single precision may round a bound inwards
  constexpr double kWider = 0x1p-22;
  const auto below = [](double v, double r) { return static_cast<float>(v - r - kWider * (std::abs(v) + r)); };
  const auto above = [](double v, double r) { return static_cast<float>(v + r + kWider * (std::abs(v) + r)); };
  RTCBounds b{};
  b.lower_x = below(middle.x, reach.x), b.lower_y = below(middle.y, reach.y), b.lower_z = below(middle.z, reach.z);
  b.upper_x = above(middle.x, reach.x), b.upper_y = above(middle.y, reach.y), b.upper_z = above(middle.z, reach.z);
  return b;
}

OsmId InstanceSet::feature_of(std::size_t instance) const {
  const auto after = std::ranges::upper_bound(batches_, instance, {}, &Batch::first);
  const Batch& batch = *std::prev(after);
  const std::vector<std::uint32_t>& numbers = batch.instanced->features;
  return numbers.empty() ? OsmId{} : (*batch.features)[numbers[instance - batch.first]];
}

Hit InstanceSet::hit_in_world(const RTCHit& found, const RayFootprint& footprint) const {
  const std::size_t instance = found.instID[0] - first_;
  const InstanceTransform& transform = transforms_[instance];
  const Rotation rotation = rotation_of(transform.rotation);
  Hit hit = hit_on(mesh_->parts()[found.geomID], found,
                   {rotation.in(footprint.direction), footprint.across_m / transform.scale, footprint.is_scattered});
  // in the instance's frame the ray's origin is rounded once more
  constexpr double kRounding = 0x1p-24;
  hit.rounding_m = transform.scale * (hit.rounding_m + 2 * kRounding * length(hit.position));
  hit.position = bake::widened(transform.translation) + rotation.out(hit.position) * transform.scale;
  hit.geometric_normal = rotation.out(hit.geometric_normal);
  hit.shading_normal = rotation.out(hit.shading_normal);
  hit.feature = feature_of(instance);
  return hit;
}

}  // namespace citykiln::preview
