#include "compiler/map/heights/resample.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <string>

#include "compiler/geometry/snap.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/lonlat_box.h"
#include "compiler/map/plane/raster_sampler.h"
#include "compiler/map/plane/smooth_land.h"
#include "compiler/source/voids/fill_gaps.h"

namespace citykiln::map {
namespace {

using source::Raster;

// Steps under 1 m resolve only noise; steps above a cell would leave a cell without vertices.
constexpr double kFinestStep_m = 1, kCoarsestStep_m = kCell_m;

// The largest step not above a spacing.
double step_below(double spacing_m) {
  return std::floor(std::clamp(spacing_m, kFinestStep_m, kCoarsestStep_m) / kStepUnit_m) * kStepUnit_m;
}

Vec2 step_for(std::span<const Raster> rasters) {
  Vec2 finest_m{kCoarsestStep_m, kCoarsestStep_m};
  for (const Raster& raster : rasters) {
    // a heightmap outside of the window has no spacing
    if (raster.heights_m.empty()) continue;
    finest_m = {std::min(finest_m.x, raster.spacing_m.x), std::min(finest_m.y, raster.spacing_m.y)};
  }
  return {step_below(finest_m.x), step_below(finest_m.y)};
}

// A level field over the extent and some steps beyond on every side. @param anchor A vertex of the grid, possibly far
// away.
Heightfield level_field(const Box2& extent, Vec2 step_m, Vec2 anchor, int steps_beyond) {
  const auto before = [&](double v, double step) { return std::floor(v / step) - steps_beyond; };
  const auto beyond = [&](double v, double step) { return std::ceil(v / step) + steps_beyond; };
  const Vec2 low = extent.min - anchor, high = extent.max - anchor;
  const double west = before(low.x, step_m.x), south = before(low.y, step_m.y);
  Heightfield field{.min = anchor + Vec2{west * step_m.x, south * step_m.y}, .step_m = step_m, .heights = {}};
  field.columns = static_cast<int>(beyond(high.x, step_m.x) - west) + 1;
  field.rows = static_cast<int>(beyond(high.y, step_m.y) - south) + 1;
  field.heights.assign(static_cast<std::size_t>(field.columns) * field.rows, 0);
  return field;
}

// A sample near the extent's middle, to kStepUnit_m. Vertices lie on samples there, and nearly so for kilometres
// around: vertices between samples would cut off summits.
Vec2 anchor_of(std::span<const RasterSampler> samplers, const Plane& plane, const Box2& extent) {
  const LonLat place = plane.backward(extent.centre());
  const auto covers = [&](const RasterSampler& s) {
    return s.height_m<double>(place.lon_deg, place.lat_deg).has_value();
  };
  const auto first = std::ranges::find_if(samplers, covers);
  if (first == samplers.end()) return {};
  const auto [column, row] = first->in_grid<double>(place.lon_deg, place.lat_deg);
  const auto to_next = [](double v) { return std::floor(v + 0.5) - v; };
  const Vec2 spacing_m = first->raster.spacing_m;
  // rows count southwards
  return snapped_to(kStepUnit_m, extent.centre() + Vec2{to_next(column) * spacing_m.x, -to_next(row) * spacing_m.y});
}

// The number of quanta of which heights are multiples: a 512th of the step, so that no slope is off by more than 0.2 %.
// Coarse fields have errors of metres anyway and take fewer bytes.
std::int32_t grain_for(double step_m) {
  return std::max(1, static_cast<std::int32_t>(step_m / 512 / kHeightQuantum_m));
}

// Writes the heights of a field's vertices; returns which of them a raster covers.
std::vector<bool> sample(std::span<const RasterSampler> samplers, const Plane& plane, Heightfield& field) {
  std::vector<bool> known(field.heights.size(), false);
  const std::int32_t grain = grain_for(field.shorter_sample_step_m());
  for (int j = 0; j < field.rows; ++j)
    for (int i = 0; i < field.columns; ++i) {
      const std::size_t at = static_cast<std::size_t>(j) * field.columns + i;
      const auto height = quantised_height(samplers, plane, field.vertex(i, j), grain);
      if (height) field.heights[at] = *height, known[at] = true;
    }
  return known;
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

Error covers_nothing(std::span<const Raster> rasters, const Plane& plane, const Box2& extent) {
  std::string boxes;
  for (const Raster& raster : rasters) boxes += (boxes.empty() ? "" : " and ") + text_of(raster.file_box);
  return {rasters.front().file_name,
          fmt::format("no heightmap covers any part of the map: heights lie in {}, the map lies in {} (W,S,E,N)", boxes,
                      text_of(lonlat_box_of(extent, plane)))};
}

}  // namespace

Result<Heightfield> resample(std::span<const Raster> rasters, const Plane& plane, const Box2& extent, Report& report) {
  assert(!extent.is_empty());
  const Result<std::vector<RasterSampler>> samplers = samplers_of(rasters);
  if (!samplers) return samplers.error();
  const Vec2 step_m = step_for(rasters), anchor = anchor_of(*samplers, plane, extent);
  if (rasters.empty()) return level_field(extent, step_m, anchor, 1);
  const int parts = smooth_parts(step_m);
  // the smooth surface ends one sample before the outermost
  Heightfield samples = level_field(extent, step_m, anchor, parts == 1 ? 1 : 2);
  const std::vector<bool> known = sample(*samplers, plane, samples);
  if (std::find(known.begin(), known.end(), true) == known.end()) return covers_nothing(rasters, plane, extent);
  const std::size_t missing = source::fill_uncovered(samples.heights, known, samples.columns);
  if (missing > 0) report.add(Code::kNoHeight, {}, static_cast<double>(missing) / static_cast<double>(known.size()));
  Heightfield field = smooth_land(std::move(samples), parts);
  for (const Raster& raster : rasters)
    field.resampling_error_m = std::max(field.resampling_error_m, resampling_error_m(field, raster, plane));
  return field;
}

}  // namespace citykiln::map
