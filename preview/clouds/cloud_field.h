// Clouds between the eye and the sky: the light that they send along a ray, and what they let pass.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "compiler/sky/generate.h"
#include "preview/clouds/cloud_spheres.h"
#include "preview/rgb.h"

namespace citykiln::preview {

/// Clouds along a ray.
struct CloudPath {
  double passed = 1;      ///< Share of light from behind that passes.
  Rgb added{};            ///< Light of the clouds themselves.
  double distance_m = 0;  ///< Mean distance of what is seen of them; 0 where there are none.
};

/// Light that falls on clouds.
struct CloudLight {
  Vec3 to_sun{0, 0, 1};
  Rgb sun{};     ///< Irradiance of the sun, of a plane that faces it.
  Rgb sky{};     ///< Mean radiance from above.
  Rgb ground{};  ///< From below.
};

CloudLight light_on_clouds(const sky::SkyModel& model);

/// Henyey and Greenstein's phase function, per steradian; `g` is the mean cosine.
double henyey_greenstein(double cosine, double g);

/// The mean cosine of scattering by droplets (0.85 for visible light, Liou 2002).
inline constexpr double kDropletAsymmetry = 0.85;

/// Layers of clouds, lit for rays. Thread-safe; the same bits for any number of threads.
///
/// Method: light that is scattered many times goes mostly forwards (Harris, Lastra, "Real-Time Cloud Rendering",
/// Eurographics 2001), so the sun's light in each particle is a sum of few terms, each weaker, less attenuated on the
/// way from the sun, and less directed than the one before (Wrenninge, Kulla, Lundqvist, "Oz: The Great and
/// Volumetric", SIGGRAPH 2013 talks); its factors are fitted to paths through clouds (cloud_paths.h). Light of sky and
/// ground is that of a plane layer of the same optical depth above and below (two-stream approximation, Bohren 1987).
/// Along a ray, light is that of the spheres that it passes, the mean of these where several overlap, with weights that
/// are 0 at their surfaces. Layers shade each other.
class CloudField {
 public:
  /// @param eye  Plane metres. @param finest  As for CloudSpheres. Cost: O(n log n) in the particles.
  CloudField(std::span<const sky::CloudLayer> layers, const CloudLight& light, Vec3 eye, double finest, int threads);
  /// One layer of given particles.
  CloudField(const sky::CloudLayer& layer, std::vector<sky::CloudParticle> spheres, const CloudLight& light,
             CloudEdges edges);

  /// @param from  Plane metres; z above sea level. @param direction  Unit vector.
  CloudPath along(Vec3 from, Vec3 direction, double distance_m) const;
  /// The share of the sun's light that reaches a place: what comes straight, or scattered by less than the size of a
  /// shadow's blurred edge.
  double sun_passed(Vec3 from) const;
  std::size_t particles() const;
  std::size_t clouds() const;
  const CloudLight& light() const { return light_; }
  std::size_t layers() const { return layers_.size(); }
  const CloudSpheres& spheres(std::size_t layer) const { return layers_[layer].spheres; }
  /// The base of the lowest layer; infinite without layers.
  double lowest_m() const;

 private:
  static constexpr int kTerms = 4;
  struct Lit {
    std::array<float, kTerms> sun;  // terms, without their phase
    float sky, ground;
  };
  struct Layer {
    CloudSpheres spheres;
    std::vector<Lit> lit;
  };
  class March;
  void light_all(int threads);
  Lit lit_at(Vec3 at) const;
  double optical_depth(Vec3 from, Vec3 direction) const;

  CloudLight light_;
  std::vector<Layer> layers_;  // the lowest first
};

}  // namespace citykiln::preview
