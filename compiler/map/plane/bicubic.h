// A smooth surface through samples on a square grid: bicubic Hermite patches with limited slopes.
//
// The surface is C1: it has no steps and no creases. Patches that share an edge have the same
// heights and slopes along it, since these depend only on the samples at its ends and their slopes.
// A patch depends on the 4 x 4 samples about it.
//
// Slopes are central differences, limited to kMostSlope times the smaller of the two differences
// beside the sample. The limit keeps lakes level: a patch between four samples of one height is
// level, whatever lies beside it. Water below a cliff would dip beside the cliff without the limit.
// The surface is exact for planes, and for products of a linear function of x and one of y.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace citykiln::map {

/// The largest slope at a sample, as a multiple of the smaller difference to its neighbours. A line
/// between rising samples rises everywhere for multiples up to 3 (Fritsch and Carlson 1980). Errors
/// at samples left out are 2 to 4 % smaller without a limit, but the surface then leaves the range
/// of the samples about it by up to six times as much (citykiln-chart smooth).
inline constexpr int kMostSlope = 2;

/// A bound of how far the surface leaves the range of the four samples about a place, as a share of
/// the range (highest less lowest). It is the sum of 0.22 on the lines between samples and 3/4
/// across them, for slopes of up to 2 and twists of up to 4 times the range, rounded up.
inline constexpr double kMostOvershoot = 1;

/// A sample: its height z, its slopes east and north, and the twist, the change of the slope east
/// by one step north. Slopes are in units of z for each step of the grid.
template <typename Real>
struct SmoothSample {
  Real z, east, north, twist;
};

/// Returns the mean of the differences before and after a sample, limited in size to kMostSlope
/// times the smaller one.
template <typename Real>
Real limited_slope(Real before, Real after) {
  const Real most = kMostSlope * std::min(std::abs(before), std::abs(after));
  return std::clamp<Real>((before + after) / 2, -most, most);
}

/// Returns the sample in the middle of 3 x 3 heights with its slopes. It is exact for heights that
/// are whole numbers.
/// @param at  at(column, row), both -1 to 1, columns eastwards, rows northwards: a height.
template <typename Real, typename At>
SmoothSample<Real> smooth_sample(const At& at) {
  const auto twist = [&](int c, int r) {
    return at(c + 1, r + 1) - at(c, r + 1) - at(c + 1, r) + at(c, r);  // of the square north-east of (c, r)
  };
  const Real z = at(0, 0), sw = twist(-1, -1), se = twist(0, -1), nw = twist(-1, 0), ne = twist(0, 0);
  const Real most = kMostSlope * std::min({std::abs(sw), std::abs(se), std::abs(nw), std::abs(ne)});
  return {z, limited_slope<Real>(z - at(-1, 0), at(1, 0) - z), limited_slope<Real>(z - at(0, -1), at(0, 1) - z),
          std::clamp<Real>((sw + se + nw + ne) / 4, -most, most)};
}

/// The weights of two heights, and of the slopes there, at a place between them.
template <typename Real>
struct HermiteWeights {
  Real first, second, first_slope, second_slope;
};

/// Returns the weights at a share of the way from the first height to the second, 0 to 1.
template <typename Real>
HermiteWeights<Real> hermite_weights(Real share) {
  const Real rest = 1 - share, second = share * share * (3 - 2 * share);
  return {1 - second, second, share * rest * rest, -share * share * rest};
}

/// Returns the height at a place of the patch between four samples.
/// @param corners  South-west, south-east, north-west, north-east.
/// @param u, v     The hermite_weights() of the place's shares east and north.
template <typename Real>
Real patch_height(const std::array<SmoothSample<Real>, 4>& corners, const HermiteWeights<Real>& u,
                  const HermiteWeights<Real>& v) {
  const auto& [sw, se, nw, ne] = corners;
  const auto along = [&u](Real a, Real b, Real slope_a, Real slope_b) {
    return a * u.first + b * u.second + slope_a * u.first_slope + slope_b * u.second_slope;
  };
  return along(sw.z, se.z, sw.east, se.east) * v.first + along(nw.z, ne.z, nw.east, ne.east) * v.second +
         along(sw.north, se.north, sw.twist, se.twist) * v.first_slope +
         along(nw.north, ne.north, nw.twist, ne.twist) * v.second_slope;
}

/// Returns the height of the surface at a place between four samples, the south-western of which is
/// at(0, 0).
/// @param at    at(column, row), both -1 to 2, columns eastwards, rows northwards: a height.
/// @param u, v  The place's shares of a step east and north, 0 to 1.
template <typename Real, typename At>
Real smooth_height(const At& at, Real u, Real v) {
  const auto sample = [&](int column, int row) {
    return smooth_sample<Real>([&](int c, int r) { return at(column + c, row + r); });
  };
  return patch_height<Real>({sample(0, 0), sample(1, 0), sample(0, 1), sample(1, 1)}, hermite_weights<Real>(u),
                            hermite_weights<Real>(v));
}

}  // namespace citykiln::map
