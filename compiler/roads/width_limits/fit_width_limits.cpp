#include "compiler/roads/width_limits/fit_width_limits.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

#include "compiler/roads/width_limits/building_obstacles.h"

namespace citykiln::roads {
namespace {

// The sampled limit, capped at the full width.
struct Limit {
  std::span<const std::int16_t> units;
  int whole;

  std::size_t size() const { return units.size(); }
  int at(std::size_t i) const { return std::min<int>(units[i], whole); }
};

// The last step, up to `stop`, to which the limit rises by one unit a step.
std::size_t end_of_opening(const Limit& limit, std::size_t from, std::size_t stop) {
  std::size_t end = from;
  while (end < stop && limit.at(end + 1) == std::min(limit.at(end) + 1, limit.whole)) ++end;
  return end;
}

// The last step, up to `stop`, to which the limit falls by one unit a step.
std::size_t end_of_closing(const Limit& limit, std::size_t from, std::size_t stop) {
  std::size_t end = from;
  while (end < stop && limit.at(end) == std::min(limit.at(end + 1) + 1, limit.whole)) ++end;
  return end;
}

// The farthest step, up to `stop`, that a straight line reaches while it stays within kSlack_units below the limit; at
// least the next step.
std::size_t end_of_line(const Limit& limit, std::size_t from, std::size_t stop) {
  const double begin = limit.at(from);
  double least = -1, most = 1;
  std::size_t end = from + 1;
  for (std::size_t i = from + 1; i <= stop && limit.at(i) < limit.whole && least <= most; ++i) {
    const double run = static_cast<double>(i - from), slope = (limit.at(i) - begin) / run;
    if (least <= slope && slope <= most) end = i;
    most = std::min(most, slope), least = std::max(least, (limit.at(i) - kSlack_units - begin) / run);
  }
  return end;
}

// Fits the steps [begin, stop] independently of other blocks. A block that begins below the full width starts from the
// last limit of the block before it.
template <typename Push>
void fit_block(const Limit& limit, std::size_t begin, std::size_t stop, Push push) {
  std::size_t at = begin;
  if (begin == 0 || limit.at(begin) == limit.whole) {
    at = end_of_closing(limit, begin, stop);
    if (limit.at(at) == limit.whole) return;
    push(at, false);
  }
  while (at < stop) {
    const std::size_t opened = end_of_opening(limit, at, stop);
    if (opened == stop) {
      if (limit.at(stop) < limit.whole && stop + 1 < limit.size()) push(stop, false);
      return;
    }
    const std::size_t closed = end_of_closing(limit, opened, stop), line = end_of_line(limit, at, stop);
    const bool is_wall = opened == at || line > closed;
    at = is_wall ? line : closed;
    push(at, is_wall);
  }
}

}  // namespace

std::vector<WidthLimit> fit_width_limits(std::span<const std::int16_t> units, int whole, std::int32_t first) {
  assert(whole > 0 && first >= 0);
  assert(std::ranges::adjacent_find(units, [](int a, int b) { return std::abs(a - b) > 1; }) == units.end());
  const Limit limit{units, whole};
  std::vector<WidthLimit> width_limits;
  const auto push = [&](std::size_t i, bool is_wall) {
    width_limits.push_back({(first + static_cast<std::int32_t>(i)) * kStep_m, limit.at(i) * kUnit_m, is_wall});
  };
  const auto offset = static_cast<std::size_t>(first % kBlock_steps);
  for (std::size_t begin = 0; begin + 1 < limit.size();) {
    const std::size_t stop =
        std::min(limit.size() - 1, (begin + offset) / kBlock_steps * kBlock_steps + kBlock_steps - offset);
    fit_block(limit, begin, stop, push);
    begin = stop;
  }
  return width_limits;
}

}  // namespace citykiln::roads
