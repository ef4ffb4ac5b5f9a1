#include "compiler/geometry/oriented_rect.h"

#include <cmath>
#include <utility>

namespace citykiln {
namespace {

// Half of the extent of a rectangle in a direction.
double half_extent_m(const OrientedRect& rect, Vec2 direction) {
  return std::abs(dot(rect.ahead, direction)) * rect.length_m / 2 +
         std::abs(cross(rect.ahead, direction)) * rect.width_m / 2;
}

}  // namespace

std::array<Vec2, 4> corners_of(const OrientedRect& rect) {
  const Vec2 along = rect.ahead * (rect.length_m / 2), left = left_of(rect.ahead) * (rect.width_m / 2);
  return {rect.at - along - left, rect.at + along - left, rect.at + along + left, rect.at - along + left};
}

Box2 box_of(const OrientedRect& rect) {
  Box2 box;
  for (const Vec2 corner : corners_of(rect)) box.grow(corner);
  return box;
}

bool overlap(const OrientedRect& a, const OrientedRect& b, double border_m) {
  for (const Vec2 axis : {a.ahead, left_of(a.ahead), b.ahead, left_of(b.ahead)})
    if (std::abs(dot(b.at - a.at, axis)) >= half_extent_m(a, axis) + half_extent_m(b, axis) - border_m) return false;
  return true;
}

RectIndex index_rects(std::vector<OrientedRect> all) {
  constexpr double kBucket_m = 16;
  RectIndex index{std::move(all), {}};
  std::vector<Box2> boxes;
  for (const OrientedRect& rect : index.all) boxes.push_back(box_of(rect));
  if (!boxes.empty()) index.grid = grid_of(boxes, kBucket_m);
  return index;
}

bool overlaps_any(const RectIndex& rects, const OrientedRect& rect, double border_m) {
  if (rects.all.empty()) return false;
  return any_about(rects.grid, box_of(rect), [&](std::uint32_t i) { return overlap(rects.all[i], rect, border_m); });
}

}  // namespace citykiln
