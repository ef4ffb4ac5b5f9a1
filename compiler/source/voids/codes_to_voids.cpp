#include "compiler/source/voids/codes_to_voids.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "compiler/source/voids/blocks_to_voids.h"

namespace citykiln::source {
namespace {

// the samples around a patch: first those into which its value may be mixed, then the land, then the land beside that
constexpr int kMixedRings = 2, kLandRing = kMixedRings + 1, kFarthestRing = kLandRing + 1;
// least share of one value in a patch of values that are not on Earth
constexpr double kOneValue = 0.5;
// how far land lies from a patch: at least this much, in general and where the raster's edge hides a part of it
constexpr double kAwayInside_m = 12, kAwayInsideSlope = 0.5, kAwayAtEdge_m = 60, kAwayAtEdgeSlope = 2;
// the same as a multiple of the land's own steps
constexpr double kAwaySteps = 4;
// shares of the land that may be nearer, or have larger steps
constexpr double kNearShare = 0.02, kSteepShare = 0.1;
// samples this far from the land beside them are mixed with a patch's value
constexpr double kMixed_m = 6, kMixedSlope = 0.5, kMixedSteps = 3;
constexpr float kCodesFrom_m = 6000;
constexpr float kNearlyZero_m = 1e-3F;

bool is_on_earth(float height_m) { return height_m >= kLowestLand_m && height_m <= kHighestLand_m; }

// -9999, 99999 and the like, and the ends of number types.
bool is_usual_code(double height_m) {
  for (const double code : {9999.0, 99999.0, 999999.0, 9999999.0, 32767.0, 32768.0, 65535.0, 10000.0})
    if (std::abs(height_m) == code) return !is_on_earth(static_cast<float>(height_m));
  return false;
}

// True for heights on Earth that may stand for none.
bool may_be_code(const Raster& raster, float height_m) {
  return height_m < kNearlyZero_m || height_m >= kCodesFrom_m ||
         std::ranges::find(raster.code_heights_m, height_m) != raster.code_heights_m.end();
}

struct Patch {
  std::vector<std::size_t> cells;
  int west, north, east, south;  // the box around them
  float value_m = 0;             // the value of most
  double share = 0;              // the share of that value
};

// The samples around a patch, by their distance in samples, 1 to kFarthestRing.
struct Rings {
  std::vector<std::size_t> at[kFarthestRing + 1];
};

class Codes {
 public:
  explicit Codes(Raster raster) : raster_(std::move(raster)), seen_(raster_.heights_m.size()), away_(seen_.size()) {}

  void find() {
    for (std::size_t at = 0; at < seen_.size(); ++at) {
      const float height_m = raster_.heights_m[at];
      if (std::isnan(height_m) || seen_[at] || (is_on_earth(height_m) && !may_be_code(raster_, height_m))) continue;
      const Patch patch = patch_from(at);
      const bool is_code = is_on_earth(height_m) ? is_code_on_earth(patch) : is_code_beyond_earth(patch);
      if (is_code) add_codes(patch);
    }
  }
  Raster result(Report& report) && {
    for (const auto& [value_m, samples] : counts_)
      report.add({Code::kHeightCode, {}, static_cast<double>(samples), {}, {}, fmt::format("height={:g}", value_m)});
    for (const std::size_t at : voids_) raster_.heights_m[at] = kVoid;
    return std::move(raster_);
  }

 private:
  float height_at(std::size_t at) const { return raster_.heights_m[at]; }

