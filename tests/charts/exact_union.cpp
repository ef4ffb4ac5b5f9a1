#include "tests/charts/exact_union.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cassert>

#include "compiler/geometry/snap.h"

namespace citykiln::charts {
namespace {

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalPolygon = CGAL::Polygon_2<ExactKernel>;

Ring rounded(const CgalPolygon& polygon, double step_m) {
  Ring ring;
  for (const ExactKernel::Point_2& p : polygon.container())
    ring.push_back(snapped_to(step_m, Vec2{CGAL::to_double(p.x()), CGAL::to_double(p.y())}));
  return ring;
}

}  // namespace

std::vector<Polygon> exact_union(std::span<const Ring> rings, double step_m) {
  assert(step_m > 0);
  CGAL::Polygon_set_2<ExactKernel> all;
  for (const Ring& ring : rings) {
    CgalPolygon polygon;
    for (const Vec2 p : ring) polygon.push_back({p.x, p.y});
    if (polygon.is_simple() && polygon.is_counterclockwise_oriented()) all.join(polygon);
  }
  std::vector<CGAL::Polygon_with_holes_2<ExactKernel>> united;
  all.polygons_with_holes(std::back_inserter(united));
  std::vector<Polygon> polygons;
  for (const auto& polygon : united) {
    Polygon& out = polygons.emplace_back(Polygon{rounded(polygon.outer_boundary(), step_m), {}});
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
      out.holes.push_back(rounded(*hole, step_m));
  }
  return polygons;
}

}  // namespace citykiln::charts
