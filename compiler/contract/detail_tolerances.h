// Which details a mesh has at which tolerance: one table for all rooms (detail_tolerances.inc).
//
// Only details with a fixed limit are listed. Parts that go when their own error is below the tolerance need no row.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace citykiln {

enum class Detail {
#define DETAIL(name, from_m, below_m) name,
#include "compiler/contract/detail_tolerances.inc"
#undef DETAIL
};

/// Tolerances of at least `from_m` and less than `below_m`.
struct ToleranceRange {
  double from_m, below_m;
};

/// The smallest number above a positive one: makes a limit inclusive.
constexpr double just_above(double v) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) + 1); }

/// The tolerances at which a detail is made.
constexpr ToleranceRange tolerances_with(Detail detail) {
  constexpr double kNoLimit_m = std::numeric_limits<double>::infinity();
  constexpr ToleranceRange kRanges[] = {
#define DETAIL(name, from_m, below_m) {from_m, below_m},
#include "compiler/contract/detail_tolerances.inc"
#undef DETAIL
  };
  return kRanges[static_cast<int>(detail)];
}

/// Whether a mesh of this tolerance has the detail.
constexpr bool has_detail(Detail detail, double tolerance_m) {
  return tolerances_with(detail).from_m <= tolerance_m && tolerance_m < tolerances_with(detail).below_m;
}

}  // namespace citykiln
