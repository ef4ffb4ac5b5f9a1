#include "compiler/map/plane/degrees.h"

#include <fmt/format.h>

#include <cmath>

namespace citykiln::map {

std::string degrees_text(double deg, int decimals) { return fmt::format("{:.{}f}", deg, decimals); }

double rounded_degrees(double deg) {
  static_assert(kDegreeDecimals == 7);
  return std::floor(deg * 1e7 + 0.5) / 1e7;
}

std::array<double, 4> rounded_degrees(const source::LonLatBox& box) {
  return {rounded_degrees(box.west), rounded_degrees(box.south), rounded_degrees(box.east), rounded_degrees(box.north)};
}

}  // namespace citykiln::map
