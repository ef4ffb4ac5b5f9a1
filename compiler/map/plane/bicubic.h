// A smooth surface through samples on a grid: bicubic Hermite patches with limited slopes.
//
// The surface is C1: two patches that share an edge have the same heights and slopes along it, since both are decided
// by the samples' own slopes at its ends. A patch depends on the 4 x 4 samples about it.
//
// Slopes are central differences, limited to kMostSlope times the smaller of the two differences beside the sample.
// Without the limit a lake below a cliff would be lower beside the cliff than its own samples: a patch between samples
// of one height is level, whatever lies beside it. Planes are reproduced, as are products of a linear function east and
// one north.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace citykiln::map {

/// The largest slope at a sample, as a multiple of the smaller difference to its neighbours. At most 3, a line between
/// rising samples rises everywhere (Fritsch and Carlson 1980). Without a limit the errors at samples left out are 2 to
/// 4 % smaller, but lie up to six times as far outside of their neighbours (citykiln-chart smooth).
inline constexpr int kMostSlope = 2;

/// The surface leaves the range of the four samples about a place by at most this share of the range: 0.22 on the lines
/// between samples, and 3/4 for slopes across them of up to 2, with twists of up to 4.
inline constexpr double kMostOvershoot = 1;

/// A sample with its slopes, in metres a step: east, north, and the change of the slope east by a step north.
template <typename Real>
struct SmoothSample {
  Real z, east, north, twist;
};

/// Returns the mean of two differences, limited to kMostSlope times the smaller one.
template <typename Real>
Real limited_slope(Real before, Real after) {
  const Real most = kMostSlope * std::min(std::abs(before), std::abs(after));
  return std::clamp<Real>((before + after) / 2, -most, most);
}

/// Returns the sample in the middle of 3 x 3 heights with its slopes. Exact for heights that are whole numbers.
/// @param at  at(column, row), both -1 to 1, rows northwards: a height.
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

/// The weights of two heights and their slopes at a share of the way from the first to the second.
template <typename Real>
struct HermiteWeights {
  Real first, second, first_slope, second_slope;
};

template <typename Real>
HermiteWeights<Real> hermite_weights(Real share) {
  const Real rest = 1 - share, second = share * share * (3 - 2 * share);
  return {1 - second, second, share * rest * rest, -share * share * rest};
}

/// Returns the height of the patch between four samples.
/// @param corners  South-west, south-east, north-west, north-east.
/// @param u, v     Weights at the shares east and north.
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

/// Returns the height between four samples of which at(0, 0) is the south-western one.
/// @param at    at(column, row), both -1 to 2, rows northwards: a height.
/// @param u, v  Shares east and north, 0 to 1.
template <typename Real, typename At>
Real smooth_height(const At& at, Real u, Real v) {
  const auto sample = [&](int column, int row) {
    return smooth_sample<Real>([&](int c, int r) { return at(column + c, row + r); });
  };
  return patch_height<Real>({sample(0, 0), sample(1, 0), sample(0, 1), sample(1, 1)}, hermite_weights<Real>(u),
                            hermite_weights<Real>(v));
}

}  // namespace citykiln::map
