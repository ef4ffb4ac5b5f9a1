#include "compiler/surroundings/plan.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include "compiler/map/plane/heightfield.h"
#include "compiler/map/plane/raster_sampler.h"
#include "compiler/surroundings/curvature.h"
#include "compiler/surroundings/grid_lines.h"
#include "compiler/surroundings/recipe.h"

namespace citykiln::surroundings {
namespace {

// ---- heights that no heightmap covers -------------------------------------------------------------------------------

// At this distance from a known vertex, half of its difference from the mean height is left.
constexpr double kFillFade_m = 2000;

double mean_m(const std::vector<bool>& known, const Surroundings& around) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known[i]) sum += around.heights_m[i], ++count;
  return sum / count;
}

// A height between the nearest known one and the mean.
std::int32_t faded(std::int32_t height_m, double mean_m, double away_m) {
  const double share = kFillFade_m / (kFillFade_m + away_m);
  return static_cast<std::int32_t>(std::floor(mean_m + (height_m - mean_m) * share + 0.5));
}

// The known one of a list of lines that is nearest to another; of two the first.
template <typename IsKnown>
std::optional<std::size_t> nearest(const std::vector<std::int32_t>& lines, std::size_t to, IsKnown is_known) {
  std::optional<std::size_t> best;
  const auto away = [&](std::size_t line) { return std::abs(lines[line] - lines[to]); };
  for (std::size_t line = 0; line < lines.size(); ++line)
    if (is_known(line) && (!best || away(line) < away(*best))) best = line;
  return best;
}

// Gives each unknown vertex the height of the nearest known vertex of its row, or of the nearest row that has one,
// faded into the mean of all known heights, and its cover if no coastline decides. O(n · columns).
// @param known  One value for each vertex; at least one is true.
void fill_unknown(const MappedWater& water, const std::vector<bool>& known, Surroundings& around) {
  assert(known.size() == around.heights_m.size() && std::ranges::find(known, true) != known.end());
  const double mean = mean_m(known, around);
  std::vector<bool> has_known(around.rows(), false);
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known[i]) has_known[i / around.columns()] = true;
  for (std::size_t row = 0; row < around.rows(); ++row) {
    // heights of a known row are not changed, so that the rows of `from` are those that were sampled
    const std::size_t from = *nearest(around.y_m, row, [&](std::size_t r) { return bool{has_known[r]}; });
    const double aside_m = std::abs(around.y_m[from] - around.y_m[row]);
    for (std::size_t column = 0; column < around.columns(); ++column) {
      if (known[around.index(column, row)]) continue;
      const std::size_t at =
          *nearest(around.x_m, column, [&](std::size_t c) { return bool{known[around.index(c, from)]}; });
      const double away_m = aside_m + std::abs(around.x_m[at] - around.x_m[column]);
      const std::size_t known_at = around.index(at, from), here = around.index(column, row);
      around.covers[here] = cover_by_coast(water, around.vertex(column, row)).value_or(around.covers[known_at]);
      around.heights_m[here] = around.covers[here] == Cover::kSea    ? 0
                               : around.covers[here] == Cover::kLake ? around.heights_m[known_at]
                                                                     : faded(around.heights_m[known_at], mean, away_m);
    }
  }
}

using map::RasterSampler;

constexpr auto kQuantaPerMetre = static_cast<std::int32_t>(1 / map::kHeightQuantum_m);

// The distance from a line to its nearest neighbour.
std::int32_t step_m(const std::vector<std::int32_t>& lines, std::size_t line) {
  const std::int32_t before = line > 0 ? lines[line] - lines[line - 1] : lines[1] - lines[0];
  return line + 1 < lines.size() ? std::min(before, lines[line + 1] - lines[line]) : before;
}

// Heights beside wide cells are multiples of more metres: a 256th of the cell's longer side.
std::int32_t grain_m(const Surroundings& around, std::size_t column, std::size_t row) {
  const auto longer_m = static_cast<std::uint32_t>(std::max(step_m(around.x_m, column), step_m(around.y_m, row)));
  return static_cast<std::int32_t>(std::bit_floor(std::max(1u, longer_m / 256)));
}

