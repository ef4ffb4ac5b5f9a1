// Generates the particles of a cloud, and integrates its optical depth along rays. A particle is a sphere filled with
// droplets.
//
// The layer's frame is a coordinate system in metres: x along the wind, y across, z up from the layer's base. It is
// scaled along the wind and upwards so that particles are spheres (LayerFrame in place_clouds.h). LayerFrame::into()
// and into_direction() convert points and directions of the plane to it.
#pragma once

#include <utility>
#include <vector>

#include "compiler/sky/clouds/place_clouds.h"

namespace citykiln::sky {

/// A sphere filled with droplets, in the layer's frame.
struct CloudParticle {
  Vec3 centre;
  double radius_m = 0;
};

/// The particles of a cloud. The cloud is their union above the layer's base, evenly filled with droplets.
struct CloudParticles {
  std::vector<CloudParticle> spheres;  ///< The larger ones first.
  double finest_m = 0;                 ///< Particles of smaller radii were left out, in metres of the layer's frame.
  /// An estimate of the largest error of the optical depth along a ray, compared with the cloud with all its particles:
  /// the optical depth of a length of kMissedDiameters diameters of the largest particle that was left out. It is
  /// measured, not a bound. 0 if no particle was left out.
  double depth_error = 0;
};

/// The longest way of a ray that is inside of left-out particles but outside of all others, in diameters of the largest
/// left-out particle. Measured: at most 4.0, with 10,000 rays through each of three clouds at six levels (chart cloud).
inline constexpr double kMissedDiameters = 5;

/// Returns the extinction by the droplets or the ice of a kind of cloud, per metre. Sources: cumulus and stratus have w
/// = 0.3 and 0.2 g of water in a cubic metre, in droplets of r = 10 µm (Rogers, Yau, "A Short Course in Cloud Physics",
/// 1989), which gives 3 w / (2 rho r); cirrus has about 0.3 per km (Sassen, Comstock 2001).
double extinction_per_m(CloudKind kind);

/// Returns the particles of a cloud down to a radius: large spheres (heaps), with smaller spheres on their upper
/// surfaces, and so on (Bouthors, Neyret, "Modeling Clouds Shape", Eurographics 2004). With a larger `finest_m` the
/// smallest particles are left out; all others have equal positions and radii. Random numbers depend on layer.seed and
/// cloud.id alone. Cost: O(particles).
///
/// @param finest_m  Smallest radius, > 0, in metres of the layer's frame.
CloudParticles generate_cloud(const CloudLayer& layer, const Cloud& cloud, double finest_m);

/// Returns the largest difference of optical depth, over random rays, between a cloud of particles down to a radius of
/// `coarse_m` and the same cloud down to `finest_m`, both in metres of the layer's frame.
/// @param rays  The number of rays.
double optical_depth_error(const CloudLayer& layer, const Cloud& cloud, double coarse_m, double finest_m, int rays);

/// Returns the distances, in units of the length of `direction`, at which the line of a ray enters and leaves a sphere;
/// {0, 0} if the line misses the sphere. Places behind `from` have negative distances: the first is negative if the ray
/// begins in the sphere, both if the sphere is behind. Points and directions are in the layer's frame.
std::pair<double, double> chord_of(const CloudParticle& sphere, Vec3 from, Vec3 direction);
/// Returns the part of a chord (the result of chord_of()) above z = 0, the base of the layer. Its end is not after its
/// begin if no part is above the base.
std::pair<double, double> above_base(std::pair<double, double> chord, Vec3 from, Vec3 direction);
/// Returns above_base(chord_of(…)): the part of a ray's line inside of a sphere and above the base.
std::pair<double, double> part_inside(const CloudParticle& sphere, Vec3 from, Vec3 direction);

/// Returns the optical depth of a cloud along a ray, from `from` to infinity. O(n log n) in the particles.
/// @param from       In the layer's frame.
/// @param direction  LayerFrame::into_direction() of a unit vector of the plane. Its length is then one metre of the
/// plane, in which extinction is counted.
double optical_depth(CloudKind kind, const CloudParticles& particles, Vec3 from, Vec3 direction);

}  // namespace citykiln::sky
