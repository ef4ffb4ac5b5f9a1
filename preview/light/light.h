// Light from outside of the scene: the sky or an environment map, the sun's disk, and haze.
#pragma once

#include <optional>
#include <vector>

#include "compiler/sky/generate.h"
#include "preview/light/direction_table.h"
#include "preview/light/environment_map.h"
#include "preview/rgb.h"
#include "preview/scene/lamps.h"
#include "preview/surface/microfacet.h"

namespace citykiln::preview {

/// The sources of light, but for what shines in the scene, and what rays see that hit nothing. Radiances are in
/// sky::kUnitLuminance_cd_m2.
class Lights {
 public:
  /// @param lamps  Street lamps that are lit, plane metres.
  explicit Lights(const sky::SkyModel& model, std::vector<StreetLamp> lamps = {});
  /// An environment map replaces sky and sun, and there is no haze.
  explicit Lights(const EnvironmentMap& map, std::vector<StreetLamp> lamps = {});

  Rgb sun_radiance() const { return model_.sun_radiance; }
  const std::vector<StreetLamp>& lamps() const { return lamps_; }

  /// Radiance for lighting surfaces. From below the horizon comes what dark ground reflects, or what the map shows.
  Rgb falling(Vec3 direction) const;
  /// A sample of the sky, in proportion to luminance; pdf 0 if the sky is black.
  DirectionSample sample_sky(UnitPair chance) const { return table_.sample(chance); }
  /// The density of sample_sky() in a direction, per steradian.
  double sky_pdf(Vec3 direction) const { return table_.pdf(direction); }

  /// The sun's flux over that of the sky, both through planes that face them; 0 without a sun.
  double sun_to_sky() const { return sun_to_sky_; }

  bool has_sun() const { return sun_solid_angle_ > 0; }
  /// A uniform sample of the sun's disk.
  Vec3 sample_sun(UnitPair chance) const;
  double sun_solid_angle() const { return sun_solid_angle_; }
  bool is_in_sun(Vec3 direction) const { return has_sun() && dot(direction, model_.to_sun) >= model_.sun_cos_radius; }

  /// The sky as the eye sees it, without the sun's disk. Below the horizon, beyond the edge of the ground, it is haze,
  /// since a dark or sharp edge would look like a wall.
  Rgb seen(Vec3 direction) const;
  /// The share of light that passes `distance_m` of air, and the light that is scattered into the ray: that of the
  /// horizon.
  Rgb clearness(double distance_m) const;
  Rgb haze(Vec3 direction) const;

 private:
  sky::SkyModel model_;
  bool is_map_ = false;
  double sun_solid_angle_ = 0, sun_to_sky_ = 0;
  Frame about_sun_{};
  DirectionTable table_;
  std::vector<Rgb> ring_;  // of the horizon
  Rgb below_{}, haze_mean_{};
  std::vector<StreetLamp> lamps_;
};

}  // namespace citykiln::preview
