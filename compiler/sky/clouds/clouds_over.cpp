#include "compiler/sky/clouds/clouds_over.h"

#include <algorithm>
#include <utility>

#include "compiler/contract/for_each_slot.h"

namespace citykiln::sky {
namespace {

// Half the size of a sphere's box in the plane: the frame scales it along the wind and upwards.
Vec3 half_box(const LayerFrame& frame, double radius_m) {
  const double u = frame.stretch * frame.along.x, v = frame.stretch * frame.along.y;
  return Vec3{length(Vec2{u, frame.along.y}), length(Vec2{v, frame.along.x}), frame.flatten} * radius_m;
}

Box2 outline_of(const Cloud& cloud, const LayerFrame& frame) {
  const Vec2 middle = in_plan(frame.out_of(at_height(cloud.centre, 0))),
             half = in_plan(half_box(frame, cloud.radius_m));
  return {middle - half, middle + half};
}

// The clouds whose outlines touch a box.
std::vector<Cloud> clouds_touching(const CloudLayer& layer, const Box2& box) {
  const LayerFrame frame = frame_of(layer);
  const Box2 wider = box.widened(largest_radius_m(layer) * std::max(frame.stretch, 1.0));
  std::vector<Cloud> clouds = clouds_in(layer, within_limit(layer, wider));
  std::erase_if(clouds, [&](const Cloud& cloud) { return !outline_of(cloud, frame).touches(box); });
  return clouds;
}

}  // namespace

std::pair<Vec3, Vec3> box_of(const CloudParticle& sphere, const LayerFrame& frame) {
  const Vec3 middle = frame.out_of(sphere.centre), half = half_box(frame, sphere.radius_m);
  Vec3 low = middle - half;
  low.z = std::max(low.z, frame.base_m);
  return {low, middle + half};
}

std::vector<LayerParticles> clouds_over(std::span<const CloudLayer> layers, const Box2& extent, double finest_m,
                                        int threads) {
  std::vector<LayerParticles> all;
  for (const CloudLayer& layer : layers) {
    const std::vector<Cloud> clouds = clouds_touching(layer, extent.widened(kCloudMargin_m));
    const LayerFrame frame = frame_of(layer);
    const auto each = for_each_slot<CloudParticles>(clouds.size(), threads, [&](std::size_t i) {
      return generate_cloud(layer, clouds[i], finest_m / frame.flatten);
    });
    LayerParticles particles{.layer = layer, .frame = frame, .spheres = {}, .clouds = clouds.size()};
    for (const CloudParticles& cloud : each)
      particles.spheres.insert(particles.spheres.end(), cloud.spheres.begin(), cloud.spheres.end());
    if (!particles.spheres.empty()) all.push_back(std::move(particles));
  }
  return all;
}

CloudMeasures measures_over(std::span<const CloudLayer> layers, const Box2& extent) {
  CloudMeasures sum;
  for (const CloudLayer& layer : layers) {
    const Box2 box = within_limit(layer, extent.widened(kCloudMargin_m));
    const double below_m2 = box.width() * box.height() * layer.cover, thick_m = layer.top_m - layer.base_m;
    sum.volume_m3 += below_m2 * thick_m;
    // a base, and a top of heaps
    sum.area_m2 += below_m2 * 3;
  }
  return sum;
}

}  // namespace citykiln::sky
