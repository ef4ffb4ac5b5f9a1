// The composition of air: molecules, aerosols and ozone, by height and wavelength, over a spherical Earth.
#pragma once

#include "compiler/sky/recipe.h"

namespace citykiln::sky {

/// Radius of the Earth, and the height above which there is no air.
inline constexpr double kEarth_m = 6371000, kTop_m = 100000;

/// Densities relative to sea level; ozone relative to the middle of its layer.
struct Densities {
  double molecules, aerosols, ozone;
};

/// Extinction and scattering of one wavelength where the density is 1, per metre.
struct Coefficients {
  double molecules;           ///< Scattering; molecules absorb nothing.
  double aerosols, absorbed;  ///< Extinction by aerosols, and the part of it that is absorption.
  double ozone;               ///< Absorption; ozone scatters nothing.
};

/// The air of a sky. Densities fall exponentially with height, except ozone, which is a layer from 10 to 40 km.
struct Air {
  /// Extinction at sea level: 3.912 / visibility (Koschmieder) less the extinction of molecules.
  double aerosols_550_per_m;
  double aerosols_height_m;  ///< Scale height of aerosols, with which the column has the sky's turbidity.
  double ground_albedo;
};

/// Returns the air for a sky's visibility and turbidity. The scale height is clamped to 0.5 to 8 km, and then the
/// turbidity differs from the sky's.
Air air_of(const Sky& sky);

/// Returns the densities at a height.
/// @param height_m  Above sea level. Air below sea level is as at sea level.
Densities densities_at(const Air& air, double height_m);
/// Returns the coefficients at a wavelength.
Coefficients coefficients_at(const Air& air, double nm);

/// The asymmetry parameter of aerosols: the mean cosine of the angle by which they deflect light.
inline constexpr double kAsymmetry = 0.76;
/// Returns the phase function of molecules (Rayleigh) at the cosine of the angle of deflection: scattering per
/// steradian, with an integral of 1 over the sphere.
double molecules_phase(double cosine);
/// Returns the phase function of aerosols (Henyey and Greenstein), in the same terms.
double aerosols_phase(double cosine);

}  // namespace citykiln::sky