  template <typename Visit>
  void for_each_beside(std::size_t at, Visit visit) const {
    const int column = static_cast<int>(at % raster_.columns), row = static_cast<int>(at / raster_.columns);
    for (int r = std::max(0, row - 1); r <= std::min(raster_.rows - 1, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(raster_.columns - 1, column + 1); ++c)
        if (c != column || r != row) visit(static_cast<std::size_t>(r) * raster_.columns + c);
  }

  // The neighbouring samples with the value of the first, or all that are not on Earth if it is not.
  Patch patch_from(std::size_t start) {
    const float first_m = height_at(start);
    const auto belongs = [&](float height_m) {
      if (!is_on_earth(first_m)) return !std::isnan(height_m) && !is_on_earth(height_m);
      return height_m == first_m || (std::abs(first_m) < kNearlyZero_m && std::abs(height_m) < kNearlyZero_m);
    };
    Patch patch{{start}, raster_.columns, raster_.rows, 0, 0};
    seen_[start] = true;
    for (std::size_t i = 0; i < patch.cells.size(); ++i) {
      const std::size_t at = patch.cells[i];
      const int column = static_cast<int>(at % raster_.columns), row = static_cast<int>(at / raster_.columns);
      patch.west = std::min(patch.west, column), patch.east = std::max(patch.east, column);
      patch.north = std::min(patch.north, row), patch.south = std::max(patch.south, row);
      for_each_beside(at, [&](std::size_t next) {
        if (seen_[next] || !belongs(height_at(next))) return;
        seen_[next] = true;
        patch.cells.push_back(next);
      });
    }
    set_value(patch);
    return patch;
  }

  void set_value(Patch& patch) const {
    std::map<float, std::size_t> counts;
    for (const std::size_t at : patch.cells) ++counts[height_at(at)];
    const auto most = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
    patch.value_m = most->first;
    patch.share = static_cast<double>(most->second) / static_cast<double>(patch.cells.size());
  }

  bool touches_edge(const Patch& patch) const {
    return patch.west == 0 || patch.north == 0 || patch.east == raster_.columns - 1 || patch.south == raster_.rows - 1;
  }

  // The known samples around a patch that are on Earth.
  Rings rings_of(const Patch& patch) {
    Rings rings;
    std::vector<std::size_t> marked;
    const auto grow = [&](const std::vector<std::size_t>& from, int away) {
      for (const std::size_t at : from)
        for_each_beside(at, [&](std::size_t next) {
          if (away_[next] != 0) return;
          away_[next] = static_cast<std::uint8_t>(away);
          marked.push_back(next);
          if (is_on_earth(height_at(next))) rings.at[away].push_back(next);
        });
    };
    for (const std::size_t at : patch.cells) away_[at] = kFarthestRing + 1;
    grow(patch.cells, 1);
    for (int away = 2; away <= kFarthestRing; ++away) grow(rings.at[away - 1], away);
    for (const std::vector<std::size_t>* cells : {&patch.cells, &std::as_const(marked)})
      for (const std::size_t at : *cells) away_[at] = 0;
    return rings;
  }

  // The largest step from each sample of the land to those beside it that are farther away.
  std::vector<double> steps_of_land(const Rings& rings) const {
    std::vector<double> steps_m;
    for (const std::size_t at : rings.at[kLandRing]) {
      double largest_m = 0;
      for_each_beside(at, [&](std::size_t next) {
        if (std::ranges::binary_search(rings.at[kFarthestRing], next))
          largest_m = std::max(largest_m, std::abs(double{height_at(next)} - height_at(at)));
      });
      steps_m.push_back(largest_m);
    }
    std::ranges::sort(steps_m);
    return steps_m;
  }

  static double at_share(const std::vector<double>& sorted, double share) {
    return sorted.empty() ? 0 : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  }

  bool is_code_beyond_earth(const Patch& patch) {
    if (is_usual_code(patch.value_m) && patch.share >= kOneValue) return true;
    return patch.share >= kOneValue && patch.cells.size() > 1 && !rings_of(patch).at[1].empty();
  }

  bool is_code_on_earth(const Patch& patch) {
    const bool at_edge = touches_edge(patch);
    const bool is_small = patch.east - patch.west < kLargestBlock && patch.south - patch.north < kLargestBlock;
    if (is_small && !(at_edge && patch.cells.size() > 2)) return false;
    // most of a heightmap is its land or sea, also where a plateau ends beside it
    if (2 * patch.cells.size() > raster_.heights_m.size()) return false;
    Rings rings = rings_of(patch);
    std::ranges::sort(rings.at[kFarthestRing]);
    if (rings.at[kLandRing].empty() || rings.at[kFarthestRing].empty()) return false;
    const auto above_m = [&](std::size_t at) { return double{height_at(at)} - patch.value_m; };
    const double side = above_m(rings.at[kLandRing].front()) > 0 ? 1 : -1;
    std::vector<double> away_m;
    for (const std::size_t at : rings.at[kLandRing]) away_m.push_back(side * above_m(at));
    std::ranges::sort(away_m);
    const double near_m = at_share(away_m, kNearShare);
    const double least_m = at_edge ? kAwayAtEdge_m + kAwayAtEdgeSlope * raster_.file_spacing_m
                                   : kAwayInside_m + kAwayInsideSlope * raster_.file_spacing_m;
    if (near_m < least_m || near_m < kAwaySteps * at_share(steps_of_land(rings), 1 - kSteepShare)) return false;
    // a beach leads down to the sea, also where cliffs rise behind it
    const auto is_high = [&](std::size_t at) { return side * above_m(at) > near_m / 2; };
    const std::vector<std::size_t>& beside = rings.at[kMixedRings];
    return std::ranges::count_if(beside, is_high) >= 0.95 * static_cast<double>(beside.size());
  }

  // Adds the samples of a patch, and those into which its value is mixed.
  void add_codes(const Patch& patch) {
    voids_.insert(voids_.end(), patch.cells.begin(), patch.cells.end());
    std::size_t& count = counts_[patch.value_m];
    count += patch.cells.size();
    Rings rings = rings_of(patch);
    std::ranges::sort(rings.at[kFarthestRing]);
    const double allowed_m = std::max(kMixed_m + kMixedSlope * raster_.file_spacing_m,
                                      kMixedSteps * at_share(steps_of_land(rings), 1 - kSteepShare));
    std::vector<std::size_t> land = rings.at[kLandRing];
    for (int away = kMixedRings; away > 0; --away) {
      std::ranges::sort(land);
      std::vector<std::size_t> kept;
      for (const std::size_t at : rings.at[away]) {
        if (const auto land_m = mean_beside(at, land); land_m && std::abs(*land_m - height_at(at)) > allowed_m)
          voids_.push_back(at), ++count;
        else
          kept.push_back(at);
      }
      land.insert(land.end(), kept.begin(), kept.end());
    }
  }

  // The mean of the land beside a sample; nothing where there is none.
  std::optional<double> mean_beside(std::size_t at, const std::vector<std::size_t>& land) const {
    double sum_m = 0;
    int count = 0;
    for_each_beside(at, [&](std::size_t next) {
      if (std::ranges::binary_search(land, next)) sum_m += height_at(next), ++count;
    });
    return count > 0 ? std::optional(sum_m / count) : std::nullopt;
  }

  Raster raster_;
  std::vector<bool> seen_;
  std::vector<std::uint8_t> away_;  // used by rings_of
  std::vector<std::size_t> voids_;
  std::map<float, std::size_t> counts_;  // by value
};

bool has_codes(const Raster& raster) {
  return std::ranges::any_of(raster.heights_m,
                             [&](float h) { return !std::isnan(h) && (!is_on_earth(h) || may_be_code(raster, h)); });
}

}  // namespace

Raster codes_to_voids(Raster raster, Report& report) {
  assert(raster.has_all_samples());
  if (!has_codes(raster)) return raster;
  Codes codes(std::move(raster));
  codes.find();
  return std::move(codes).result(report);
}

std::optional<Error> first_height_off_land(const Raster& raster) {
  const auto is_wrong = [](float height_m) { return !std::isnan(height_m) && !is_on_earth(height_m); };
  const auto first = std::ranges::find_if(raster.heights_m, is_wrong);
  if (first == raster.heights_m.end()) return std::nullopt;
  const auto at = static_cast<std::size_t>(first - raster.heights_m.begin());
  const double column = static_cast<double>(at % raster.columns), row = static_cast<double>(at / raster.columns);
  const auto& g = raster.from_grid;
  const double x = g[0] + g[1] * column + g[2] * row, y = g[3] + g[4] * column + g[5] * row;
  const std::string place = raster.system_wkt.empty() ? fmt::format("{:.5f},{:.5f} (longitude, latitude)", x, y)
                                                      : fmt::format("{:.1f},{:.1f} in its own system", x, y);
  return Error{
      raster.file_name,
      fmt::format("expected heights on Earth, {:.0f} to {:.0f} m, found {:g} m at {}; {} samples are such. If "
                  "its unit is not the metre, add unit= or scale=, such as unit=ft",
                  kLowestLand_m, kHighestLand_m, *first, place, std::ranges::count_if(raster.heights_m, is_wrong))};
}

}  // namespace citykiln::source
