// The clouds of an output: the clouds over its extent and within kCloudMargin_m around the extent.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "compiler/sky/clouds/generate_cloud.h"

namespace citykiln::sky {

/// The distance beyond an extent up to which clouds belong to the output. A cloud at this distance and 1,500 m high is
/// 14 degrees above the horizon.
inline constexpr double kCloudMargin_m = 6000;

/// The particles (spheres of droplets) of all clouds of a layer over an extent.
struct LayerParticles {
  CloudLayer layer;
  LayerFrame frame;                    ///< The coordinate system in which the particles are spheres.
  std::vector<CloudParticle> spheres;  ///< Particles in the layer's frame.
  std::size_t clouds = 0;              ///< The number of clouds.
};

/// Returns the lowest and the highest corner of a box around a particle, cut at the layer's base, in plane metres.
std::pair<Vec3, Vec3> box_of(const CloudParticle& sphere, const LayerFrame& frame);

/// Returns, for each layer with clouds, the particles of the clouds whose outlines touch the extent widened by
/// kCloudMargin_m. If a layer has more than kMostClouds clouds there (place_clouds.h), only the clouds in the middle of
/// the extent are returned.
/// @param finest_m  The smallest vertical radius of particles, in plane metres.
/// Equal bytes for any number of threads and on every CPU. Cost: O(particles).
std::vector<LayerParticles> clouds_over(std::span<const CloudLayer> layers, const Box2& extent, double finest_m,
                                        int threads);

/// Upper estimates of the volume and the surface area of a layer's clouds over an extent, in plane metres.
struct CloudMeasures {
  double volume_m3 = 0, area_m2 = 0;
};
/// Returns the upper estimates for all layers together.
CloudMeasures measures_over(std::span<const CloudLayer> layers, const Box2& extent);

}  // namespace citykiln::sky
