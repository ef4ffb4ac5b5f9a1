// Light from outside of the scene: sky, sun, moon and stars, or an environment map; the land around the scene; and the
// effect of air, fog and clouds. Directions are unit vectors.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "compiler/sky/generate.h"
#include "preview/clouds/clouds.h"
#include "preview/light/direction_table.h"
#include "preview/light/environment_map.h"
#include "preview/light/fog.h"
#include "preview/light/inside_lights.h"
#include "preview/light/star_map.h"
#include "preview/light/surroundings.h"
#include "preview/rgb.h"
#include "preview/scene/lamps.h"
#include "preview/surface/microfacet.h"

namespace citykiln::preview {

/// The light of the sky, and the surroundings that rays see where they hit nothing in the scene. Radiances are in
/// sky::kUnitLuminance_cd_m2. "The sun" is the disk that throws shadows; by night it is the disk of the moon.
class Lights {
 public:
  /// @param lamps   Street lamps that are lit, plane metres. This class only stores them; LocalLights samples them.
  /// @param around  The land around the scene; empty: the ground at sea level.
  /// @param fog     Hides things from the eye, but takes no light from surfaces.
  /// @param clouds  Null: no clouds.
  explicit Lights(const sky::SkyModel& model, std::vector<StreetLamp> lamps = {},
                  std::optional<Surroundings> around = {}, std::optional<Fog> fog = {},
                  std::shared_ptr<const Clouds> clouds = {});
  /// Makes the light inside of a cylinder, which replaces sky, sun and the land around. Places are in its frame.
  explicit Lights(const InsideLights& inside, std::vector<StreetLamp> lamps = {});
  /// Makes the light of an environment map, which replaces sky and sun. There is no air.
  explicit Lights(const EnvironmentMap& map, std::vector<StreetLamp> lamps = {});

  Rgb sun_radiance() const { return model_.sun_radiance; }
  /// Returns the colour of the light outside, of any brightness: by day and in twilight that of level white ground, by
  /// night that of all lamps. Black if there is none: without lamps, inside of a cylinder, with an environment map.
  Rgb white() const;
  const std::vector<StreetLamp>& lamps() const { return lamps_; }
  /// Returns the lines of light inside of a cylinder; null in other worlds.
  const InsideLights* inside() const { return inside_ ? &*inside_ : nullptr; }

  /// Returns the radiance that falls on surfaces from a direction, without the sun's disk. Below the horizon it is the
  /// light reflected by the ground around the scene, or the radiance of the map.
  /// @param from  Plane metres; z above sea level.
  Rgb falling(Vec3 from, Vec3 direction) const;
  /// Returns the share of the sun's light that passes the clouds on the way to a place (plane metres).
  double sun_passed(Vec3 from) const { return clouds_ ? clouds_->sun_passed(from) : 1; }
  /// Returns a sample of the sky's directions, about in proportion to luminance; pdf 0 if the sky is black.
  /// @param chance  Two uniform random numbers in [0, 1).
  DirectionSample sample_sky(UnitPair chance) const { return table_.sample(chance); }
  /// Returns the density of sample_sky() in a direction, per steradian.
  double sky_pdf(Vec3 direction) const { return table_.pdf(direction); }

  /// Returns the illuminance by the sun divided by the illuminance by the sky, each summed over its directions; 0
  /// without a sun.
  double sun_to_sky() const { return sun_to_sky_; }

  bool has_sun() const { return sun_solid_angle_ > 0; }
  /// Returns a uniform sample of the directions to the sun's disk.
  Vec3 sample_sun(UnitPair chance) const;
  double sun_solid_angle() const { return sun_solid_angle_; }
  /// True if the direction points to the sun's disk.
  bool is_in_sun(Vec3 direction) const { return has_sun() && dot(direction, model_.to_sun) >= model_.sun_cos_radius; }

  /// Returns the radiance that the eye sees along a ray that hits nothing: the sky, or the land and sea around, behind
  /// air, without the sun's disk.
  /// @param from       Plane metres; z above sea level.
  /// @param pixel_rad  Angle of a pixel.
  /// @param is_camera  The ray comes from the camera, so it also sees stars and the moon's disk.
  Rgb seen(Vec3 from, Vec3 direction, double pixel_rad, bool is_camera) const;
  /// Returns the distance at which a ray that hits nothing in the scene meets the ground around it; empty if it does
  /// not.
  /// @param from  Plane metres; z above sea level.
  std::optional<double> ground_m(Vec3 from, Vec3 direction) const;
  /// Returns the effect of air, fog and clouds between the eye and a surface: the light that passes and the light that
  /// they add.
  /// @param from  Plane metres; z above sea level.
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
  std::optional<InsideLights> inside_;
  std::shared_ptr<const Clouds> clouds_;
  Rgb below_{};
  std::vector<StreetLamp> lamps_;
};

}  // namespace citykiln::preview
