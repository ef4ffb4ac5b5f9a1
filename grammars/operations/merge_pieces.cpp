#include "grammars/operations/merge_pieces.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "grammars/language/body_properties.h"

namespace citykiln::grammars {
namespace {

double slice_width_m(const Slice& slice) { return slice.interval.to_m - slice.interval.from_m; }

// With a margin for the rounding of a piece exactly as wide as the tolerance.
bool is_narrow(double width_m, double tolerance_m) { return width_m <= tolerance_m + kSliver_m; }

/// A run of adjacent narrow pieces, from `first` to before `end`.
struct Narrow {
  std::size_t first = 0, end = 0;
  double width_m = 0;
};

Narrow narrow_run_from(std::span<const Slice> slices, std::size_t first, double tolerance_m) {
  Narrow narrow{first, first, 0};
  for (; narrow.end < slices.size() && is_narrow(slice_width_m(slices[narrow.end]), tolerance_m); ++narrow.end)
    narrow.width_m += slice_width_m(slices[narrow.end]);
  return narrow;
}

/// The bounds of the pieces, computed once for each selector.
struct PieceBounds {
  Execution& execution;
  std::span<const Selector* const> selectors;
  NumberRanges arguments = ranges_of(execution);
  SmallVector<std::optional<DisplacementBound>, 8> known{selectors.size()};

  DisplacementBound of(const Slice& slice) {
    std::optional<DisplacementBound>& bound = known[slice.interval.leaf];
    if (!bound) bound = displacement_bound(execution, arguments, selectors[slice.interval.leaf]->body);
    return *bound;
  }
  DisplacementBound of(std::span<const Slice> slices) {
    DisplacementBound worst{{0, 0}, true};
    for (const Slice& slice : slices) {
      const DisplacementBound bound = of(slice);
      worst.survives &= bound.survives;
      worst.moved.to_earlier_m = std::max(worst.moved.to_earlier_m, bound.moved.to_earlier_m);
      worst.moved.to_later_m = std::max(worst.moved.to_later_m, bound.moved.to_later_m);
    }
    return worst;
  }
};

double error_m(DisplacementBound left_out, DisplacementBound neighbour) {
  if (!left_out.survives || !neighbour.survives) return kUnbounded_m;
  const Displacement a = left_out.moved, b = neighbour.moved;
  return std::max(b.to_earlier_m + std::max(a.to_later_m, b.to_later_m),
                  std::max(a.to_earlier_m, b.to_earlier_m) + b.to_later_m);
}

/// The neighbour that a run of narrow pieces is merged into; `slice` ~0 for none.
struct Absorber {
  std::size_t slice = ~std::size_t{0};
  double error_m = kUnbounded_m;
};

Absorber absorber_of(std::span<const Slice> slices, Narrow narrow, PieceBounds& bounds) {
  const DisplacementBound left_out = bounds.of(slices.subspan(narrow.first, narrow.end - narrow.first));
  Absorber absorber;
  if (!left_out.survives) return absorber;
  const auto ask = [&](std::size_t i) {
    const double e_m = error_m(left_out, bounds.of(slices[i]));
    if (e_m < absorber.error_m) absorber = {i, e_m};
  };
  if (narrow.first > 0) ask(narrow.first - 1);
  if (narrow.end < slices.size()) ask(narrow.end);
  return absorber;
}

// By slice: its own index, or that of the slice it is merged into.
SmallVector<std::size_t, 8> absorbers_of(std::span<const Slice> slices, double tolerance_m, PieceBounds& bounds,
                                         double& error_m) {
  SmallVector<std::size_t, 8> absorbers(slices.size());
  for (std::size_t i = 0; i < slices.size(); ++i) absorbers[i] = i;
  for (Narrow narrow; narrow.first < slices.size(); narrow.first = std::max(narrow.end, narrow.first + 1)) {
    narrow = narrow_run_from(slices, narrow.first, tolerance_m);
    if (narrow.end == narrow.first || !is_narrow(narrow.width_m, tolerance_m)) continue;
    const Absorber absorber = absorber_of(slices, narrow, bounds);
    if (absorber.error_m > tolerance_m) continue;
    for (std::size_t i = narrow.first; i < narrow.end; ++i) absorbers[i] = absorber.slice;
    error_m = std::max(error_m, absorber.error_m);
  }
  return absorbers;
}

SmallVector<Slice, 8> without_absorbed(std::span<const Slice> slices, std::span<const std::size_t> absorbers) {
  SmallVector<Slice, 8> kept;
  std::uint32_t left_out = 0;
  double from_m = slices.empty() ? 0 : slices.front().interval.from_m;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    if (absorbers[i] == i) {
      kept.push_back(slices[i]);
      kept.back().interval.from_m = from_m;
      kept.back().left_out = std::exchange(left_out, 0);
    } else {
      ++left_out;
      if (absorbers[i] < i) kept.back().interval.to_m = slices[i].interval.to_m;
    }
    if (absorbers[i] <= i) from_m = slices[i].interval.to_m;
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

bool may_merge_narrow(const Run& run, const Shape& shape) {
  return run.measures() && run.options.keep_appearances && run.options.prune_early && is_flat(shape);
}

Division merge_narrow_pieces(Execution& execution, Division division, std::span<const Selector* const> selectors) {
  assert(is_flat(execution.shape));
  const double tolerance_m = execution.run.options.tolerance_m;
  const auto may_go = [&](const Slice& slice) { return is_narrow(slice_width_m(slice), tolerance_m); };
  if (std::none_of(division.slices.begin(), division.slices.end(), may_go)) return division;
  PieceBounds bounds{execution, selectors};
  const auto absorbers = absorbers_of(span_of(division.slices), tolerance_m, bounds, division.error_m);
  division.slices = without_absorbed(span_of(division.slices), span_of(absorbers));
  return division;
}

bool may_merge_terminals(const Run& run, const Shape& shape) { return run.options.prune_early && is_flat(shape); }

Division merge_terminals(Division division, std::span<const Selector* const> selectors) {
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
