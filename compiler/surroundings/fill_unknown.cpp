#include "compiler/surroundings/fill_unknown.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace citykiln::surroundings {
namespace {

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

}  // namespace

void fill_unknown(const std::vector<bool>& known, Surroundings& around) {
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
      around.covers[here] = around.covers[known_at];
      around.heights_m[here] = around.covers[here] == Cover::kSea ? 0 : faded(around.heights_m[known_at], mean, away_m);
    }
  }
}

}  // namespace citykiln::surroundings
