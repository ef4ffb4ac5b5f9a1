#include "grammars/operations/merge_pieces.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "grammars/language/body_properties.h"

namespace citykiln::grammars {
namespace {

double width_m(const Slice& slice) { return slice.interval.to_m - slice.interval.from_m; }

// what is as wide as the tolerance is so wherever rounding left its ends
bool is_narrow(double width_m, double tolerance_m) { return width_m <= tolerance_m + kSliver_m; }

/// Narrow pieces next to each other, from `first` to before `end`.
struct Narrow {
  std::size_t first = 0, end = 0;
  double width_m = 0;
};

Narrow narrow_from(std::span<const Slice> slices, std::size_t first, double tolerance_m) {
  Narrow narrow{first, first, 0};
  for (; narrow.end < slices.size() && is_narrow(width_m(slices[narrow.end]), tolerance_m); ++narrow.end)
    narrow.width_m += width_m(slices[narrow.end]);
  return narrow;
}

/// What is known of the pieces, looked up once for each selector.
struct Reaches {
  Execution& execution;
  std::span<const Selector* const> selectors;
  NumberRanges arguments = ranges_of(execution);
  SmallVector<std::optional<DisplacementBound>, 8> known{selectors.size()};

  DisplacementBound of(const Slice& slice) {
    std::optional<DisplacementBound>& reach = known[slice.interval.leaf];
    if (!reach) reach = displacement_bound(execution, arguments, selectors[slice.interval.leaf]->body);
    return *reach;
  }
  DisplacementBound of(std::span<const Slice> slices) {
    DisplacementBound worst{{0, 0}, true};
    for (const Slice& slice : slices) {
      const DisplacementBound reach = of(slice);
      worst.stays &= reach.stays;
      worst.moved.out_m = std::max(worst.moved.out_m, reach.moved.out_m);
      worst.moved.back_m = std::max(worst.moved.back_m, reach.moved.back_m);
    }
    return worst;
  }
};

double error_m(DisplacementBound left_out, DisplacementBound neighbour) {
  if (!left_out.stays || !neighbour.stays) return kUnbounded_m;
  const Displacement a = left_out.moved, b = neighbour.moved;
  return std::max(b.out_m + std::max(a.back_m, b.back_m), std::max(a.out_m, b.out_m) + b.back_m);
}

/// The neighbour that takes a run of narrow pieces; `slice` ~0 for none.
struct Taker {
  std::size_t slice = ~std::size_t{0};
  double error_m = kUnbounded_m;
};

Taker taker_of(std::span<const Slice> slices, Narrow narrow, Reaches& reaches) {
  const DisplacementBound left_out = reaches.of(slices.subspan(narrow.first, narrow.end - narrow.first));
  Taker taker;
  if (!left_out.stays) return taker;
  const auto ask = [&](std::size_t i) {
    const double e_m = error_m(left_out, reaches.of(slices[i]));
    if (e_m < taker.error_m) taker = {i, e_m};
  };
  if (narrow.first > 0) ask(narrow.first - 1);
  if (narrow.end < slices.size()) ask(narrow.end);
  return taker;
}

// By slice, who stands in its place: itself, or the one that takes it.
SmallVector<std::size_t, 8> takers_of(std::span<const Slice> slices, double tolerance_m, Reaches& reaches,
                                      double& error_m) {
  SmallVector<std::size_t, 8> takers(slices.size());
  for (std::size_t i = 0; i < slices.size(); ++i) takers[i] = i;
  for (Narrow narrow; narrow.first < slices.size(); narrow.first = std::max(narrow.end, narrow.first + 1)) {
    narrow = narrow_from(slices, narrow.first, tolerance_m);
    if (narrow.end == narrow.first || !is_narrow(narrow.width_m, tolerance_m)) continue;
    const Taker taker = taker_of(slices, narrow, reaches);
    if (taker.error_m > tolerance_m) continue;
    for (std::size_t i = narrow.first; i < narrow.end; ++i) takers[i] = taker.slice;
    error_m = std::max(error_m, taker.error_m);
  }
  return takers;
}

SmallVector<Slice, 8> without_taken(std::span<const Slice> slices, std::span<const std::size_t> takers) {
  SmallVector<Slice, 8> kept;
  std::uint32_t left_out = 0;
  double from_m = slices.empty() ? 0 : slices.front().interval.from_m;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    if (takers[i] == i) {
      kept.push_back(slices[i]);
      kept.back().interval.from_m = from_m;
      kept.back().left_out = std::exchange(left_out, 0);
    } else {
      ++left_out;
      if (takers[i] < i) kept.back().interval.to_m = slices[i].interval.to_m;
    }
    if (takers[i] <= i) from_m = slices[i].interval.to_m;
  }
  return kept;
}

}  // namespace

Division divided(std::span<const Interval> intervals) {
  Division division;
  division.slices.reserve(intervals.size());
  for (const Interval& interval : intervals)
    division.slices.push_back({interval, division.slices.size(), intervals.size(), 0});
  return division;
}

bool may_widen(const Run& run, const Shape& shape) {
  return run.measures() && run.options.keep_appearances && run.options.ahead && is_flat(shape);
}

Division merge_narrow_pieces(Execution& execution, Division division, std::span<const Selector* const> selectors) {
  const double tolerance_m = execution.run.options.tolerance_m;
  const auto may_go = [&](const Slice& slice) { return is_narrow(width_m(slice), tolerance_m); };
  if (std::none_of(division.slices.begin(), division.slices.end(), may_go)) return division;
  Reaches reaches{execution, selectors};
  const auto takers = takers_of(all_of(division.slices), tolerance_m, reaches, division.error_m);
  division.slices = without_taken(all_of(division.slices), all_of(takers));
  return division;
}

bool may_join(const Run& run, const Shape& shape) { return run.options.ahead && is_flat(shape); }

Division join_terminals(Division division, std::span<const Selector* const> selectors) {
  SmallVector<Slice, 8> kept;
  std::uint32_t left_out = 0;
  const std::string* last = nullptr;
  for (const Slice& slice : division.slices) {
    const std::string* terminal = terminal_of(selectors[slice.interval.leaf]->body);
    if (terminal != nullptr && last != nullptr && *terminal == *last) {
      kept.back().interval.to_m = slice.interval.to_m;
      left_out += slice.left_out + 1;
    } else {
      kept.push_back(slice);
      kept.back().left_out += std::exchange(left_out, 0);
    }
    last = terminal;
  }
  division.slices = std::move(kept);
  return division;
}

}  // namespace citykiln::grammars
