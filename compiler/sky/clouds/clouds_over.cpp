#include "compiler/sky/clouds/clouds_over.h"

#include <utility>

#include "compiler/contract/for_each_slot.h"

namespace citykiln::sky {

std::vector<LayerParticles> clouds_over(std::span<const CloudLayer> layers, const Box2& extent, double finest_m,
                                        int threads) {
  std::vector<LayerParticles> all;
  for (const CloudLayer& layer : layers) {
    const std::vector<Cloud> clouds = clouds_in(layer, within_limit(layer, extent.widened(kCloudMargin_m)));
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
