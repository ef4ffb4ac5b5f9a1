// The light that clouds send along a ray, and the share of light that they let pass.
#pragma once

#include <span>
#include <vector>

#include "compiler/sky/generate.h"
#include "preview/clouds/cloud_heaps.h"
#include "preview/rgb.h"

namespace citykiln::preview {

/// Clouds along a ray.
struct CloudPath {
  double passed = 1;      ///< Share of light from behind that passes.
  Rgb added{};            ///< Light of the clouds themselves.
  double distance_m = 0;  ///< Mean distance of the clouds that are seen; 0 where there are none.
};

/// Light that falls on clouds. Radiance is in sky::kUnitLuminance_cd_m2.
struct CloudLight {
  Vec3 to_sun{0, 0, 1};
  Rgb sun{};     ///< Irradiance by the sun of a plane that faces it.
  Rgb sky{};     ///< Mean radiance from above.
  Rgb ground{};  ///< Mean radiance from below.
};

/// Returns the light that falls on clouds under a sky.
CloudLight light_on_clouds(const sky::SkyModel& model);

/// Returns the phase function of Henyey and Greenstein, per steradian.
/// @param cosine   The cosine of the angle of deflection.
/// @param g       The mean cosine.
double henyey_greenstein(double cosine, double g);

/// The mean cosine of scattering by droplets (0.85 for visible light, Liou 2002).
inline constexpr double kDropletAsymmetry = 0.85;

/// Layers of clouds and the light in them. Thread-safe; the same bits for any number of threads.
///
/// Method: a march through the density of CloudHeaps, in steps that grow with the optical depth that was passed. Light
/// that is scattered many times goes mostly forwards (Harris, Lastra, "Real-Time Cloud Rendering", Eurographics 2001).
/// Therefore the sun's light at each step is a sum of a few terms, each less attenuated on the way from the sun, and
/// less directed, than the one before (Wrenninge, Kulla, Lundqvist, "Oz: The Great and Volumetric", SIGGRAPH 2013
/// talks). The factors of the terms are fitted to paths through clouds (cloud_paths.h). The light of sky and ground is
/// computed for a plane layer of the same optical depth above and below (two-stream approximation, Bohren 1987). The
/// optical depths are sums over a few places, at distances that double. Layers shade each other. No random numbers.
class CloudField {
 public:
  /// Makes the clouds of all layers around an eye. Cost: O(clouds).
  /// @param eye        Plane metres.
  /// @param pixel_rad  The angle of the finest detail at the eye; billows that are smaller are left out.
  CloudField(std::span<const sky::CloudLayer> layers, const CloudLight& light, Vec3 eye, double pixel_rad);
  /// Makes one layer of given spheres, in the layer's frame (sky::LayerFrame).
  CloudField(const sky::CloudLayer& layer, std::span<const sky::CloudParticle> spheres, const CloudLight& light,
             CloudEdges edges);

  /// Returns the light of clouds along a ray. Cost: 0.1 µs beside clouds, some 10 µs through one.
  /// @param from  Plane metres; z above sea level.
  /// @param direction  Unit vector.
  CloudPath along(Vec3 from, Vec3 direction, double distance_m) const;
  /// Returns the share of the sun's light that reaches a place, straight or scattered by less than the width of a
  /// shadow's blurred edge.
  /// @param from  Plane metres; z above sea level.
  double sun_passed(Vec3 from) const;
  bool is_empty() const;
  std::size_t clouds() const;
  const CloudLight& light() const { return light_; }
  std::span<const CloudHeaps> layers() const { return layers_; }
  /// Returns the base of the lowest layer above sea level; infinite without layers.
  double lowest_m() const;
  /// Returns the size of the smallest billows that are seen at a distance from the eye, in metres.
  double finest_m(double distance_m) const { return pixel_rad_ * distance_m; }

 private:
  class March;
  CloudLight light_;
  double pixel_rad_ = 0;
  std::vector<CloudHeaps> layers_;  // the lowest first
};

}  // namespace citykiln::preview
