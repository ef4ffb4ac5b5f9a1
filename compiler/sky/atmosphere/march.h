// Light that air scatters into a ray, step by step.
#pragma once

#include "compiler/geometry/vec.h"
#include "compiler/sky/atmosphere/columns.h"
#include "compiler/sky/atmosphere/scattered_field.h"

namespace citykiln::sky {

/// A source of light, parallel from its direction, and the air that it shines on.
struct LitAir {
  Air air;
  BandCoefficients coefficients;
  ColumnTable columns;
  explicit LitAir(const Air& given) : air(given), coefficients(band_coefficients(given)), columns(given) {}
};

/// Light that comes along a ray from the way that was marched. Sunlight has irradiance 1 outside of the atmosphere.
struct MarchedLight {
  Bands molecules{}, aerosols{};  ///< Scattered once, by phase functions of 1.
  Bands aerosols_twice{};         ///< Scattered by aerosols twice, by a phase function of 1 (aerosols_glow()).
  Bands more{};                   ///< Scattered more often, or by the ground before.
  Bands passed = filled(1);       ///< Share of light from behind that passes.
};

/// A ray from a place above the sea. Frame: z up at the place, x towards the azimuth of the source.
struct AirRay {
  double height_m;  ///< 0 to kTop_m.
  Vec3 direction, to_source;
};

/// Where a ray is after some way.
struct PlaceOnRay {
  double height_m, source_cosine;  ///< Of the source's zenith angle there.
  double up, along;                ///< Of the ray's direction there: its z and x.
};
PlaceOnRay place_on(const AirRay& ray, double way_m);

/// Which light is scattered into a ray.
struct MarchedSources {
  bool has_direct = true;                 ///< That of the source.
  const ScatteredField* field = nullptr;  ///< Light that was scattered before; null: none.
};

/// Marches from one distance to another in one step of even air, and adds to the light.
void march(const LitAir& lit, const MarchedSources& sources, const AirRay& ray, double from_m, double to_m,
           MarchedLight& light);

/// Marches until the ray leaves the air or meets the sea, in steps that grow with the distance.
MarchedLight march_out(const LitAir& lit, const MarchedSources& sources, const AirRay& ray, int steps);

/// The direct light of the source at a place: irradiance of a surface that faces it.
Bands direct_light(const LitAir& lit, double height_m, double source_cosine);

/// The part of light scattered twice by aerosols that a ScatteredField does not hold: the narrow glow about the source,
/// of degrees above 4. Per steradian.
double aerosols_glow(double cosine);

}  // namespace citykiln::sky
