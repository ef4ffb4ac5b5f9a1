#include "compiler/sky/clouds/clouds_over.h"

#include <algorithm>
#include <utility>

#include "compiler/contract/system/for_each_slot.h"

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

// A flat disc with a dome on it takes at most a cylinder's room, and no more than all outlines together.
CloudMeasures measures_over(std::span<const CloudLayer> layers, const Box2& extent) {
  CloudMeasures sum;
  for (const CloudLayer& layer : layers) {
    const LayerFrame frame = frame_of(layer);
    double plan_m2 = 0, sides_m2 = 0;
    Box2 all;
    for (const Cloud& cloud : clouds_touching(layer, extent.widened(kCloudMargin_m))) {
      const Box2 outline = outline_of(cloud, frame);
      all.grow(outline.min), all.grow(outline.max);
      plan_m2 += outline.width() * outline.height();
      sides_m2 += 2 * (outline.width() + outline.height()) * cloud.height_m * frame.flatten;
    }
    if (all.is_empty()) continue;
    const double covered_m2 = std::min(plan_m2, all.width() * all.height());
    sum.volume_m3 += covered_m2 * (layer.top_m - layer.base_m);
    sum.area_m2 += 2 * covered_m2 + sides_m2 * covered_m2 / plan_m2;
  }
  return sum;
}

}  // namespace citykiln::sky
