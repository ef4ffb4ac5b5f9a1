#include "compiler/map/resample.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <optional>
#include <string>

#include "compiler/geometry/snap.h"
#include "compiler/map/features.h"
#include "compiler/map/lonlat_box.h"
#include "compiler/map/precise_plane.h"
#include "compiler/source/fill_gaps.h"
#include "compiler/source/read_raster.h"

namespace citykiln::map {
namespace {

using source::Raster;

// Steps under 1 m resolve only noise; steps above a cell would leave a cell without vertices.
constexpr double kFinestStep_m = 1, kCoarsestStep_m = kCell_m;
// Share of a grain. Positions are off by at most 1.6e-9 m (measured against long double), so on a slope of 100 to 1 a
// height is off by a hundred thousandth of a quantum.
constexpr double kNearTie = 1e-5;

// Values beyond this are no heights: they would overflow differences of 32-bit quanta.
constexpr double kMostHeight_m = 0x1p20;

template <typename Real>
bool is_height(Real height_m) {
  return std::abs(height_m) <= kMostHeight_m;
}

// The largest step not above a spacing.
double step_below(double spacing_m) {
  return std::floor(std::clamp(spacing_m, kFinestStep_m, kCoarsestStep_m) / kStepUnit_m) * kStepUnit_m;
}

Vec2 step_for(std::span<const Raster> rasters) {
  Vec2 finest_m{kCoarsestStep_m, kCoarsestStep_m};
  for (const Raster& raster : rasters)
    finest_m = {std::min(finest_m.x, raster.spacing_m.x), std::min(finest_m.y, raster.spacing_m.y)};
  return {step_below(finest_m.x), step_below(finest_m.y)};
}

// A field over the region and one step beyond on every side. @param anchor  A vertex of the grid, possibly far away.
Heightfield empty_field(const Box2& region, Vec2 step_m, Vec2 anchor) {
  const auto before = [](double v, double step) { return std::floor(v / step) - 1; };
  const auto beyond = [](double v, double step) { return std::ceil(v / step) + 1; };
  const Vec2 low = region.min - anchor, high = region.max - anchor;
  const double west = before(low.x, step_m.x), south = before(low.y, step_m.y);
  Heightfield field{.min = anchor + Vec2{west * step_m.x, south * step_m.y}, .step_m = step_m, .heights = {}};
  field.columns = static_cast<int>(beyond(high.x, step_m.x) - west) + 1;
  field.rows = static_cast<int>(beyond(high.y, step_m.y) - south) + 1;
  return field;
}

// Bilinear heights of a raster at places.
struct Sampler {
  const Raster& raster;
  source::ToRasterSystem to_system;  // empty: longitude and latitude
  double determinant;

