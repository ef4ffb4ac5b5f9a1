// The light of the sky for one source, sun or moon, seen from one height.
#pragma once

#include <vector>

#include "compiler/sky/atmosphere/march.h"

namespace citykiln::sky {

/// The effect of air on light on its way to the eye: light · passed + added.
struct AirPath {
  Rgb passed{1, 1, 1};  ///< Share of light from behind that passes.
  Rgb added{};          ///< Light that is scattered into the ray.
};

/// The sky with one source. Radiances are in klx per steradian (kcd/m²), linear sRGB, clamped to its gamut.
///
/// Method: radiance is tabulated by the angle above the horizon (finer near it) and the azimuth from the source, and
/// light in the air by direction and distance. Light that aerosols scatter once is stored without its phase function,
/// which has a peak about the source and is multiplied at each query.
class SkyDome {
 public:
  /// Computes the tables. Cost: 0.2 s.
  /// @param eye_height_m  Above sea level; clamped to 0 to 20,000 m.
  /// @param irradiance    The source's irradiance outside of the atmosphere, relative to the sun's.
  SkyDome(const LitAir& lit, Vec3 to_source, double eye_height_m, double irradiance);

  /// Returns the radiance of the sky in a unit direction, without the source's disk; below the horizon, the radiance at
  /// the horizon. O(1).
  Rgb radiance(Vec3 direction) const;
  /// Returns the effect of the air along a ray from the eye up to a distance, at most 200 km. O(1).
  AirPath air(Vec3 direction, double distance_m) const;

  /// Returns the direct light of the source at the eye: the illuminance, in klx, of a surface that faces the source.
  Rgb direct() const { return direct_; }
  /// Returns the illuminance of level ground at sea level, klx.
  Rgb ground() const { return ground_; }
  /// True if a ray from the eye meets the sea.
  bool sees_sea(Vec3 direction) const { return direction.z < horizon_cosine(eye_height_m_); }
  /// Returns the distance at which a ray for which sees_sea() holds meets the sea.
  double sea_m(Vec3 direction) const { return way_m(eye_height_m_, direction.z); }

 private:
  // Radiances that are complete, and those that the aerosols' phase function multiplies later.
  struct Light {
    std::array<float, 3> smooth, aerosols;
  };
  struct Cell {
    int index;
    double share;
  };
  Cell azimuth_cell(Vec3 direction, int columns) const;
  static Light light_of(const MarchedLight& marched, double cosine, double scale);
  Rgb with_phase(const Light& light, Vec3 direction) const;
  void fill_sky(const LitAir& lit, const ScatteredField& field);
  void fill_air(const LitAir& lit, const ScatteredField& field);

  Vec3 to_source_;
  double eye_height_m_, irradiance_, horizon_rad_;
  Rgb direct_{}, ground_{};
  std::vector<Light> sky_;                   // rows above the horizon, columns of azimuth
  std::vector<Light> air_;                   // rows, columns, distances; per metre
  std::vector<std::array<float, 3>> depth_;  // rows, distances; per metre
};

}  // namespace citykiln::sky
