#include "compiler/source/gdal_module/raster_window.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "compiler/source/gdal_module/raster_system.h"

namespace citykiln::source::gdal {
namespace {

// samples for interpolation and resampling, for spikes and blocks of broken samples (kSpikeInfluence, kBlockInfluence),
// and for voids that reach beyond the box
constexpr int kMargin = 24;
// points along each edge of the box: between two of them its image bends by less than the margin
constexpr int kSteps = 32;

struct Bounds {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// The first index and the count, limited to 0 … size - 1.
std::pair<int, int> clamp(Bounds bounds, int size) {
  const double first = std::max(0.0, std::floor(bounds.low) - kMargin);
  const double last = std::min(size - 1.0, std::ceil(bounds.high) + kMargin);
  if (!(first <= last)) return {0, 0};
  return {static_cast<int>(first), static_cast<int>(last - first) + 1};
}

}  // namespace

Result<PixelWindow> window_of(const Raster& raster, const LonLatBox& box) {
  assert(raster.columns > 0 && raster.rows > 0);
  assert(box.west <= box.east && box.south <= box.north);
  const Result<ToRasterSystem> to_system = from_wgs84(raster);
  if (!to_system) return to_system.error();
  const std::array<double, 6>& a = raster.from_grid;
  const double determinant = a[1] * a[5] - a[2] * a[4];
  if (determinant == 0 || !std::isfinite(determinant)) return Error{raster.file_name, "its grid has no extent"};

  Bounds columns, rows;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      double x = box.west + (box.east - box.west) * i / kSteps;
      double y = box.south + (box.north - box.south) * j / kSteps;
      (*to_system)(x, y);
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      columns.take((a[5] * (x - a[0]) - a[2] * (y - a[3])) / determinant);
      rows.take((a[1] * (y - a[3]) - a[4] * (x - a[0])) / determinant);
    }
  }
  const auto [column, column_count] = clamp(columns, raster.columns);
  const auto [row, row_count] = clamp(rows, raster.rows);
  if (column_count == 0 || row_count == 0) return PixelWindow{};
  return PixelWindow{column, row, column_count, row_count};
}

PixelWindow thinned(PixelWindow window, Vec2 samples_m, double spacing_m) {
  const double longer_m = std::max(samples_m.x, samples_m.y);
  if (!(longer_m > 0) || window.columns == 0) return window;
  // a raster of a single sample has no spacing to speak of
  const int most = std::max(1, std::max(window.columns, window.rows));
  window.stride = std::clamp(static_cast<int>(std::min(spacing_m / longer_m, 1e6)), 1, most);
  window.columns = (window.columns - 1) / window.stride + 1, window.rows = (window.rows - 1) / window.stride + 1;
  return window;
}

}  // namespace citykiln::source::gdal
