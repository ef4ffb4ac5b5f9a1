#include "preview/light/star_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/sky/generate.h"
#include "preview/light/direction_table.h"

namespace citykiln::preview {
namespace {

constexpr int kStarColumns = 128, kStarRows = 64;
// The eye resolves a minute of arc. Larger pixels than the largest show stars that are smaller than them.
constexpr double kSmallest_rad = 0.0003, kLargest_rad = 0.005;

int column_of(double turn) { return std::clamp(static_cast<int>(turn * kStarColumns), 0, kStarColumns - 1); }
int row_of(double z) { return std::clamp(static_cast<int>(z * kStarRows), 0, kStarRows - 1); }

}  // namespace

StarMap::StarMap(std::vector<sky::Star> stars)
    : stars_(std::move(stars)), cells_(stars_.empty() ? 0 : static_cast<std::size_t>(kStarColumns) * kStarRows) {
  for (int i = 0; i < static_cast<int>(stars_.size()); ++i) {
    const Vec3 d = stars_[i].direction;
    const double level = std::sqrt(d.x * d.x + d.y * d.y);
    // near the zenith a disk touches all azimuths
    const double half = level > 8 * kLargest_rad ? kLargest_rad / level / (2 * std::numbers::pi) : 0.5;
    const int first = static_cast<int>(std::floor((turn_of(d) - half) * kStarColumns));
    const int last =
        std::min(static_cast<int>(std::floor((turn_of(d) + half) * kStarColumns)), first + kStarColumns - 1);
    for (int row = row_of(d.z - kLargest_rad); row <= row_of(d.z + kLargest_rad); ++row)
      for (int column = first; column <= last; ++column)
        cells_[static_cast<std::size_t>(row) * kStarColumns + (column + kStarColumns) % kStarColumns].push_back(i);
  }
}

Rgb StarMap::radiance(Vec3 direction, double pixel_rad) const {
  Rgb sum{};
  if (stars_.empty() || direction.z < 0) return sum;
  const double radius = std::clamp(pixel_rad, kSmallest_rad, kLargest_rad);
  // a cone: 1 at the middle, 0 at the radius; its sum is a third of the disk's
  const double unit_lx = sky::kUnitLuminance_cd_m2 * std::numbers::pi * radius * radius / 3;
  for (const int i :
       cells_[static_cast<std::size_t>(row_of(direction.z)) * kStarColumns + column_of(turn_of(direction))]) {
    const double away = length(direction - stars_[i].direction) / radius;
    if (away < 1) sum = sum + stars_[i].illuminance * ((1 - away) / unit_lx);
  }
  return sum;
}

}  // namespace citykiln::preview
