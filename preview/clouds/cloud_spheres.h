// The spheres of one layer of clouds, for rays.
#pragma once

#include <embree3/rtcore.h>

#include <span>
#include <vector>

#include "compiler/sky/clouds/generate_cloud.h"

namespace citykiln::preview {

/// The part of a ray inside of one sphere: distances along the ray in plane metres, begin < end.
struct SpherePart {
  double begin, end;    ///< Above the base, and in front.
  double enter, leave;  ///< Of the whole line.
  double scale;         ///< (t - enter) (leave - t) scale is 1 - (distance from the middle / radius)².
  std::uint32_t sphere;
};

/// Whether droplets fill spheres evenly, or become fewer towards their surfaces, whose outlines then cannot be seen.
enum class CloudEdges { kSharp, kSoft };

/// Thread-safe.
class CloudSpheres {
 public:
  /// The clouds of a layer around an eye, each with particles as fine as pixels need: down to an upright
  /// radius of `finest` times their distance from the eye, and to 12 m. Soft.
  CloudSpheres(const sky::CloudLayer& layer, Vec3 eye, double finest);
  CloudSpheres(const sky::CloudLayer& layer, std::vector<sky::CloudParticle> spheres, CloudEdges edges);
  ~CloudSpheres();
  CloudSpheres(CloudSpheres&&) noexcept;
  CloudSpheres& operator=(CloudSpheres&&) = delete;

  /// All parts of a ray inside of spheres and above the layer's base, by where they begin; they may overlap.
  /// @param from  Plane metres; z above sea level. @param direction  Unit vector.
  void parts_of(Vec3 from, Vec3 direction, double distance_m, std::vector<SpherePart>& parts) const;
  /// Optical depth from a place to infinity, as if edges were sharp.
  double optical_depth(Vec3 from, Vec3 direction) const;
  /// Density at a distance along a ray over that in the middle of clouds, 0 to 1: 1 inside of sharp spheres, and at a
  /// depth below a soft sphere's surface of a quarter of its radius, at most 25 m. Where spheres overlap, their sum.
  double density(std::span<const SpherePart> parts, double at_m) const;
  /// What a sphere adds to the density, over (1 - (distance from its middle / radius)²).
  double edge_density(std::size_t sphere) const;

  std::size_t size() const { return spheres_.size(); }
  std::size_t clouds() const { return clouds_; }
  /// Plane metres.
  Vec3 centre(std::size_t sphere) const { return frame_.out_of(spheres_[sphere].centre); }
  /// Across the wind.
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

/// How far from the eye clouds are made. Beyond, the air hides them or the Earth's curve does: a cloud base of 1,500 m
/// sets behind the horizon at 140 km, but at 40 km it is two degrees high.
inline constexpr double kFarthestCloud_m = 40000;

}  // namespace citykiln::preview
