#include "compiler/geometry/polygons/straight_skeleton.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Straight_skeleton_builder_2.h>

#include <exception>
#include <map>
#include <span>

#include "compiler/geometry/ring_crossing.h"

namespace citykiln {
namespace {

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

// Coordinates as doubles. A lazy exact number must be made exact first: else its double depends on earlier evaluations.
double value(double v) { return v; }
double value(const Exact::FT& v) { return CGAL::to_double(v.exact()); }

template <typename Kernel>
std::vector<typename Kernel::Point_2> cgal_points(const Ring& ring, Vec2 origin) {
  std::vector<typename Kernel::Point_2> points;
  for (const Vec2 p : ring) points.push_back({p.x - origin.x, p.y - origin.y});
  return points;
}

// Events processed by CGAL so far.
struct Progress {
  std::size_t events = 0, most_events = 0;
  bool is_swept = false;
};

struct Stopped : std::exception {};

// CGAL can loop forever on skeletons that its own rounding has made inconsistent: in the sweep, and when it merges
// coincident nodes afterwards. The visitor counts events and stops CGAL before the merge; callers snap faces to a grid,
// which merges the nodes.
template <typename Skeleton>
struct Watch : CGAL::Dummy_straight_skeleton_builder_2_visitor<Skeleton> {
  using Vertex = typename Skeleton::Vertex_const_handle;
  Progress* progress = nullptr;

  void count() const {
    if (++progress->events > progress->most_events) throw Stopped();
  }
  void on_edge_event_processed(const Vertex&, const Vertex&, const Vertex&) const { count(); }
  void on_split_event_processed(const Vertex&, const Vertex&, const Vertex&) const { count(); }
  void on_pseudo_split_event_processed(const Vertex&, const Vertex&, const Vertex&, const Vertex&) const { count(); }
  void on_cleanup_started() const {
    progress->is_swept = true;
    throw Stopped();
  }
};

std::size_t corners_of(const Polygon& polygon) {
  std::size_t count = polygon.outer.size();
  for (const Ring& hole : polygon.holes) count += hole.size();
  return count;
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

// Edges by first point, which is unique because rings do not touch.
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

// Empty if the walk around the face does not return to its start.
template <typename FaceHandle>
Ring ring_of_face(FaceHandle face, Vec2 origin, std::size_t most_points) {
  // a face's halfedge is the polygon's edge and points to the edge's end
  const auto first = face->halfedge()->prev();
  Ring ring;
  auto at = first;
  do {
    if (ring.size() > most_points || at->vertex()->has_infinite_time()) return {};
    const auto& p = at->vertex()->point();
    ring.push_back(Vec2{value(p.x()), value(p.y())} + origin);
    at = at->next();
  } while (at != first);
  return ring;
}

// The skeleton at the end of the sweep; nodes may coincide. Null if the sweep was stopped.
template <typename Kernel>
auto swept(const Polygon& polygon, Vec2 origin) {
  using Skeleton = CGAL::Straight_skeleton_2<Kernel>;
  using Traits = CGAL::Straight_skeleton_builder_traits_2<Kernel>;
  Progress progress;
  // each event removes an edge or a reflex corner, and there are no more of these than edges
  progress.most_events = 4 * corners_of(polygon);
  Watch<Skeleton> watch;
  watch.progress = &progress;
  CGAL::Straight_skeleton_builder_2<Traits, Skeleton, Watch<Skeleton>> builder(boost::none, Traits(), watch);
  const auto enter = [&](const Ring& ring) {
    const auto points = cgal_points<Kernel>(ring, origin);
    builder.enter_contour(points.begin(), points.end());
  };
  enter(polygon.outer);
  for (const Ring& hole : polygon.holes) enter(hole);
  const auto skeleton = builder.construct_skeleton(false);
  return progress.is_swept ? skeleton : decltype(skeleton)();
}

template <typename Kernel>
std::vector<SkeletonFace> faces_of(const Polygon& polygon) {
  // coordinates near the origin keep more digits
  const Vec2 origin = polygon.outer.front();
  const auto skeleton = swept<Kernel>(polygon, origin);
  if (!skeleton) return {};
  EdgeByStart edges = edges_of(polygon);
  for (auto face = skeleton->faces_begin(); face != skeleton->faces_end(); ++face) {
    Ring ring = ring_of_face(face, origin, 8 * corners_of(polygon));
    const auto edge = ring.empty() ? edges.end() : edges.find(ring.front());
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
  // CGAL throws when its own invariants fail
  try {
    auto faces = kernel == SkeletonKernel::kExact ? faces_of<Exact>(polygon) : faces_of<Inexact>(polygon);
    return are_whole(faces) ? faces : std::vector<SkeletonFace>{};
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace citykiln
