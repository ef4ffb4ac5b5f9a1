// Light from outside of the scene: sky, sun, moon and stars, or an environment map; the land around; and the air.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "compiler/sky/generate.h"
#include "preview/clouds/clouds.h"
#include "preview/light/direction_table.h"
#include "preview/light/environment_map.h"
#include "preview/light/fog.h"
#include "preview/light/star_map.h"
#include "preview/light/surroundings.h"
#include "preview/rgb.h"
#include "preview/scene/lamps.h"
#include "preview/surface/microfacet.h"

namespace citykiln::preview {

/// The sky with its light, and the surroundings that rays see where they hit nothing in the scene. Radiances are in
/// sky::kUnitLuminance_cd_m2. "The sun" is the disk that throws shadows; by night it is the moon's.
class Lights {
 public:
  /// @param lamps   Street lamps that are lit, plane metres. LocalLights samples them.
  /// @param around  The land around the scene; empty: the ground at sea level.
  /// @param fog     Hides things from the eye, but takes no light from surfaces.
  /// @param clouds  Null: no clouds.
  explicit Lights(const sky::SkyModel& model, std::vector<StreetLamp> lamps = {},
                  std::optional<Surroundings> around = {}, std::optional<Fog> fog = {},
                  std::shared_ptr<const Clouds> clouds = {});
  /// Makes the light of an environment map, which replaces sky and sun. There is no air.
  explicit Lights(const EnvironmentMap& map, std::vector<StreetLamp> lamps = {});

  Rgb sun_radiance() const { return model_.sun_radiance; }
  const std::vector<StreetLamp>& lamps() const { return lamps_; }

  /// The radiance that falls on surfaces from a direction, without the sun's disk. Below the horizon it is the light
  /// that the ground around reflects, or the map's.
  /// @param from  See seen().
  Rgb falling(Vec3 from, Vec3 direction) const;
  /// The share of the sun's light that clouds let pass to a place.
  double sun_passed(Vec3 from) const { return clouds_ ? clouds_->sun_passed(from) : 1; }
  /// A sample of the sky's directions, about in proportion to luminance; pdf 0 if the sky is black.
  DirectionSample sample_sky(UnitPair chance) const { return table_.sample(chance); }
  /// The density of sample_sky() in a direction, per steradian.
  double sky_pdf(Vec3 direction) const { return table_.pdf(direction); }

  /// The illuminance by the sun over that by the sky, each summed over its directions; 0 without a sun.
  double sun_to_sky() const { return sun_to_sky_; }

  bool has_sun() const { return sun_solid_angle_ > 0; }
  /// A uniform sample of the sun's disk.
  Vec3 sample_sun(UnitPair chance) const;
  double sun_solid_angle() const { return sun_solid_angle_; }
  bool is_in_sun(Vec3 direction) const { return has_sun() && dot(direction, model_.to_sun) >= model_.sun_cos_radius; }

  /// The radiance that the eye sees along a ray that hits nothing: the sky, or the land and sea around, behind air. It
  /// has no sun's disk. Rays of the camera alone (`is_camera`) also see stars and the moon's disk.
  /// @param from       Plane metres; z above sea level.
  /// @param pixel_rad  Angle of a pixel.
  Rgb seen(Vec3 from, Vec3 direction, double pixel_rad, bool is_camera) const;
  /// The distance at which a ray that hits nothing in the scene meets the ground around; empty if it does not.
  std::optional<double> ground_m(Vec3 from, Vec3 direction) const;
  /// The effect of air, fog and clouds between the eye and a surface.
  /// @param from  See seen().
  sky::AirPath air(Vec3 from, Vec3 direction, double distance_m) const;

 private:
  sky::AirPath clear_air(Vec3 from, Vec3 direction, double distance_m) const;
  Rgb bodies(Vec3 direction, double pixel_rad) const;
  Rgb around_at(const Edge& edge, Vec3 direction) const;
  Rgb behind_fog(Vec3 from, Vec3 direction, const Rgb& light) const;

  sky::SkyModel model_;
  bool is_map_ = false;
  double sun_solid_angle_ = 0, sun_to_sky_ = 0;
  Frame about_sun_{};
  DirectionTable table_;
  StarMap stars_;
  std::optional<Surroundings> around_;
  std::optional<Fog> fog_;
  std::shared_ptr<const Clouds> clouds_;
  Rgb below_{};
  std::vector<StreetLamp> lamps_;
};

}  // namespace citykiln::preview