// Samples the heightmaps; returns which heights are known.
std::vector<bool> sample(std::span<const RasterSampler> samplers, const map::Plane& plane, bool has_sea,
                         Surroundings& around) {
  std::vector<bool> known;
  for (std::size_t row = 0; row < around.rows(); ++row)
    for (std::size_t column = 0; column < around.columns(); ++column) {
      // 4 m are land and not sea
      const std::int32_t grain = kQuantaPerMetre * (has_sea ? 1 : grain_m(around, column, row));
      const auto quanta = map::quantised_height(samplers, plane, around.vertex(column, row), grain);
      const double height_m = quanta ? *quanta / kQuantaPerMetre : 0;
      known.push_back(quanta && std::abs(height_m) <= kHighest_m);
      around.heights_m.push_back(known.back() ? static_cast<std::int32_t>(height_m) : 0);
    }
  return known;
}

// Gives the vertices in the extent its own heights, as known ones.
void take_heights_of_extent(const Place& place, Surroundings& around, std::vector<bool>& known) {
  for (std::size_t row = 0; row < around.rows(); ++row)
    for (std::size_t column = 0; column < around.columns(); ++column) {
      const Vec2 p = around.vertex(column, row);
      if (!place.extent.contains(p)) continue;
      const std::size_t at = around.index(column, row);
      const bool has_height = place.heights != nullptr && !place.heights->heights.empty();
      const double height_m = has_height ? std::floor(map::height_m_at(*place.heights, p) + 0.5) : 0;
      around.heights_m[at] = static_cast<std::int32_t>(std::clamp(height_m, -kHighest_m, kHighest_m)), known[at] = true;
    }
}

// Distances of samples from the grid.
struct Errors {
  double largest_m = 0, sum_m2 = 0, count = 0;
  void add(double error_m) {
    largest_m = std::max(largest_m, std::abs(error_m));
    sum_m2 += error_m * error_m, ++count;
  }
};

// True if an earlier heightmap covers the place.
bool is_hidden(std::span<const RasterSampler> earlier, LonLat at) {
  return std::ranges::any_of(earlier, [&](const RasterSampler& sampler) {
    return sampler.height_m<double>(at.lon_deg, at.lat_deg).has_value();
  });
}

void measure(const source::Raster& raster, std::span<const RasterSampler> earlier, const map::Plane& plane,
             const Place& place, const Surroundings& around, Errors& errors) {
  if (!raster.system_wkt.empty()) return;  // only samples in degrees can be placed exactly
  const Box2 box = around.box();
  for (int r = 0; r < raster.rows; ++r)
    for (int c = 0; c < raster.columns; ++c) {
      const auto& g = raster.from_grid;
      const LonLat at{g[0] + g[1] * c + g[2] * r, g[3] + g[4] * c + g[5] * r};
      const Vec2 p = plane.forward(at);
      const float height_m = raster.at(c, r);
      if (!box.contains(p) || place.extent.contains(p) || !map::is_height(height_m) || is_hidden(earlier, at)) continue;
      const double sample_m = place.water.has_sea() ? std::max(0.0f, height_m) : height_m;
      errors.add(sample_m - height_m_at(around, p));
    }
}

// Whole metres, rounded up: reported, not computed with.
void state_errors(std::span<const source::Raster> rasters, std::span<const RasterSampler> samplers,
                  const map::Plane& plane, const Place& place, Surroundings& around) {
  Errors errors;
  for (std::size_t i = 0; i < rasters.size(); ++i) measure(rasters[i], samplers.first(i), plane, place, around, errors);
  if (errors.count == 0) return;
  around.error_m = std::min(std::ceil(errors.largest_m), 2 * kHighest_m);
  around.rms_error_m = std::min(std::ceil(std::sqrt(errors.sum_m2 / errors.count)), 2 * kHighest_m);
}

}  // namespace

Result<Surroundings> plan(std::span<const source::Raster> rasters, const map::Plane& plane, const Place& place) {
  const Result<std::vector<RasterSampler>> samplers = map::samplers_of(rasters);
  if (!samplers) return samplers.error();
  Surroundings around{.x_m = lines_for(place.extent.min.x, place.extent.max.x, place.tile_m),
                      .y_m = lines_for(place.extent.min.y, place.extent.max.y, place.tile_m),
                      .heights_m = {},
                      .covers = {}};
  if (around.columns() > kMostLines || around.rows() > kMostLines) return Surroundings();
  std::vector<bool> known = sample(*samplers, plane, place.water.has_sea(), around);
  if (std::ranges::find(known, true) == known.end()) take_heights_of_extent(place, around, known);
  find_open_water(place.water, place.extent, known, around);
  fill_unknown(place.water, known, around);
  state_errors(rasters, *samplers, plane, place, around);
  return around;
}

}  // namespace citykiln::surroundings
