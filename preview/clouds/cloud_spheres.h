// The spheres of one layer of clouds, for rays.
#pragma once

#include <embree3/rtcore.h>

#include <span>
#include <vector>

#include "compiler/sky/clouds/generate_cloud.h"

namespace citykiln::preview {

/// The part of a ray inside of one sphere. Distances along the ray are in plane metres, begin < end.
struct SpherePart {
  double begin, end;    ///< The part above the layer's base and in front of the ray's origin.
  double enter, leave;  ///< The whole chord of the line that the ray lies on.
  double scale;         ///< At distance t, (t - enter) (leave - t) scale is 1 - (distance from the middle / radius)².
  std::uint32_t sphere;
};

/// The density inside of spheres: constant, or falling towards the surface, so that the outlines of spheres are
/// invisible.
enum class CloudEdges { kSharp, kSoft };

/// The spheres (sky::CloudParticle) of one layer of clouds in an Embree scene. Thread-safe.
class CloudSpheres {
 public:
  /// Generates the clouds of a layer around an eye (plane metres), with soft edges. Each cloud has particles as fine as
  /// pixels need: down to a vertical radius of `finest_rad` times its distance from the eye, but not below 12 m.
  CloudSpheres(const sky::CloudLayer& layer, Vec3 eye, double finest_rad);
  /// Takes given particles, in the layer's frame (sky::LayerFrame).
  CloudSpheres(const sky::CloudLayer& layer, std::vector<sky::CloudParticle> spheres, CloudEdges edges);
  ~CloudSpheres();
  CloudSpheres(CloudSpheres&&) noexcept;
  CloudSpheres& operator=(CloudSpheres&&) = delete;

  /// Sets `parts` to all parts of a ray inside of spheres and above the layer's base, sorted by `begin`. Parts may
  /// overlap.
  ///
  /// @param from        Plane metres; z above sea level.
  /// @param direction   Unit vector.
  /// @param distance_m  The length of the ray. Nothing beyond four times kFarthestCloud_m is found.
  void parts_of(Vec3 from, Vec3 direction, double distance_m, std::vector<SpherePart>& parts) const;
  /// Returns the optical depth from a place (plane metres) in a direction (unit vector) to infinity, as if edges were
  /// sharp.
  double optical_depth(Vec3 from, Vec3 direction) const;
  /// Returns the density at a distance along a ray, relative to the middle of clouds, 0 to 1. Inside of sharp spheres
  /// the density is 1. The density of a soft sphere rises from 0 at its surface to about 1 within a quarter of the
  /// radius, at least 8 m and at most 25 m; the densities of overlapping spheres are added.
  /// @param parts  The result of parts_of() for the ray.
  double density(std::span<const SpherePart> parts, double at_m) const;
  /// Returns the factor f of a soft sphere, whose density is f · (1 - (distance from its middle / radius)²).
  double edge_density(std::size_t sphere) const;

  std::size_t size() const { return spheres_.size(); }
  std::size_t clouds() const { return clouds_; }
  /// Returns the centre of a sphere in plane metres.
  Vec3 centre(std::size_t sphere) const { return frame_.out_of(spheres_[sphere].centre); }
  /// Returns the radius of a sphere across the wind, in metres.
  double radius_m(std::size_t sphere) const { return spheres_[sphere].radius_m; }
  double extinction_per_m() const { return extinction_per_m_; }
  double base_m() const { return frame_.base_m; }
  double top_m() const { return top_m_; }
  bool is_soft() const { return edges_ == CloudEdges::kSoft; }

 private:
  struct Calls;
  void build();
  bool meets_slab(Vec3 from, Vec3 direction, double distance_m) const;

  sky::LayerFrame frame_;
  double extinction_per_m_;
  CloudEdges edges_ = CloudEdges::kSoft;
  std::vector<sky::CloudParticle> spheres_;
  std::size_t clouds_ = 0;
  double top_m_ = -1e300;
  Vec3 origin_{};  // of Embree's frame, in the layer's
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

/// The largest distance from the eye at which clouds are generated. Beyond it, air or the Earth's curve hides them: a
/// cloud base of 1,500 m sets behind the horizon at 140 km, but at 40 km it is two degrees high.
inline constexpr double kFarthestCloud_m = 40000;

}  // namespace citykiln::preview
