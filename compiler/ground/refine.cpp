// Garland and Heckbert, "Fast polygonal approximation of terrains and height fields", CMU-CS-95-181, 1995 (greedy
// insertion). Where we differ: the triangulation is constrained by class borders, and the error is taken at every
// vertex of the overlay of mesh and reference, not at samples alone.
#include "compiler/ground/refine.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "compiler/geometry/snap.h"

namespace citykiln::ground {
namespace {

// The errors of one face: the worst of all, and the worst that a further vertex can mend.
struct FaceError {
  double error_m = 0;
  WorstPoint mendable;
  std::array<WorstPoint, 3> edges{};  // opposite to each corner
  bool is_known = false;
};

// A triangulation that grows: heights of its vertices, surfaces, layers and errors of its faces.
struct Growing {
  const Reference& reference;
  Refined& refined;
  std::vector<FaceError> errors;
  std::vector<std::uint32_t> standing{};  // one a vertex: the reference's face that holds it

  void add_vertex(Vec2 p) {
    const Place place = place_at(reference, p);
    refined.heights.push_back(snapped_heights(reference, place));
    standing.push_back(place.face);
  }

  Vec3 at(std::uint32_t vertex, HeightLayer layer) const {
    return at_height(plane_point(refined.triangulation.vertices()[vertex]), of(refined.heights[vertex], layer));
  }

  HeightLayer layer_of(std::uint32_t f) const { return refined.face_height[f].layer; }

  std::array<Vec3, 3> corners_of(std::uint32_t f) const {
    const DelaunayFace& face = refined.triangulation.faces()[f];
    const HeightLayer layer = layer_of(f);
    return {at(face.vertices[0], layer), at(face.vertices[1], layer), at(face.vertices[2], layer)};
  }

  // An edge within a region is the neighbour's too, who may have measured it.
  WorstPoint worst_on(std::uint32_t f, int i, const std::array<Vec3, 3>& corners) const {
    const auto& faces = refined.triangulation.faces();
    const std::uint32_t beyond = faces[f].neighbours[i];
    if (beyond != kNoFace && errors[beyond].is_known && refined.face_height[beyond] == refined.face_height[f])
      for (int k = 0; k < 3; ++k)
        if (faces[beyond].neighbours[k] == f) return errors[beyond].edges[k];
    const auto end = [&](int k) { return EdgeEnd{corners[k], standing[faces[f].vertices[k]]}; };
    return worst_on_edge(reference, end((i + 1) % 3), end((i + 2) % 3), layer_of(f));
  }

  void measure(std::uint32_t f) {
    const DelaunayFace& face = refined.triangulation.faces()[f];
    const std::array<Vec3, 3> corners = corners_of(f);
    const HeightLayer layer = layer_of(f);
    FaceError& error = errors[f];
    if (refined.face_height[f].level_m) return void(error = {0, {}, {}, true});
    // corners are rounded to the grid's heights, half a step to either side
    error = {kQuantum_m / 2, worst_inside(reference, corners, layer), {}, true};
    for (int i = 0; i < 3; ++i) {
      const WorstPoint worst = error.edges[i] = worst_on(f, i, corners);
      error.error_m = std::max(error.error_m, worst.error_m);
      if (!face.is_constrained[i] && worst.error_m > error.mendable.error_m) error.mendable = worst;
    }
    error.error_m = std::max(error.error_m, error.mendable.error_m);
  }

  // How far a face is off the reference at a point in it.
  double error_at(std::uint32_t f, Vec2 p) const {
    const std::array<Vec3, 3> corners = corners_of(f);
    const Vec3 a = corners[0], u = corners[1] - a, v = corners[2] - a;
    const double area = cross(in_plan(u), in_plan(v));
    const double s = cross(p - in_plan(a), in_plan(v)) / area, t = cross(in_plan(u), p - in_plan(a)) / area;
    return std::abs(a.z + s * u.z + t * v.z - height_m_at(reference, p, layer_of(f)));
  }

  // A point to put in, and the face it splits: kNoFace where it is a vertex already, or on a border.
  struct Insertion {
    Vec2 point;
    std::uint32_t face;
  };

  // Rounding, or the search for a better point, may have carried it out of the face `near`, and out of its region.
  Insertion insertion_at(Vec2 at, std::uint32_t near) const {
    const Vec2 point = snapped(at);
    return {point, refined.triangulation.face_to_split(grid_point(point), near)};
  }

