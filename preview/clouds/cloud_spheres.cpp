#include "preview/clouds/cloud_spheres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "preview/user_geometry.h"

namespace citykiln::preview {
namespace {

// Smallest radius of particles: the edges of real clouds are not sharper.
constexpr double kFinest_m = 12;

// The depth below a sphere's surface at which its density is full: a share of its radius, between these.
constexpr double kSoftShare = 0.25, kLeastSoft_m = 8, kMostSoft_m = 25;

// The context of a ray in Embree's callback.
struct PartsRay : RTCIntersectContext {
  const sky::CloudParticle* spheres = nullptr;
  Vec3 from, direction;  // in the layer's frame
  double scale = 1, farthest_m = 0;
  std::vector<SpherePart>* parts = nullptr;
};

}  // namespace

// Embree's callbacks.
struct CloudSpheres::Calls {
  static void bounds(const RTCBoundsFunctionArguments* args) {
    const auto& self = *static_cast<const CloudSpheres*>(args->geometryUserPtr);
    const sky::CloudParticle& sphere = self.spheres_[args->primID];
    const Vec3 at = sphere.centre - self.origin_;
    // rounding to single precision
    const double r = sphere.radius_m + 0x1p-20 * (std::abs(at.x) + std::abs(at.y) + std::abs(at.z)) + 0.01;
    RTCBounds& box = *args->bounds_o;
    box.lower_x = static_cast<float>(at.x - r), box.upper_x = static_cast<float>(at.x + r);
    box.lower_y = static_cast<float>(at.y - r), box.upper_y = static_cast<float>(at.y + r);
    box.lower_z = static_cast<float>(at.z - r), box.upper_z = static_cast<float>(at.z + r);
  }

  static void intersect(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& ray = *static_cast<const PartsRay*>(args->context);
    const double radius_m = ray.spheres[args->primID].radius_m;
    const auto chord = sky::chord_of(ray.spheres[args->primID], ray.from, ray.direction);
    auto [begin, end] = sky::above_base(chord, ray.from, ray.direction);
    begin = std::max(begin, 0.0), end = std::min(end, ray.farthest_m);
    if (end > begin)
      ray.parts->push_back({begin, end, chord.first, chord.second, ray.scale / (radius_m * radius_m), args->primID});
  }
};

CloudSpheres::CloudSpheres(const sky::CloudLayer& layer, Vec3 eye, double finest_rad)
    : frame_(sky::frame_of(layer)), extinction_per_m_(sky::extinction_per_m(layer.kind)) {
  const Box2 around = sky::within_limit(layer, Box2{in_plan(eye), in_plan(eye)}.widened(kFarthestCloud_m));
  for (const sky::Cloud& cloud : sky::clouds_in(layer, around)) {
    const Vec3 middle = frame_.out_of(at_height(cloud.centre, cloud.height_m / 2));
    const double away_m = std::max(0.0, length(middle - eye) - cloud.radius_m);
    if (length(in_plan(middle - eye)) > kFarthestCloud_m) continue;
    const double finest_m = std::max(kFinest_m, finest_rad * away_m) / frame_.flatten;
    for (const sky::CloudParticle& sphere : sky::generate_cloud(layer, cloud, finest_m).spheres)
      spheres_.push_back(sphere);
    ++clouds_;
  }
  origin_ = frame_.into(eye);
  build();
}

CloudSpheres::CloudSpheres(const sky::CloudLayer& layer, std::vector<sky::CloudParticle> spheres, CloudEdges edges)
    : frame_(sky::frame_of(layer)),
      extinction_per_m_(sky::extinction_per_m(layer.kind)),
      edges_(edges),
      spheres_(std::move(spheres)),
      clouds_(1) {
  if (!spheres_.empty()) origin_ = spheres_.front().centre;
  build();
}

CloudSpheres::CloudSpheres(CloudSpheres&& other) noexcept
    : frame_(other.frame_),
      extinction_per_m_(other.extinction_per_m_),
      edges_(other.edges_),
      spheres_(std::move(other.spheres_)),
      clouds_(other.clouds_),
      origin_(other.origin_) {
  build();
}

CloudSpheres::~CloudSpheres() {
  if (scene_ != nullptr) rtcReleaseScene(scene_);
  if (device_ != nullptr) rtcReleaseDevice(device_);
}

void CloudSpheres::build() {
  if (spheres_.empty()) return;
  for (std::size_t i = 0; i < spheres_.size(); ++i)
    top_m_ = std::max(top_m_, centre(i).z + frame_.flatten * spheres_[i].radius_m);
  device_ = rtcNewDevice(nullptr);
  scene_ = rtcNewScene(device_);
  attach_user_geometry<Calls>(device_, scene_, spheres_.size(), this);
  rtcCommitScene(scene_);
}

// Whether a ray is between the layer's base and its top somewhere.
bool CloudSpheres::meets_slab(Vec3 from, Vec3 direction, double distance_m) const {
  const double ends = direction.z == 0 ? from.z : from.z + direction.z * distance_m;
  return std::max(from.z, ends) > frame_.base_m && std::min(from.z, ends) < top_m_;
}

void CloudSpheres::parts_of(Vec3 from, Vec3 direction, double distance_m, std::vector<SpherePart>& parts) const {
  parts.clear();
  if (spheres_.empty() || !meets_slab(from, direction, distance_m)) return;
  PartsRay context;
  rtcInitIntersectContext(&context);
  context.spheres = spheres_.data(), context.parts = &parts;
  context.from = frame_.into(from), context.direction = frame_.into_direction(direction);
  context.scale = dot(context.direction, context.direction);
  context.farthest_m = std::min(distance_m, 4 * kFarthestCloud_m);
  const Vec3 at = context.from - origin_, along = context.direction;
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(at.x), ray.ray.org_y = static_cast<float>(at.y);
  ray.ray.org_z = static_cast<float>(at.z);
  ray.ray.dir_x = static_cast<float>(along.x), ray.ray.dir_y = static_cast<float>(along.y);
  ray.ray.dir_z = static_cast<float>(along.z);
  ray.ray.tfar = static_cast<float>(context.farthest_m), ray.ray.mask = 0xffffffffu;
  ray.hit.geomID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_, &context, &ray);
  std::ranges::sort(parts, [](const SpherePart& a, const SpherePart& b) {
    return std::pair(a.begin, a.sphere) < std::pair(b.begin, b.sphere);
  });
}

double CloudSpheres::edge_density(std::size_t sphere) const {
  const double radius_m = spheres_[sphere].radius_m;
  return radius_m / (2 * std::clamp(kSoftShare * radius_m, kLeastSoft_m, kMostSoft_m));
}

double CloudSpheres::density(std::span<const SpherePart> parts, double at_m) const {
  double sum = 0;
  for (const SpherePart& part : parts) {
    if (part.begin > at_m || part.end < at_m) continue;
    if (!is_soft()) return 1;
    sum += edge_density(part.sphere) * (at_m - part.enter) * (part.leave - at_m) * part.scale;
  }
  return std::clamp(sum, 0.0, 1.0);
}

double CloudSpheres::optical_depth(Vec3 from, Vec3 direction) const {
  std::vector<SpherePart> parts;
  parts_of(from, direction, std::numeric_limits<double>::infinity(), parts);
  double sum_m = 0, reached = 0;
  for (const SpherePart& part : parts) {
    sum_m += std::max(0.0, part.end - std::max(part.begin, reached));
    reached = std::max(reached, part.end);
  }
  return sum_m * extinction_per_m_;
}

}  // namespace citykiln::preview
