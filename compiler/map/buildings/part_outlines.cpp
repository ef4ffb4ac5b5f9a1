#include "compiler/map/buildings/part_outlines.h"

#include <tuple>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/triangles/triangulate.h"

namespace citykiln::map {
namespace {

// About a town block.
constexpr double kPartBucket_m = 64;

Vec2 centre_of_largest_triangle(const Polygon& polygon) {
  const PlaneTriangles t = triangulate(polygon);
  double largest = 0;
  Vec2 centre = polygon.outer.front();
  for (const auto& [ia, ib, ic] : t.triangles) {
    const Vec2 a = t.points[ia], b = t.points[ib], c = t.points[ic];
    if (cross(b - a, c - a) <= largest) continue;
    largest = cross(b - a, c - a);
    centre = (a + b + c) * (1 / 3.0);
  }
  return centre;
}

}  // namespace

std::vector<std::uint32_t> part_outlines(std::span<const Footprint> footprints) {
  std::vector<std::uint32_t> wholes;
  std::vector<Box2> boxes;
  for (std::uint32_t i = 0; i < footprints.size(); ++i)
    if (!footprints[i].is_part) wholes.push_back(i), boxes.push_back(box_of(footprints[i].polygon.outer));
  const BoxGrid grid = grid_of(boxes, kPartBucket_m);
  std::vector<std::uint32_t> outlines(footprints.size(), kNoOutline);
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (!footprints[i].is_part || footprints[i].polygon.outer.size() < 3) continue;
    const Vec2 inside = centre_of_largest_triangle(footprints[i].polygon);
    auto smallest = std::tuple(0.0, ObjectId{}, kNoOutline);
    for (const std::uint32_t near : boxes_about(grid, inside)) {
      const Footprint& outline = footprints[wholes[near]];
      if (!boxes[near].contains(inside) || !contains(outline.polygon, inside)) continue;
      const auto candidate = std::tuple(area_m2(outline.polygon), outline.id, wholes[near]);
      if (std::get<2>(smallest) == kNoOutline || candidate < smallest) smallest = candidate;
    }
    outlines[i] = std::get<2>(smallest);
  }
  return outlines;
}

}  // namespace citykiln::map