  // Where a face is off most. Close by, one of the reference's own vertices may be off too far as well: that one mends
  // all edges about it, a point between two of them only one. (A quarter fewer triangles where the tolerance is small.)
  Insertion best_insertion(std::uint32_t f, double tolerance_m) const {
    const Vec2 worst = errors[f].mendable.at;
    const Insertion sample = insertion_at(nearest_vertex(reference, worst), f);
    const bool mends = sample.face != kNoFace && error_at(sample.face, sample.point) >= tolerance_m;
    return mends ? sample : insertion_at(worst, f);
  }

  // Where an edge is off because it passes close by a vertex beyond it: a point this side of the edge makes Delaunay
  // turn the edge round, so that the vertex is a corner on this side too.
  Insertion insertion_beside(std::uint32_t f) const {
    constexpr double kInwards = 0.125;
    const Vec2 worst = errors[f].mendable.at;
    for (int i = 0; i < 3; ++i) {
      if (errors[f].edges[i].at != worst) continue;
      const Vec2 apex = plane_point(refined.triangulation.vertices()[refined.triangulation.faces()[f].vertices[i]]);
      return insertion_at(worst + (apex - worst) * kInwards, f);
    }
    return {worst, kNoFace};
  }

  // Puts a point in that mends the face's worst error, or one nearby; the faces that changed. None where nothing can.
  std::span<const std::uint32_t> mend(std::uint32_t f, double tolerance_m) {
    Insertion insertion = best_insertion(f, tolerance_m);
    if (insertion.face == kNoFace) insertion = insertion_beside(f);
    const auto [p, split] = insertion;
    if (split == kNoFace) return {};
    const std::uint32_t surface = refined.face_surface[split];
    const FaceHeight height = refined.face_height[split];
    const auto changed = refined.triangulation.insert(grid_point(p), split);
    add_vertex(p);
    // the new vertex lies inside a region, or on an edge between two faces of one, so all faces about it are of that
    // region
    const std::size_t count = refined.triangulation.faces().size();
    refined.face_surface.resize(count, surface), refined.face_height.resize(count, height), errors.resize(count);
    for (const std::uint32_t c : changed)
      refined.face_surface[c] = surface, refined.face_height[c] = height, errors[c].is_known = false;
    return changed;
  }
};

struct Waiting {
  double error_m;
  std::uint32_t face;
  bool operator<(const Waiting& o) const { return std::tie(error_m, face) < std::tie(o.error_m, o.face); }
};

// The worst face first, until none is off by more than the tolerance or no point can mend it.
void grow(Growing& growing, double tolerance_m) {
  std::priority_queue<Waiting> waiting;
  const auto measure = [&](std::uint32_t f) {
    growing.measure(f);
    if (growing.errors[f].mendable.error_m > tolerance_m) waiting.push({growing.errors[f].mendable.error_m, f});
  };
  for (std::uint32_t f = 0; f < growing.errors.size(); ++f) measure(f);
  while (!waiting.empty()) {
    const Waiting worst = waiting.top();
    waiting.pop();
    // stale: the face has been measured again since
    if (growing.errors[worst.face].mendable.error_m != worst.error_m) continue;
    const auto changed = growing.mend(worst.face, tolerance_m);
    for (const std::uint32_t f : changed) measure(f);
    // mended beside it: its own turn comes again
    if (!changed.empty() && std::ranges::find(changed, worst.face) == changed.end()) waiting.push(worst);
  }
}

}  // namespace

Heights snapped_heights(const Reference& reference, const Place& place) {
  Heights heights = heights_at(reference, place);
  for (double& height : heights) height = snapped(height);
  return heights;
}

Refined refine(Partition&& partition, std::vector<FaceHeight>&& face_height, const Reference& reference,
               double tolerance_m) {
  Refined refined{std::move(partition.triangulation), std::move(partition.face_surface), std::move(face_height), {}, 0};
  Growing growing{reference, refined, std::vector<FaceError>(refined.face_surface.size())};
  for (const GridPoint p : refined.triangulation.vertices()) growing.add_vertex(plane_point(p));
  grow(growing, tolerance_m);
  for (const FaceError& error : growing.errors) refined.error_m = std::max(refined.error_m, error.error_m);
  return refined;
}

}  // namespace citykiln::ground