  explicit Sampler(const Raster& r, source::ToRasterSystem t)
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
    // half a sample around the outermost belongs to them
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

// A sample near the region's middle, to kStepUnit_m. Vertices lie on samples there, and nearly so for kilometres
// around: vertices between samples would cut off summits.
Vec2 anchor_of(std::span<const Sampler> samplers, const Plane& plane, const Box2& region) {
  const LonLat place = plane.backward(region.centre());
  const auto covers = [&](const Sampler& s) { return s.height_m<double>(place.lon_deg, place.lat_deg).has_value(); };
  const auto first = std::ranges::find_if(samplers, covers);
  if (first == samplers.end()) return {};
  const auto [column, row] = first->in_grid<double>(place.lon_deg, place.lat_deg);
  const auto to_next = [](double v) { return std::floor(v + 0.5) - v; };
  const Vec2 spacing_m = first->raster.spacing_m;
  // rows count southwards
  return snapped_to(kStepUnit_m, region.centre() + Vec2{to_next(column) * spacing_m.x, -to_next(row) * spacing_m.y});
}

template <typename Real>
std::optional<Real> first_height_m(std::span<const Sampler> samplers, Real lon_deg, Real lat_deg) {
  for (const Sampler& sampler : samplers)
    if (const auto height = sampler.height_m<Real>(lon_deg, lat_deg)) return height;
  return std::nullopt;
}

// The number of quanta of which heights are multiples: a 512th of the step, so that no slope is off by more than 0.2 %.
// Coarse fields have errors of metres anyway and take fewer bytes.
std::int32_t grain_for(double step_m) {
  return std::max(1, static_cast<std::int32_t>(step_m / 512 / kHeightQuantum_m));
}

// The height in quanta, or nothing outside all rasters. Near a tie it is computed again in long double.
std::optional<std::int32_t> quantised_height(std::span<const Sampler> samplers, const Plane& plane, Vec2 p,
                                             std::int32_t grain) {
  const double grain_m = grain * kHeightQuantum_m;
  const LonLat place = plane.backward(p);
  const auto height = first_height_m<double>(samplers, place.lon_deg, place.lat_deg);
  if (!height) return std::nullopt;
  const double grains = *height / grain_m + 0.5;
  if (std::abs(grains - std::round(grains)) > kNearTie) return static_cast<std::int32_t>(std::floor(grains)) * grain;
  const PreciseLonLat precise = precise_backward(plane.origin(), p, place);
  const auto exact = first_height_m<long double>(samplers, precise.lon_deg, precise.lat_deg);
  return static_cast<std::int32_t>(floorl(exact.value_or(*height) / grain_m + 0.5L)) * grain;
}

// The largest vertical distance from the raster's samples to the field.
double resampling_error_m(const Heightfield& field, const Raster& raster, const Plane& plane) {
  if (!raster.system_wkt.empty()) return 0;  // only samples in degrees can be placed exactly
  double largest = 0;
  const Box2 box = field.box();
  for (int r = 0; r < raster.rows; ++r)
    for (int c = 0; c < raster.columns; ++c) {
      const auto& g = raster.from_grid;
      const Vec2 p = plane.forward({g[0] + g[1] * c + g[2] * r, g[3] + g[4] * c + g[5] * r});
      if (box.contains(p) && is_height(raster.at(c, r)))
        largest = std::max(largest, std::abs(height_m_at(field, p) - raster.at(c, r)));
    }
  // rounded up to the next quantum: reported, not computed with
  return std::ceil(largest / kHeightQuantum_m) * kHeightQuantum_m;
}

std::string text_of(const source::LonLatBox& box) {
  return fmt::format("{:.4f},{:.4f},{:.4f},{:.4f}", box.west, box.south, box.east, box.north);
}

Error covers_nothing(std::span<const Raster> rasters, const Plane& plane, const Box2& region) {
  std::string boxes;
  for (const Raster& raster : rasters) boxes += (boxes.empty() ? "" : " and ") + text_of(raster.file_box);
  return {rasters.front().file_name,
          fmt::format("no heightmap covers any part of the map: heights lie in {}, the map lies in {} (W,S,E,N)", boxes,
                      text_of(lonlat_box_of(region, plane)))};
}

}  // namespace

Result<Heightfield> resample(std::span<const Raster> rasters, const Plane& plane, const Box2& region, Report& report) {
  assert(!region.is_empty());
  std::vector<Sampler> samplers;
  for (const Raster& raster : rasters) {
    auto to_system = source::to_system_of(raster);
    if (!to_system) return to_system.error();
    samplers.emplace_back(raster, *to_system);
  }
  Heightfield field = empty_field(region, step_for(rasters), anchor_of(samplers, plane, region));
  field.heights.assign(static_cast<std::size_t>(field.columns) * field.rows, 0);
  if (rasters.empty()) return field;
  std::vector<bool> known(field.heights.size(), false);
  const std::int32_t grain = grain_for(field.shorter_step_m());
  for (int j = 0; j < field.rows; ++j)
    for (int i = 0; i < field.columns; ++i) {
      const std::size_t at = static_cast<std::size_t>(j) * field.columns + i;
      const auto height = quantised_height(samplers, plane, field.vertex(i, j), grain);
      if (height) field.heights[at] = *height, known[at] = true;
    }
  if (std::find(known.begin(), known.end(), true) == known.end()) return covers_nothing(rasters, plane, region);
  const std::size_t missing = source::fill_uncovered(field.heights, known, field.columns);
  if (missing > 0) report.add(Code::kNoHeight, {}, static_cast<double>(missing) / static_cast<double>(known.size()));
  for (const Raster& raster : rasters)
    field.resampling_error_m = std::max(field.resampling_error_m, resampling_error_m(field, raster, plane));
  return field;
}

}  // namespace citykiln::map
