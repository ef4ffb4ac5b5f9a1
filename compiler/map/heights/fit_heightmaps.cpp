#include "compiler/map/heights/fit_heightmaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "compiler/map/plane/heightfield.h"
#include "compiler/map/plane/raster_sampler.h"
#include "compiler/source/voids/join_rasters.h"

namespace citykiln::map {
namespace {

using source::Raster;

constexpr int kLinesAcross = 64, kMostPlacesOnLine = 1024;

// Two heightmaps by their indices; the first covers a place before the second does.
using Pair = std::pair<std::size_t, std::size_t>;

struct Differences {
  std::map<Pair, std::vector<double>> where_they_meet, where_both_are;
};

// The heights of all heightmaps at the places of a line.
struct LineOfHeights {
  std::vector<std::vector<std::optional<double>>> heights_m;  // by place, then by heightmap

  std::optional<std::size_t> first_at(std::size_t place) const {
    const auto& all = heights_m[place];
    const auto first = std::ranges::find_if(all, [](const auto& height) { return height.has_value(); });
    return first == all.end() ? std::nullopt : std::optional<std::size_t>(first - all.begin());
  }
  std::optional<double> at(std::size_t place, std::size_t raster) const {
    return place < heights_m.size() ? heights_m[place][raster] : std::nullopt;
  }
  // The height half a step beyond a place, away from the place before it.
  std::optional<double> beyond(std::size_t place, std::size_t before, std::size_t raster) const {
    const auto last_m = at(place, raster), before_m = at(before, raster);
    return last_m && before_m ? std::optional(*last_m + (*last_m - *before_m) / 2) : std::nullopt;
  }
};

LineOfHeights line_of_heights(std::span<const RasterSampler> samplers, const Plane& plane, Vec2 from, Vec2 to,
                              double step_m) {
  const int steps = std::clamp(static_cast<int>(length(to - from) / step_m), 1, kMostPlacesOnLine);
  LineOfHeights line;
  for (int i = 0; i <= steps; ++i) {
    const LonLat place = plane.backward(from + (to - from) * (double{1} * i / steps));
    line.heights_m.emplace_back();
    for (const RasterSampler& sampler : samplers)
      line.heights_m.back().push_back(
          sampler.raster.heights_m.empty() ? std::nullopt : sampler.height_m<double>(place.lon_deg, place.lat_deg));
  }
  return line;
}

// Adds the difference of the heightmaps that cover a place and the next first, in metres that the pair's first is
// higher.
void add_meeting(const LineOfHeights& line, std::size_t place, Differences& found) {
  const auto here = line.first_at(place), next = line.first_at(place + 1);
  if (!here || !next || *here == *next) return;
  const Pair pair = std::minmax(*here, *next);
  const std::size_t both = *here < *next ? place : place + 1;
  if (const auto under_m = line.at(both, pair.second)) {
    found.where_they_meet[pair].push_back(*line.at(both, pair.first) - *under_m);
    return;
  }
  const auto here_m = place > 0 ? line.beyond(place, place - 1, *here) : std::nullopt,
             next_m = line.beyond(place + 1, place + 2, *next);
  if (here_m && next_m) found.where_they_meet[pair].push_back(*here < *next ? *here_m - *next_m : *next_m - *here_m);
}

void add_overlaps(const LineOfHeights& line, std::size_t place, Differences& found) {
  const auto& heights_m = line.heights_m[place];
  for (std::size_t i = 0; i < heights_m.size(); ++i)
    for (std::size_t j = i + 1; j < heights_m.size(); ++j)
      if (heights_m[i] && heights_m[j]) found.where_both_are[{i, j}].push_back(*heights_m[i] - *heights_m[j]);
}

void add_line(const LineOfHeights& line, Differences& found) {
  for (std::size_t place = 0; place < line.heights_m.size(); ++place) {
    add_overlaps(line, place, found);
    if (place + 1 < line.heights_m.size()) add_meeting(line, place, found);
  }
}

double coarsest_m(const std::vector<Raster>& rasters) {
  double coarsest = 1;
  for (const Raster& raster : rasters)
    if (!raster.heights_m.empty()) coarsest = std::max(coarsest, raster.file_spacing_m);
  return coarsest;
}

Result<Differences> differences_between(const std::vector<Raster>& rasters, const Plane& plane, const Box2& extent) {
  const Result<std::vector<RasterSampler>> samplers = samplers_of(rasters);
  if (!samplers) return samplers.error();
  Differences found;
  const double step_m = coarsest_m(rasters);
  for (int i = 0; i < kLinesAcross; ++i) {
    const double share = (i + 0.5) / kLinesAcross;
    const double x = extent.min.x + extent.width() * share, y = extent.min.y + extent.height() * share;
    add_line(line_of_heights(*samplers, plane, {extent.min.x, y}, {extent.max.x, y}, step_m), found);
    add_line(line_of_heights(*samplers, plane, {x, extent.min.y}, {x, extent.max.y}, step_m), found);
  }
  return found;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// The metres by which a heightmap lies above the first other one, not fitted itself, with which it has places in
// common.
std::optional<double> excess_of(std::size_t raster, const std::vector<Raster>& rasters, const Differences& found) {
  for (const auto* places : {&found.where_they_meet, &found.where_both_are})
    for (const auto& [pair, differences_m] : *places) {
      if (rasters[pair.first].is_fitted && rasters[pair.second].is_fitted) continue;
      if (pair.first == raster) return mean_of(differences_m);
      if (pair.second == raster) return -mean_of(differences_m);
    }
  return std::nullopt;
}

void report_steps(const std::vector<Raster>& rasters, const Differences& found, Report& report) {
  for (const auto& [pair, differences_m] : found.where_they_meet) {
    const Raster &first = rasters[pair.first], &second = rasters[pair.second];
    if (first.is_fitted || second.is_fitted) continue;
    if (const auto step_m = source::step_of_m(differences_m, first.file_spacing_m + second.file_spacing_m))
      report.add({Code::kHeightStep,
                  {},
                  std::abs(*step_m),
                  {},
                  {},
                  *step_m > 0 ? first.file_name + " above " + second.file_name
                              : second.file_name + " above " + first.file_name});
  }
}

}  // namespace

Result<std::vector<Raster>> fit_heightmaps(std::vector<Raster> rasters, const Plane& plane, const Box2& extent,
                                           Report& report) {
  const auto is_fitted = [](const Raster& raster) { return raster.is_fitted && !raster.heights_m.empty(); };
  if (std::ranges::count_if(rasters, [](const Raster& raster) { return !raster.heights_m.empty(); }) < 2 &&
      std::ranges::none_of(rasters, is_fitted))
    return rasters;
  const Result<Differences> found = differences_between(rasters, plane, extent);
  if (!found) return found.error();
  report_steps(rasters, *found, report);
  for (std::size_t i = 0; i < rasters.size(); ++i) {
    if (!is_fitted(rasters[i])) continue;
    const std::optional<double> excess_m = excess_of(i, rasters, *found);
    if (!excess_m)
      return Error{rasters[i].file_name, "offset=auto needs another heightmap without it that lies beside or under it"};
    // rounded, to be independent of the last bits of the CPU's sums
    const double shift_m = -std::round(*excess_m / kHeightQuantum_m) * kHeightQuantum_m;
    rasters[i].shift_m = shift_m;
    for (float& height_m : rasters[i].heights_m) height_m = static_cast<float>(height_m + shift_m);
    report.add({Code::kHeightShifted,
                {},
                std::abs(shift_m),
                {},
                {},
                rasters[i].file_name + (shift_m < 0 ? " downwards" : " upwards")});
  }
  return rasters;
}

}  // namespace citykiln::map
