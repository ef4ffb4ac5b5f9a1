#include "tests/charts/picture_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace citykiln::charts {
namespace {

// of linear sRGB
double luminance_at(const preview::Image& image, std::size_t pixel) {
  const float* rgb = &image.rgb[3 * pixel];
  return 0.2126 * static_cast<double>(rgb[0]) + 0.7152 * static_cast<double>(rgb[1]) +
         0.0722 * static_cast<double>(rgb[2]);
}

}  // namespace

double difference(const preview::Image& a, const preview::Image& b) {
  assert(a.rgb.size() == b.rgb.size() && !a.rgb.empty());
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(std::min(a.rgb[i], 1.f) - std::min(b.rgb[i], 1.f));
  return sum / static_cast<double>(a.rgb.size());
}

LuminanceDifference luminance_difference(const preview::Image& picture, const preview::Image& reference) {
  assert(picture.rgb.size() == reference.rgb.size() && !picture.rgb.empty());
  const std::size_t pixels = picture.rgb.size() / 3;
  double sum = 0, sum_of_reference = 0, squares = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    const double there = luminance_at(picture, i), wanted = luminance_at(reference, i);
    sum += there, sum_of_reference += wanted, squares += (there - wanted) * (there - wanted);
  }
  assert(sum_of_reference > 0);
  const auto count = static_cast<double>(pixels);
  return {sum / sum_of_reference, std::sqrt(squares / count) / (sum_of_reference / count)};
}

}  // namespace citykiln::charts
