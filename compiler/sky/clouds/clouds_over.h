// The clouds that are in outputs: those over an extent, and around it.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "compiler/sky/clouds/generate_cloud.h"

namespace citykiln::sky {

/// Clouds so far beyond an extent belong to it: from there a cloud at 1,500 m is 14 degrees high.
inline constexpr double kCloudMargin_m = 6000;

/// The particles of all clouds of a layer over an extent.
struct LayerParticles {
  CloudLayer layer;
  LayerFrame frame;
  std::vector<CloudParticle> spheres;  ///< In the layer's frame.
  std::size_t clouds = 0;
};

/// The box in the plane around the part of a particle above the base: its lowest and highest corners.
std::pair<Vec3, Vec3> box_of(const CloudParticle& sphere, const LayerFrame& frame);

/// Returns the particles of the clouds whose outlines touch a box widened by kCloudMargin_m, or of those in the middle
/// of it where there are more than kMostClouds (place_clouds.h). Layers without clouds are left out.
/// @param finest_m  The smallest upright radius of particles, in plane metres.
/// Same bytes for any number of threads and on every CPU. Cost: O(particles).
std::vector<LayerParticles> clouds_over(std::span<const CloudLayer> layers, const Box2& extent, double finest_m,
                                        int threads);

/// An upper estimate of the volume of a layer's clouds there, and of the area of their surface, in the plane.
struct CloudMeasures {
  double volume_m3 = 0, area_m2 = 0;
};
CloudMeasures measures_over(std::span<const CloudLayer> layers, const Box2& extent);

}  // namespace citykiln::sky
