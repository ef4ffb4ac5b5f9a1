#include "compiler/map/things/outline_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/geometry/line_part.h"

namespace citykiln::map {
namespace {

// Sizes from the map are rounded, so that more things share a mesh.
constexpr double kSizeStep_m = 0.125;

double stretched_m(double row_m, double mapped_m) {
  return mapped_m <= row_m * kMostStretch ? std::max(snapped_to(kSizeStep_m, mapped_m), kSizeStep_m) : row_m;
}

OutlineRectangle rectangle_along(const Ring& ring, Vec2 along) {
  const Vec2 across = left_of(along);
  Box2 box;
  for (const Vec2 p : ring) box.grow({dot(p, along), dot(p, across)});
  const Vec2 size = box.max - box.min, middle = (box.min + box.max) * 0.5;
  return {along * middle.x + across * middle.y, along, size.x, size.y};
}

}  // namespace

OutlineRectangle smallest_rectangle(const Ring& ring) {
  OutlineRectangle smallest;
  double least_m2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 along = unit(ring[(i + 1) % ring.size()] - ring[i]);
    if (along == Vec2{}) continue;
    const OutlineRectangle rectangle = rectangle_along(ring, along);
    if (rectangle.length_m * rectangle.width_m >= least_m2) continue;
    least_m2 = rectangle.length_m * rectangle.width_m, smallest = rectangle;
  }
  return smallest;
}

std::vector<OutlinePlace> places_on_line(const Polyline& line, Stand stand, double width_m, double depth_m) {
  const std::vector<double> along = distances_on(line);
  const double length = along.back();
  const bool touch = width_m >= kCopyDistance_m / 2;
  const double distance_m = touch ? width_m : kCopyDistance_m;
  const double wanted = stand == Stand::kInWay ? std::max(1.0, std::round(length / distance_m)) : 1;
  const auto copies = static_cast<std::size_t>(std::min<double>(wanted, kMostCopies));
  const double each_m = length / static_cast<double>(copies);
  std::vector<OutlinePlace> places;
  for (std::size_t i = 0; i < copies; ++i) {
    const double at_m = (static_cast<double>(i) + 0.5) * each_m;
    const Vec2 from = point_at(line, along, at_m - each_m / 4), to = point_at(line, along, at_m + each_m / 4);
    places.push_back({.at = snapped(point_at(line, along, at_m)),
                      .along = unit(to - from),
                      .width_m = touch ? stretched_m(width_m, each_m) : width_m,
                      .depth_m = depth_m});
  }
  return places;
}

OutlinePlace place_in_area(const Ring& ring, double width_m, double depth_m) {
  OutlineRectangle rectangle = smallest_rectangle(ring);
  if ((rectangle.length_m < rectangle.width_m) != (width_m < depth_m)) {
    std::swap(rectangle.length_m, rectangle.width_m);
    rectangle.along = left_of(rectangle.along);
  }
  const bool fits = rectangle.length_m <= width_m * kMostStretch && rectangle.width_m <= depth_m * kMostStretch;
  return {.at = snapped(rectangle.middle),
          .along = rectangle.along,
          .width_m = fits ? stretched_m(width_m, rectangle.length_m) : width_m,
          .depth_m = fits ? stretched_m(depth_m, rectangle.width_m) : depth_m};
}

}  // namespace citykiln::map
