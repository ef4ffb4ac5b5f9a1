// The clouds of an output: those over its extent, and around it.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "compiler/sky/clouds/generate_cloud.h"

namespace citykiln::sky {

/// The distance beyond an extent up to which clouds belong to it. From the border, a cloud there at 1,500 m is 14
/// degrees high.
inline constexpr double kCloudMargin_m = 6000;

/// The particles of all clouds of a layer over an extent.
struct LayerParticles {
  CloudLayer layer;
  LayerFrame frame;
  std::vector<CloudParticle> spheres;  ///< Particles in the layer's frame.
  std::size_t clouds = 0;
};

/// Returns the box around the part of a particle above the base: its lowest and highest corners, in plane metres.
std::pair<Vec3, Vec3> box_of(const CloudParticle& sphere, const LayerFrame& frame);

/// Returns the particles of the clouds whose outlines touch a box widened by kCloudMargin_m. If there are more than
/// kMostClouds of them (place_clouds.h), only those in the middle of the box. Layers without clouds are left out.
/// @param finest_m  The smallest vertical radius of particles, in plane metres.
/// Equal bytes for any number of threads and on every CPU. Cost: O(particles).
std::vector<LayerParticles> clouds_over(std::span<const CloudLayer> layers, const Box2& extent, double finest_m,
                                        int threads);

/// Upper estimates of the volume and the surface area of a layer's clouds over an extent, in plane metres.
struct CloudMeasures {
  double volume_m3 = 0, area_m2 = 0;
};
CloudMeasures measures_over(std::span<const CloudLayer> layers, const Box2& extent);

}  // namespace citykiln::sky
