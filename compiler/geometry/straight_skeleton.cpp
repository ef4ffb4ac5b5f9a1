#include "compiler/geometry/straight_skeleton.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/create_straight_skeleton_2.h>

#include <exception>
#include <map>
#include <span>

#include "compiler/geometry/ring_crossing.h"

namespace citykiln {
namespace {

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

// CGAL's coordinates as doubles; of a lazy exact number, the double depends on who asked before unless it is made exact
double value(double v) { return v; }
double value(const Exact::FT& v) { return CGAL::to_double(v.exact()); }

template <typename Kernel>
CGAL::Polygon_2<Kernel> cgal_ring(const Ring& ring, Vec2 origin) {
  CGAL::Polygon_2<Kernel> made;
  for (const Vec2 p : ring) made.push_back({p.x - origin.x, p.y - origin.y});
  return made;
}

bool are_apart(const Polygon& polygon) {
  if (!is_simple(polygon.outer) || signed_area_m2(polygon.outer) <= 0) return false;
  for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
    const Ring& hole = polygon.holes[i];
    if (!is_simple(hole) || signed_area_m2(hole) >= 0 || borders_touch(polygon.outer, hole)) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (borders_touch(hole, polygon.holes[j])) return false;
  }
  return true;
}

// Every edge by its first point: rings that are apart share none.
using EdgeByStart = std::map<Vec2, SkeletonFace>;

EdgeByStart edges_of(const Polygon& polygon) {
  EdgeByStart edges;
  const auto add = [&](const Ring& ring, std::uint32_t ring_index) {
    for (std::uint32_t i = 0; i < ring.size(); ++i) edges[ring[i]] = {{}, ring_index, i};
  };
  add(polygon.outer, 0);
  for (std::uint32_t h = 0; h < polygon.holes.size(); ++h) add(polygon.holes[h], h + 1);
  return edges;
}

template <typename FaceHandle>
Ring ring_of(FaceHandle face, Vec2 origin) {
  // a face's halfedge is the polygon's edge, and points at its end
  const auto first = face->halfedge()->prev();
  Ring ring;
  auto at = first;
  do {
    const auto& p = at->vertex()->point();
    ring.push_back(Vec2{value(p.x()), value(p.y())} + origin);
    at = at->next();
  } while (at != first);
  return ring;
}

template <typename Kernel>
std::vector<SkeletonFace> faces_of(const Polygon& polygon) {
  // near the origin CGAL's doubles have digits to spare
  const Vec2 origin = polygon.outer.front();
  std::vector<CGAL::Polygon_2<Kernel>> holes;
  for (const Ring& hole : polygon.holes) holes.push_back(cgal_ring<Kernel>(hole, origin));
  const auto outer = cgal_ring<Kernel>(polygon.outer, origin);
  const auto skeleton = CGAL::create_interior_straight_skeleton_2(outer.vertices_begin(), outer.vertices_end(),
                                                                  holes.begin(), holes.end(), Kernel());
  if (!skeleton) return {};
  EdgeByStart edges = edges_of(polygon);
  for (auto face = skeleton->faces_begin(); face != skeleton->faces_end(); ++face) {
    Ring ring = ring_of(face, origin);
    const auto edge = edges.find(ring.front());
    if (edge == edges.end()) return {};
    edge->second.ring = std::move(ring);
  }
  std::vector<SkeletonFace> faces;
  for (auto& [start, face] : edges) faces.push_back(std::move(face));
  std::sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) {
    return std::tie(a.ring_index, a.edge) < std::tie(b.ring_index, b.edge);
  });
  return faces;
}

bool are_whole(const std::vector<SkeletonFace>& faces) {
  for (const SkeletonFace& face : faces)
    if (face.ring.size() < 3) return false;
  return true;
}

}  // namespace

std::vector<SkeletonFace> straight_skeleton(const Polygon& polygon, SkeletonKernel kernel) {
  if (!are_apart(polygon)) return {};
  // CGAL throws where its own conditions do not hold
  try {
    auto faces = kernel == SkeletonKernel::kExact ? faces_of<Exact>(polygon) : faces_of<Inexact>(polygon);
    return are_whole(faces) ? faces : std::vector<SkeletonFace>{};
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace citykiln
