// The tolerances at which a mesh has a detail, such as kerbs or normal maps: one table for the whole compiler
// (detail_tolerances.inc).
//
// Only details with a fixed limit are listed. A part that is left out because its own error is below the tolerance
// needs no row.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "compiler/contract/tolerance.h"

namespace citykiln {

/// The rows of detail_tolerances.inc.
enum class Detail {
#define DETAIL(name, from_m, below_m) name,
#include "compiler/contract/detail_tolerances.inc"
#undef DETAIL
};

/// The range from_m <= tolerance < below_m, in metres.
struct ToleranceRange {
  double from_m, below_m;
};

/// Returns the next double after a positive one. Used to make an upper limit inclusive.
constexpr double just_above(double v) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) + 1); }

/// Returns the tolerances at which a mesh has the detail.
constexpr ToleranceRange tolerances_with(Detail detail) {
  constexpr double kNoLimit_m = std::numeric_limits<double>::infinity();
  constexpr ToleranceRange kRanges[] = {
#define DETAIL(name, from_m, below_m) {from_m, below_m},
#include "compiler/contract/detail_tolerances.inc"
#undef DETAIL
  };
  return kRanges[static_cast<int>(detail)];
}

/// True if a mesh of this tolerance has the detail.
constexpr bool has_detail(Detail detail, double tolerance_m) {
  return tolerances_with(detail).from_m <= tolerance_m && tolerance_m < tolerances_with(detail).below_m;
}

}  // namespace citykiln
