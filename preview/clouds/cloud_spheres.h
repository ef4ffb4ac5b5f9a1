// The spheres of one layer of clouds, for rays.
#pragma once

#include <embree3/rtcore.h>

#include <vector>

#include "compiler/sky/clouds/generate_cloud.h"

namespace citykiln::preview {

/// The part of a ray inside of one sphere: distances along the ray in plane metres, begin < end.
struct SpherePart {
  double begin, end;
  std::uint32_t sphere;
};

/// Thread-safe.
class CloudSpheres {
 public:
  /// The clouds of a layer around an eye, each with particles as fine as pixels need: down to a radius of
  /// `finest` times their distance from the eye, and to 12 m.
  CloudSpheres(const sky::CloudLayer& layer, Vec3 eye, double finest);
  explicit CloudSpheres(const sky::CloudLayer& layer, std::vector<sky::CloudParticle> spheres);
  ~CloudSpheres();
  CloudSpheres(CloudSpheres&&) noexcept;
  CloudSpheres& operator=(CloudSpheres&&) = delete;

  /// All parts of a ray inside of spheres and above the layer's base, by where they begin; they may overlap.
  /// @param from  Plane metres; z above sea level. @param direction  Unit vector.
  void parts_of(Vec3 from, Vec3 direction, double distance_m, std::vector<SpherePart>& parts) const;
  /// Optical depth from a place to infinity.
  double optical_depth(Vec3 from, Vec3 direction) const;

  std::size_t size() const { return spheres_.size(); }
  std::size_t clouds() const { return clouds_; }
  /// Plane metres.
  Vec3 centre(std::size_t sphere) const { return frame_.out_of(spheres_[sphere].centre); }
  /// Across the wind.
  double radius_m(std::size_t sphere) const { return spheres_[sphere].radius_m; }
  double extinction_per_m() const { return extinction_per_m_; }

 private:
  struct Calls;
  void build();

  sky::LayerFrame frame_;
  double extinction_per_m_;
  std::vector<sky::CloudParticle> spheres_;
  std::size_t clouds_ = 0;
  Vec3 origin_{};  // of Embree's frame, in the layer's
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

/// How far from the eye clouds are made. Beyond, the air hides them or the Earth's curve does: a cloud base of 1,500 m
/// sets behind the horizon at 140 km, but at 40 km it is two degrees high.
inline constexpr double kFarthestCloud_m = 40000;

}  // namespace citykiln::preview
