#include "compiler/source/voids/spikes_to_voids.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "compiler/contract/erase_repeated.h"

namespace citykiln::source {
namespace {

// Chosen on the real heightmaps of the tests: the smallest values that keep every sea stack, river bank and cliff (the
// worst is 18.5 m on a coast with 20 m samples) and still find clear errors (17 m in a plain with 7 m samples).
constexpr double kLeast_m = 12, kLeastSlope = 0.5;
constexpr double kBends = 5;
// radius of the surrounding land that is examined, in samples from the block
constexpr int kAround = 3;
// fewer bends than this are not enough for a median
constexpr std::size_t kFewestBends = 8;
constexpr int kFewestKnown = 5;
// a spike may hide its neighbour until it is removed; each round depends on samples up to 5 away
constexpr int kRounds = 2;
static_assert(kRounds * 5 <= kSpikeInfluence);

// The subsets of a block of two by two that can be a spike: bit 0 is the anchor, 1 its eastern, 2 its southern, 3 its
// south-eastern neighbour.
constexpr std::array<int, 10> kShapes = {0b0001, 0b0011, 0b0101, 0b1001, 0b0110,
                                         0b0111, 0b1011, 0b1101, 0b1110, 0b1111};

struct Step {
  int east = 0, south = 0;
};
constexpr std::array<Step, 4> kLines = {{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};

struct Block {
  int column = 0, row = 0;  // the anchor
  int shape = 0;

  bool holds(int c, int r) const {
    const int east = c - column, south = r - row;
    return (east == 0 || east == 1) && (south == 0 || south == 1) && (shape >> (east + 2 * south) & 1) != 0;
  }
  int width() const { return shape == 0b0001 ? 1 : 2; }
};

double least_m(const Raster& raster, int width) { return kLeast_m + kLeastSlope * raster.file_spacing_m * width; }

// The height of a sample; NaN outside the raster.
float height_m(const Raster& raster, int column, int row) {
  const bool is_inside = column >= 0 && row >= 0 && column < raster.columns && row < raster.rows;
  return is_inside ? raster.at(column, row) : kVoid;
}

// ---- prediction from neighbours ----

// Two samples outside the block along one direction; the nearer one lies behind at most one void.
struct Ahead {
  int steps = 1;  // to the nearer sample
  float first_m = kVoid, second_m = kVoid;
  bool is_next = true;  // no void lies before the nearer sample

  double extrapolated_m() const { return first_m + (static_cast<double>(first_m) - second_m) * steps; }
};

Ahead look_ahead(const Raster& raster, const Block& block, int column, int row, Step step) {
  Ahead ahead;
  while (block.holds(column + ahead.steps * step.east, row + ahead.steps * step.south)) ++ahead.steps;
  const auto at = [&](int steps) { return height_m(raster, column + steps * step.east, row + steps * step.south); };
  ahead.is_next = !std::isnan(at(ahead.steps));
  if (!ahead.is_next) ++ahead.steps;
  ahead.first_m = at(ahead.steps);
  ahead.second_m = at(ahead.steps + 1);
  return ahead;
}

// How far one height lies above or below all predicted heights.
struct Excess {
  double above_m = std::numeric_limits<double>::infinity(), below_m = above_m;
  int known = 0;  // neighbours with a height

  double largest_m() const { return std::max(above_m, below_m); }
};

void add_prediction(double own_m, double predicted_m, Excess& excess) {
  if (std::isnan(predicted_m)) return;
  excess.above_m = std::min(excess.above_m, own_m - predicted_m);
  excess.below_m = std::min(excess.below_m, predicted_m - own_m);
}

// Adds the predictions along one line through the sample.
void add_predictions_along(const Raster& raster, const Block& block, int column, int row, Step step, Excess& excess) {
  const double own_m = raster.at(column, row);
  const Ahead on = look_ahead(raster, block, column, row, step);
  const Ahead back = look_ahead(raster, block, column, row, {-step.east, -step.south});
  const double weighted_m = static_cast<double>(on.first_m) * back.steps + static_cast<double>(back.first_m) * on.steps;
  add_prediction(own_m, weighted_m / (on.steps + back.steps), excess);
  add_prediction(own_m, on.extrapolated_m(), excess);
  add_prediction(own_m, back.extrapolated_m(), excess);
  excess.known += on.is_next + back.is_next;
}

Excess excess_of(const Raster& raster, const Block& block, int column, int row, double floor_m) {
  Excess excess;
  for (const Step step : kLines) {
    add_predictions_along(raster, block, column, row, step, excess);
    // the first line rejects nearly all samples
    if (excess.largest_m() < floor_m) break;
  }
  return excess;
}

// ---- surrounding land ----

void take_bend(const Raster& raster, const Block& block, int column, int row, int east, int south,
               std::vector<double>& bends_m) {
  double heights_m[3];
  for (int i = 0; i < 3; ++i) {
    const int c = column + (i - 1) * east, r = row + (i - 1) * south;
    heights_m[i] = block.holds(c, r) ? kVoid : height_m(raster, c, r);
  }
  const double bend_m = std::abs(0.5 * (heights_m[0] + heights_m[2]) - heights_m[1]);
  if (!std::isnan(bend_m)) bends_m.push_back(bend_m);
}

// The median distance of samples from the mean of their two neighbours. Empty if too few are known.
std::optional<double> median_bend_m(const Raster& raster, const Block& block) {
  std::vector<double> bends_m;
  for (int r = block.row - kAround; r < block.row + block.width() + kAround; ++r) {
    for (int c = block.column - kAround; c < block.column + block.width() + kAround; ++c) {
      const bool is_inner_row = r > block.row - kAround && r + 1 < block.row + block.width() + kAround;
      const bool is_inner_column = c > block.column - kAround && c + 1 < block.column + block.width() + kAround;
      if (is_inner_column) take_bend(raster, block, c, r, 1, 0, bends_m);
      if (is_inner_row) take_bend(raster, block, c, r, 0, 1, bends_m);
    }
  }
  if (bends_m.size() < kFewestBends) return std::nullopt;
  const auto middle = bends_m.begin() + static_cast<std::ptrdiff_t>(bends_m.size() / 2);
  std::nth_element(bends_m.begin(), middle, bends_m.end());
  return *middle;
}

// ---- decision ----

struct Spike {
  std::size_t at = 0;
  double size_m = 0;
};

// The samples of the block if all of them stand out to the same side; else none.
std::vector<Spike> outliers_in(const Raster& raster, const Block& block, double floor_m) {
  std::vector<Spike> spikes;
  int above = 0;
  for (int i = 0; i < 4; ++i) {
    if ((block.shape >> i & 1) == 0) continue;
    const int column = block.column + i % 2, row = block.row + i / 2;
    if (std::isnan(height_m(raster, column, row))) return {};
    const Excess excess = excess_of(raster, block, column, row, floor_m);
    if (excess.largest_m() < floor_m || excess.known < kFewestKnown) return {};
    spikes.push_back({static_cast<std::size_t>(row) * raster.columns + column, excess.largest_m()});
    above += excess.above_m > 0;
  }
  if (above != 0 && above != static_cast<int>(spikes.size())) return {};
  return spikes;
}

void find_at(const Raster& raster, const Block& block, std::vector<Spike>& found) {
  const std::vector<Spike> spikes = outliers_in(raster, block, least_m(raster, block.width()));
  if (spikes.empty()) return;
  const std::optional<double> bend_m = median_bend_m(raster, block);
  const auto is_small = [&](const Spike& spike) { return spike.size_m <= kBends * *bend_m; };
  if (!bend_m || std::ranges::any_of(spikes, is_small)) return;
  found.insert(found.end(), spikes.begin(), spikes.end());
}

// A quick test that rejects nearly all samples: does the sample stand out of its row, whichever neighbour is with it?
bool stands_out_of_row(const Raster& raster, int column, int row) {
  if (std::isnan(raster.at(column, row))) return false;
  const auto stands_out = [&](const Block& block) {
    Excess excess;
    add_predictions_along(raster, block, column, row, kLines[0], excess);
    return excess.largest_m() >= least_m(raster, block.width());
  };
  return stands_out({column, row, 0b0001}) || stands_out({column, row, 0b0011}) ||
         stands_out({column - 1, row, 0b0011});
}

// All spikes sorted by sample, each sample once with its largest size.
std::vector<Spike> find_spikes(const Raster& raster) {
  std::vector<Spike> found;
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      if (!stands_out_of_row(raster, column, row)) continue;
      // every block that contains the sample
      for (const Step back : {Step{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
        for (const int shape : kShapes) {
          const Block block{column - back.east, row - back.south, shape};
          if (block.holds(column, row)) find_at(raster, block, found);
        }
      }
    }
  }
  std::ranges::sort(found,
                    [](const Spike& a, const Spike& b) { return a.at != b.at ? a.at < b.at : a.size_m > b.size_m; });
  erase_repeated(found, &Spike::at);
  return found;
}

}  // namespace

Raster spikes_to_voids(Raster raster, Report& report) {
  assert(raster.has_all_samples());
  for (int round = 0; round < kRounds; ++round) {
    // all are found before any is removed, so the result does not depend on the order
    const std::vector<Spike> spikes = find_spikes(raster);
    if (spikes.empty()) break;
    for (const Spike& spike : spikes) {
      raster.heights_m[spike.at] = kVoid;
      report.add(Code::kHeightSpike, OsmId{}, spike.size_m);
    }
  }
  return raster;
}

}  // namespace citykiln::source
