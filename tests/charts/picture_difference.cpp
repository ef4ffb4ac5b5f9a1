#include "tests/charts/picture_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace citykiln::charts {

double difference(const preview::Image& a, const preview::Image& b) {
  assert(a.rgb.size() == b.rgb.size() && !a.rgb.empty());
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(std::min(a.rgb[i], 1.f) - std::min(b.rgb[i], 1.f));
  return sum / static_cast<double>(a.rgb.size());
}

}  // namespace citykiln::charts
