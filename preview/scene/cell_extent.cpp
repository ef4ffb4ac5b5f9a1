#include "preview/scene/cell_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace citykiln::preview {
namespace {

constexpr float kFarOnRay = std::numeric_limits<float>::infinity();

// An interval along a ray.
struct RayInterval {
  double from, to;

  // Cuts it to where one coordinate of the ray is between two values.
  void cut(double origin, double direction, double low, double high) {
    if (direction == 0) {
      if (origin < low || origin > high) to = -kFarOnRay;
      return;
    }
    const double a = (low - origin) / direction, b = (high - origin) / direction;
    from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
  }
};

}  // namespace

// Single precision's errors of positions, and of Embree's hits, at the far side of the box.
CellExtent::CellExtent(const RTCBounds& box)
    : box_(box),
      width_(std::max((box.upper_x - box.lower_x) / kAcross, 1e-3f)),
      depth_(std::max((box.upper_y - box.lower_y) / kAcross, 1e-3f)) {
  constexpr float kRelative = 0x1p-18f;
  margin_ = 0.01f + kRelative * std::max({std::abs(box.lower_x), std::abs(box.upper_x), std::abs(box.lower_y),
                                          std::abs(box.upper_y), std::abs(box.lower_z), std::abs(box.upper_z)});
  columns_.fill({kFarOnRay, -kFarOnRay});
}

// The columns that an interval touches.
CellExtent::Span CellExtent::span_of(float from, float to, float low, float size) const {
  const auto index = [&](float at) {
    return static_cast<int>(std::clamp(std::floor((at - low) / size), 0.0f, static_cast<float>(kAcross - 1)));
  };
  return {index(from - margin_), index(to + margin_)};
}

void CellExtent::add(const RTCBounds& box) {
  const Span x = span_of(box.lower_x, box.upper_x, box_.lower_x, width_),
             y = span_of(box.lower_y, box.upper_y, box_.lower_y, depth_);
  for (int i = x.first; i <= x.last; ++i)
    for (int j = y.first; j <= y.last; ++j) {
      Column& column = columns_[static_cast<std::size_t>(i * kAcross + j)];
      column.low = std::min(column.low, box.lower_z), column.high = std::max(column.high, box.upper_z);
    }
}

bool CellExtent::may_meet(const RTCRay& ray) const {
  RayInterval inside{ray.tnear, ray.tfar};
  inside.cut(ray.org_x, ray.dir_x, box_.lower_x - margin_, box_.upper_x + margin_);
  inside.cut(ray.org_y, ray.dir_y, box_.lower_y - margin_, box_.upper_y + margin_);
  inside.cut(ray.org_z, ray.dir_z, box_.lower_z - margin_, box_.upper_z + margin_);
  if (!(inside.from <= inside.to)) return false;
  const auto between = [](double origin, double direction, const RayInterval& s, auto take) {
    const double a = origin + s.from * direction, b = origin + s.to * direction;
    return take(static_cast<float>(std::min(a, b)), static_cast<float>(std::max(a, b)));
  };
  const Span rows =
      between(ray.org_x, ray.dir_x, inside, [&](float a, float b) { return span_of(a, b, box_.lower_x, width_); });
  for (int i = rows.first; i <= rows.last; ++i) {
    RayInterval row = inside;
    row.cut(ray.org_x, ray.dir_x, box_.lower_x + i * width_ - 2 * margin_,
            box_.lower_x + (i + 1) * width_ + 2 * margin_);
    if (!(row.from <= row.to)) continue;
    const Span cells =
        between(ray.org_y, ray.dir_y, row, [&](float a, float b) { return span_of(a, b, box_.lower_y, depth_); });
    for (int j = cells.first; j <= cells.last; ++j) {
      const Column& column = columns_[static_cast<std::size_t>(i * kAcross + j)];
      RayInterval met = row;
      met.cut(ray.org_y, ray.dir_y, box_.lower_y + j * depth_ - 2 * margin_,
              box_.lower_y + (j + 1) * depth_ + 2 * margin_);
      met.cut(ray.org_z, ray.dir_z, column.low - margin_, column.high + margin_);
      if (met.from <= met.to) return true;
    }
  }
  return false;
}

}  // namespace citykiln::preview
