// The light that air scatters into a ray, summed up step by step (marched). The source is sun or moon.
#pragma once

#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/sky/atmosphere/bands.h"
#include "compiler/sky/atmosphere/scattered_field.h"

namespace citykiln::sky {

// The columns of air along a ray (the integral of the air's density over its length) from a place to outside of the
// atmosphere.

/// Returns the cosine of the zenith angle of the sea's horizon, seen from a height above sea level; <= 0.
double horizon_cosine(double height_m);

/// Returns the share of the disk of sun or moon that is above the horizon, 0 to 1.
/// @param cos_zenith  The cosine of the zenith angle of the disk's middle.
double disk_share(double height_m, double cos_zenith);

/// Returns the distance at which a ray leaves the air or meets the sea.
/// @param height_m    0 to kTop_m.
/// @param cos_zenith  The cosine of the zenith angle of the ray's direction.
double way_m(double height_m, double cos_zenith);

/// A table of the columns of air from a place to outside of the atmosphere.
class ColumnTable {
 public:
  explicit ColumnTable(const Air& air);
  /// Returns the columns along a ray, within 1 % of the integral; below the horizon, the columns at the horizon. O(1).
  Columns at(double height_m, double cos_zenith) const;

 private:
  std::vector<Columns> cells_;  // rows of heights; finer near the ground, and near the horizon
};

/// The air with its tables, for a source of parallel light.
struct LitAir {
  Air air;
  BandCoefficients coefficients;
  ColumnTable columns;
  explicit LitAir(const Air& given) : air(given), coefficients(band_coefficients(given)), columns(given) {}
};

/// The light that arrives along the marched part of a ray. The source's irradiance outside of the atmosphere is 1.
struct MarchedLight {
  Bands molecules{}, aerosols{};  ///< Light scattered once, before multiplication by the phase functions.
  Bands aerosols_twice{};         ///< Light that aerosols scattered twice, before multiplication by aerosols_glow().
  Bands more{};                   ///< Light that was scattered more often, or by the ground.
  Bands passed = filled(1);       ///< Share of light from behind that passes.
};

/// A ray from a place above the sea. Frame: z up at the place, x towards the azimuth of the source.
struct AirRay {
  double height_m;            ///< 0 to kTop_m.
  Vec3 direction, to_source;  ///< Unit vectors; to_source.y is 0.
};

/// A place on a ray.
struct PlaceOnRay {
  double height_m, source_cosine;  ///< Height above sea level, and cosine of the source's zenith angle there.
  /// The ray's direction in the frame of the place: its z, and its x towards the azimuth of the source.
  double up, along;
};
/// Returns the place at a distance along a ray.
PlaceOnRay place_on(const AirRay& ray, double way_m);

/// The light that is scattered into a ray.
struct MarchedSources {
  bool has_direct = true;                 ///< True if direct light of the source is scattered.
  const ScatteredField* field = nullptr;  ///< Light that was scattered before, which is scattered again; null: none.
};

/// Adds the light of one step along a ray, with the air of the step's middle. Steps go from near to far.
void march(const LitAir& lit, const MarchedSources& sources, const AirRay& ray, double from_m, double to_m,
           MarchedLight& light);

/// Returns the light along a ray until it leaves the air or meets the sea, in `steps` steps that grow with the
/// distance.
MarchedLight march_out(const LitAir& lit, const MarchedSources& sources, const AirRay& ray, int steps);

/// Returns the direct light of the source at a place: the irradiance of a surface that faces the source.
Bands direct_light(const LitAir& lit, double height_m, double source_cosine);

/// Returns the phase function, per steradian, of light that aerosols scatter twice, without its spherical harmonics up
/// to degree 4, which a ScatteredField holds: the narrow glow about the source.
/// @param cosine  Cosine of the angle between the ray's direction and that to the source.
double aerosols_glow(double cosine);

}  // namespace citykiln::sky
