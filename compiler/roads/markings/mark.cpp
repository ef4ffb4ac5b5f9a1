#include "compiler/roads/markings/mark.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {
namespace {

// The mitre of two segments: the vector from their common point to the left outline.
Vec2 mitre_offset(Vec2 before, Vec2 after, double half_width) {
  const Vec2 left_before = left_of(unit(before)), left_after = left_of(unit(after));
  const Vec2 middle = unit(left_before + left_after);
  return middle * (half_width / dot(middle, left_after));
}

}  // namespace

Ring rectangle(Vec2 low, Vec2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

void add_line(double u_m, double width_m, DashPattern dashes, Marks& marks, materials::TextureImage::Texel colour) {
  assert(0 < dashes.dash_m && dashes.dash_m <= dashes.period_m);
  const double left_m = u_m - width_m / 2, right_m = u_m + width_m / 2;
  if (dashes.dash_m == dashes.period_m) {
    marks.push_back({rectangle({left_m, 0}, {right_m, kLayoutLength_m}), colour});
    return;
  }
  for (double period_m = 0; period_m < kLayoutLength_m; period_m += dashes.period_m) {
    const double low_m = period_m + (dashes.period_m - dashes.dash_m) / 2;
    marks.push_back({rectangle({left_m, low_m}, {right_m, low_m + dashes.dash_m}), colour});
  }
}

void add_dashes_across(double left_m, double right_m, double low_m, double high_m, DashPattern dashes, Marks& marks) {
  assert(0 < dashes.dash_m && dashes.dash_m <= dashes.period_m);
  const double gap_m = dashes.period_m - dashes.dash_m, width_m = right_m - left_m;
  const double count = std::max(1.0, std::floor((width_m + gap_m) / dashes.period_m + 0.5));
  // dashes and gaps together fill the width exactly
  const double scale = width_m / (count * dashes.period_m - gap_m);
  for (double i = 0; i < count; ++i) {
    const double at_m = left_m + i * dashes.period_m * scale;
    marks.push_back({rectangle({at_m, low_m}, {at_m + dashes.dash_m * scale, high_m}), kWhite});
  }
}

Ring stroke(std::span<const Vec2> line, double width) {
  assert(line.size() >= 2 && width > 0);
  const std::size_t last = line.size() - 1;
  const bool is_closed = line.front() == line.back();
  const auto offset = [&](std::size_t i) {
    const Vec2 after = i < last ? line[i + 1] - line[i] : is_closed ? line[1] - line[0] : line[i] - line[i - 1];
    const Vec2 before = i > 0 ? line[i] - line[i - 1] : is_closed ? line[last] - line[last - 1] : after;
    return mitre_offset(before, after, width / 2);
  };
  Ring ring;
  for (std::size_t i = 0; i <= last; ++i) ring.push_back(line[i] - offset(i));
  for (std::size_t i = last + 1; i-- > 0;) ring.push_back(line[i] + offset(i));
  return ring;
}

Marks turned_round(const Marks& marks, double width_m, double length_m) {
  Marks turned = marks;
  for (Mark& mark : turned)
    for (Vec2& p : mark.ring) p = Vec2{width_m, length_m} - p;
  return turned;
}

}  // namespace citykiln::roads
