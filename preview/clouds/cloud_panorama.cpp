#include "preview/clouds/cloud_panorama.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace citykiln::preview {
namespace {

// Directions along a side of a tile. One more row and column belong to the neighbours.
constexpr int kTile = 16;
constexpr double kFinestPanorama_rad = 0.0002;

CloudPath weighted(const CloudPath& path) { return {path.passed, path.added, path.distance_m * (1 - path.passed)}; }

CloudPath mixed_paths(const CloudPath& a, const CloudPath& b, double share) {
  return {std::lerp(a.passed, b.passed, share), a.added * (1 - share) + b.added * share,
          std::lerp(a.distance_m, b.distance_m, share)};
}

}  // namespace

CloudPanorama::CloudPanorama(const CloudField& field, Vec3 eye, double pixel_rad)
    : field_(field), eye_(eye), base_m_(field.lowest_m()) {
  if (field.is_empty() || eye.z >= base_m_) return;
  constexpr double kQuarter = std::numbers::pi / 2;
  const int bands = static_cast<int>(std::ceil(kQuarter / (kTile * std::max(pixel_rad, kFinestPanorama_rad))));
  row_rad_ = kQuarter / (bands * kTile);
  std::size_t tiles = 0;
  for (int band = 0; band < bands; ++band) {
    // as wide as high at the lower edge
    const double around = 4 * kQuarter * std::cos(band * kTile * row_rad_);
    bands_.push_back({tiles, std::max(3, static_cast<int>(std::ceil(around / (kTile * row_rad_))))});
    tiles += static_cast<std::size_t>(bands_.back().tiles);
  }
  tiles_ = std::make_unique<Tile[]>(tiles);
}

const std::vector<CloudPath>& CloudPanorama::paths_of(const Band& band, int row, int column) const {
  Tile& tile = tiles_[band.first + static_cast<std::size_t>(column)];
  std::call_once(tile.is_made, [&] {
    const double step_rad = 2 * std::numbers::pi / (band.tiles * kTile);
    for (int y = 0; y <= kTile; ++y)
      for (int x = 0; x <= kTile; ++x) {
        const double up = (row * kTile + y) * row_rad_, turn = (column * kTile + x) * step_rad;
        const Vec3 along{std::cos(up) * std::cos(turn), std::cos(up) * std::sin(turn), std::sin(up)};
        tile.paths.push_back(weighted(field_.along(eye_, along, std::numeric_limits<double>::infinity())));
      }
  });
  return tile.paths;
}

std::optional<CloudPath> CloudPanorama::along(Vec3 from, Vec3 direction) const {
  if (bands_.empty() || from.z >= base_m_ || direction.z <= 1e-4) return std::nullopt;
  const Vec3 seen = unit(from + direction * ((base_m_ - from.z) / direction.z) - eye_);
  const double up = std::asin(std::clamp(seen.z, 0.0, 1.0)) / (row_rad_ * kTile);
  const int row = std::min(static_cast<int>(up), static_cast<int>(bands_.size()) - 1);
  const Band& band = bands_[static_cast<std::size_t>(row)];
  const double turn = std::atan2(seen.y, seen.x) / (2 * std::numbers::pi);
  const double around = (turn < 0 ? turn + 1 : turn) * band.tiles;
  const int column = std::min(static_cast<int>(around), band.tiles - 1);
  const std::vector<CloudPath>& paths = paths_of(band, row, column);
  const double x = std::min((around - column) * kTile, kTile - 1e-9), y = std::min((up - row) * kTile, kTile - 1e-9);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const CloudPath* first = &paths[static_cast<std::size_t>(y0 * (kTile + 1) + x0)];
  CloudPath path = mixed_paths(mixed_paths(first[0], first[1], x - x0),
                               mixed_paths(first[kTile + 1], first[kTile + 2], x - x0), y - y0);
  if (path.passed < 1) path.distance_m /= 1 - path.passed;
  return path;
}

}  // namespace citykiln::preview
