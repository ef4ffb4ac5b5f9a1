// Sky glow: light of towns that air scatters back to the eye.
//
//        eye ·──────── ray ────────x───      light of each cell of the ground goes up to places x of the ray,
//     ___▪__▪____________________╱_____      and some of it is scattered along the ray to the eye
//        lamps                 ▪ cell
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/sky/atmosphere/bands.h"

namespace citykiln::sky {

/// A street lamp as a source of sky glow.
struct GroundLight {
  Vec2 from_eye_m;   ///< East and north of the eye.
  double lumen = 0;  ///< Luminous flux of the lamp. >= 0.
  double temperature_k = 3000;
};

/// The largest distance of lamps that count, in metres. By Walker's law, brightness about distance^-2.5, a town at 30
/// km gives a thousandth of the glow inside the town.
inline constexpr double kGlowRadius_m = 30000;

/// The sky glow that an eye sees. Radiances are in klx per steradian (kcd/m²), linear sRGB. Immutable and thread-safe.
///
/// Method: single scattering by molecules and aerosols over a flat Earth, after Garstang, "Model for artificial
/// night-sky illumination", PASP 98, 1986, with his constants: of each lumen of outdoor light 0.15 go up from fixtures,
/// by the fourth power of the zenith angle, and the ground reflects 0.15 of the rest, by its cosine. Lamps are added up
/// in cells of 250 m, and beyond 4 km in cells of 500 m to 2 km. Street lamps are taken as a third of outdoor light:
/// they are an eighth in Flagstaff (Luginbuhl et al., "From the ground up I", PASP 121, 2009), up to a half in towns of
/// Europe.
class TownGlow {
 public:
  /// Computes the glow. Cost: some 0.5 ms for each cell with lamps, of which there are at most some 2,600.
  /// @param eye_height_m  Above the lamps and the sea.
  TownGlow(const Air& air, std::span<const GroundLight> lights, double eye_height_m);

  /// Returns the radiance in a unit direction; below the horizon, the radiance at the horizon. O(1).
  Rgb radiance(Vec3 direction) const;
  /// Returns the illuminance of level ground, klx.
  Rgb ground() const { return ground_; }

 private:
  std::vector<Rgb> cells_;  // rows above the horizon, columns of azimuth
  Rgb ground_{};
};

}  // namespace citykiln::sky
