// Generates the particles of a cloud.
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
  double finest_m = 0;                 ///< Particles of smaller radii were left out.
  /// The largest error of the optical depth along any ray, relative to the cloud with all its particles: the optical
  /// depth of kMissedDiameters of the largest particle that was left out. 0 if none was.
  double depth_error = 0;
};

/// The longest way of a ray through left-out particles and outside of the others, in diameters of such particles. A ray
/// grazes a few heaps, each with particles on it that have smaller ones on them. Measured: at most 4.0, with 10,000
/// rays through each of three clouds at six levels (chart cloud).
inline constexpr double kMissedDiameters = 5;

/// The extinction by the droplets or the ice of a kind of cloud, per metre. Sources: cumulus and stratus have 0.3 and
/// 0.2 g of water in a cubic metre, in droplets of 10 µm (Rogers, Yau, "A Short Course in Cloud Physics", 1989), which
/// gives 3 w / (2 rho r); cirrus has about 0.3 per km (Sassen, Comstock 2001).
double extinction_per_m(CloudKind kind);

/// Returns the particles of a cloud down to a radius: heaps of spheres, on whose upper surfaces sit smaller ones, and
/// so on (Bouthors, Neyret, "Modeling Clouds Shape", Eurographics 2004). A coarser cloud lacks the smallest particles;
/// the others are equal. Cost: O(particles).
/// @param finest_m  Smallest radius, > 0, in metres of the layer's frame.
CloudParticles generate_cloud(const CloudLayer& layer, const Cloud& cloud, double finest_m);

/// Returns the largest difference of optical depth between a cloud down to `coarse_m` and one down to `finest_m`, over
/// `rays` random rays through it.
double optical_depth_error(const CloudLayer& layer, const Cloud& cloud, double coarse_m, double finest_m, int rays);

/// Returns the distances, in lengths of `direction`, at which the line of a ray enters and leaves a sphere; {0, 0} if
/// it does not meet it. Frame of the layer.
std::pair<double, double> chord_of(const CloudParticle& sphere, Vec3 from, Vec3 direction);
/// Returns the part of a chord above the base. If there is none, its end is not after its begin.
std::pair<double, double> above_base(std::pair<double, double> chord, Vec3 from, Vec3 direction);
/// Returns the part of a ray's line inside of a sphere and above the base.
std::pair<double, double> part_inside(const CloudParticle& sphere, Vec3 from, Vec3 direction);

/// Returns the optical depth of a cloud along a ray. O(n log n).
/// @param from       In the layer's frame.
/// @param direction  In the layer's frame. Its length is that of one metre of the plane, which is the unit along the
/// ray.
double optical_depth(CloudKind kind, const CloudParticles& particles, Vec3 from, Vec3 direction);

}  // namespace citykiln::sky
