// Samples heights of rasters (heightmaps) at places.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/map/plane/plane.h"
#include "compiler/source/raster.h"
#include "compiler/source/read_raster.h"

namespace citykiln::map {

/// Values beyond this are no heights: they would overflow differences of 32-bit quanta.
inline constexpr double kMostHeight_m = 0x1p20;

/// True for values that can be heights.
template <typename Real>
bool is_height(Real height_m) {
  return std::abs(height_m) <= kMostHeight_m;
}

/// Interpolates the heights of a raster bilinearly. The raster must outlive it. A raster without samples has no
/// heights.
struct RasterSampler {
  const source::Raster& raster;
  source::ToRasterSystem to_system;  // empty: longitude and latitude
  double determinant;

  RasterSampler(const source::Raster& r, source::ToRasterSystem t)
      : raster(r),
        to_system(std::move(t)),
        determinant(r.from_grid[1] * r.from_grid[5] - r.from_grid[2] * r.from_grid[4]) {}

  template <typename Real>
  struct InGrid {
    Real column, row;
  };

  // Real is double, or long double near a tie.
  template <typename Real>
  InGrid<Real> in_grid(Real lon_deg, Real lat_deg) const {
    Real x = lon_deg, y = lat_deg;
    if (!raster.system_wkt.empty()) {
      double px = static_cast<double>(lon_deg), py = static_cast<double>(lat_deg);
      to_system(px, py);
      x = px, y = py;
    }
    const auto& g = raster.from_grid;
    const Real u = x - g[0], v = y - g[3];
    return {(u * g[5] - v * g[2]) / determinant, (v * g[1] - u * g[4]) / determinant};
  }

  // The height at a place, or nothing outside the samples.
  template <typename Real>
  std::optional<Real> height_m(Real lon_deg, Real lat_deg) const {
    const InGrid<Real> at = in_grid<Real>(lon_deg, lat_deg);
    return bilinear<Real>(at.column, at.row);
  }

  template <typename Real>
  std::optional<Real> bilinear(Real column, Real row) const {
    // the outermost samples extend outwards by half a sample
    if (!(column >= -0.5 && row >= -0.5 && column <= raster.columns - 0.5 && row <= raster.rows - 0.5))
      return std::nullopt;
    column = std::clamp<Real>(column, 0, raster.columns - 1), row = std::clamp<Real>(row, 0, raster.rows - 1);
    const int c = std::min(static_cast<int>(column), std::max(0, raster.columns - 2)),
              r = std::min(static_cast<int>(row), std::max(0, raster.rows - 2));
    const int east = std::min(c + 1, raster.columns - 1), south = std::min(r + 1, raster.rows - 1);
    const Real u = column - c, v = row - r;
    const Real north_m = raster.at(c, r) * (1 - u) + raster.at(east, r) * u,
               south_m = raster.at(c, south) * (1 - u) + raster.at(east, south) * u;
    const Real height = north_m * (1 - v) + south_m * v;
    if (!is_height(height)) return std::nullopt;
    return height;
  }
};

/// Returns one sampler for each raster. Error: a raster's reference system is unknown.
Result<std::vector<RasterSampler>> samplers_of(std::span<const source::Raster> rasters);

/// The height at a point of the plane by the first raster that covers it, in quanta of kHeightQuantum_m, rounded to a
/// multiple of `grain`; nothing outside all rasters. Every CPU gives the same result, as heights near a tie are
/// computed again in long double.
std::optional<std::int32_t> quantised_height(std::span<const RasterSampler> samplers, const Plane& plane, Vec2 p,
                                             std::int32_t grain);

}  // namespace citykiln::map
