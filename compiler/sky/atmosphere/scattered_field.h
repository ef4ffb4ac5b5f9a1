// The light in the air that was scattered at least once, by height and by the zenith angle of its source.
#pragma once

#include <vector>

#include "compiler/sky/atmosphere/bands.h"

namespace citykiln::sky {

struct LitAir;

/// Moments of radiance over all directions, in the frame with z up and x towards the source's azimuth. They are
/// integrals of radiance times real spherical harmonics up to degree 4. Harmonics that are odd in y are left out, since
/// their moments are 0.
inline constexpr int kMoments = 15;
using Moments = std::array<Bands, kMoments>;

/// The values of the harmonics in a unit direction (x, y, z), degree by degree as in kMomentDegrees. Within degree l
/// they go from order m = 0 to l: the associated Legendre function of z times cos(m azimuth), divided by a constant
/// that makes the polynomial short: 1; z, x; ...
using MomentBasis = std::array<double, kMoments>;
MomentBasis moment_basis(double z, double x);
inline constexpr std::array<int, kMoments> kMomentDegrees = {0, 1, 1, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 4};
/// Factors of the addition theorem. If one of two directions has y = 0, the Legendre polynomial of degree l of the
/// cosine between them is the sum, over the entries of degree l, of the product of both bases times these. They are
/// (l - m)! / (l + m)!, twice that for m > 0, times the square of the basis's constant.
inline constexpr std::array<double, kMoments> kAdditionFactors = {1,    1,     1, 1,     3,      0.75,  1,       0.375,
                                                                  3.75, 0.625, 1, 0.625, 0.3125, 4.375, 0.546875};

/// The scattered light about a place.
///
/// Method: successive orders of scattering. At nodes in height and zenith angle radiance is gathered from all
/// directions, by rays through the field of the previous order, and kept as spherical harmonics. They represent all
/// light that molecules scatter (Rayleigh's phase function has degree 2), and the light of aerosols except the narrow
/// glow about the source after two or more scatterings.
class ScatteredField {
 public:
  /// Computes the field. Cost: 0.1 s.
  /// @param source_angle_rad  Zenith angle of the source at the middle of the field, which reaches 12 degrees to both
  ///                          sides of it, and from the ground to 75 km. Light is relative to an irradiance of 1
  ///                          outside the air, in each band.
  ScatteredField(const LitAir& lit, double source_angle_rad);

  /// Returns the moments at a place; outside of the nodes, the moments of the nearest node.
  Moments at(double height_m, double source_cosine) const;
  /// Returns the irradiance of level ground at sea level, without the source's direct light.
  Bands ground_irradiance(double source_cosine) const;

 private:
  void sweep(const LitAir& lit, std::vector<Bands>& once);
  double angle_rad(int column) const;
  int column_of(double source_cosine, float& share) const;

  int angles_;
  double step_rad_, first_rad_;
  std::vector<Moments> cells_;  // rows of heights
  std::vector<Bands> ground_;   // by zenith angle
};

}  // namespace citykiln::sky
