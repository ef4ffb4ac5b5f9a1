// Garland and Heckbert, "Fast polygonal approximation of terrains and height fields", CMU-CS-95-181, 1995 (greedy
// insertion). Differences: the triangulation is constrained by borders; the error is evaluated at every vertex of the
// overlay of mesh and reference, not at samples alone; an edge that is off is flipped where that suffices.
#include "compiler/ground/mesh/refine.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <queue>
#include <tuple>

#include "compiler/geometry/snap.h"

namespace citykiln::ground {
namespace {

// First, errors above this many tolerances are reduced by vertices of the reference alone: edges of faces that will be
// split need not be measured. (Saves a fifth of the time and adds no triangle; below 2, edges come too late.)
constexpr double kFirst = 2;

// Another corner replaces the nearest one if its error is larger by this share of the tolerance.
constexpr double kFartherOff = 0.25;

// A flip that leaves an error above the tolerance is made if it leaves at most this share of it.
constexpr double kBetter = 0.9;

// A face that is less than this wide takes vertices of the reference only: on a cliff a few grid steps wide, others
// would fill the grid and mend nothing.
constexpr double kRoom_m = 3 * kQuantum_m;

// The errors of one face: the largest, and the largest that a further vertex can reduce.
struct FaceError {
  double error_m = 0;
  WorstPoint reducible;
  WorstPoint inside;                  // at vertices of the reference
  std::array<WorstPoint, 3> edges{};  // opposite to each corner
  bool is_inside_known = false, are_edges_known = false;
};

// The growing triangulation: heights of vertices, polygons, layers and errors of faces.
struct Growing {
  const Reference& reference;
  Refined& refined;
  std::vector<FaceError> errors;
  bool looks_at_edges = false;
  std::vector<std::uint32_t> standing{};  // one per vertex: the reference's face that holds it

  void add_vertex(Vec2 p) {
    const Place place = place_at(reference, p);
    refined.heights.push_back(snapped_heights(reference, place));
    standing.push_back(place.face);
  }

  Vec3 at(std::uint32_t vertex, HeightLayer layer) const {
    return at_height(plane_point(refined.triangulation.vertices()[vertex]),
                     layer_height_m(refined.heights[vertex], layer));
  }

  EdgeEnd end_at(std::uint32_t vertex, HeightLayer layer) const { return {at(vertex, layer), standing[vertex]}; }

  HeightLayer layer_of(std::uint32_t f) const { return refined.face_height[f].layer; }

  std::array<Vec3, 3> places_of(const std::array<std::uint32_t, 3>& v, HeightLayer layer) const {
    return {at(v[0], layer), at(v[1], layer), at(v[2], layer)};
  }

  std::array<Vec3, 3> corners_of(std::uint32_t f) const {
    return places_of(refined.triangulation.faces()[f].vertices, layer_of(f));
  }

  // An edge between two triangles of one land cover face may have been measured from the neighbour.
  WorstPoint worst_on(std::uint32_t f, int i) const {
    const DelaunayFace& face = refined.triangulation.faces()[f];
    const std::uint32_t beyond = face.neighbours[i];
    if (beyond != kNoFace && errors[beyond].are_edges_known && refined.face_height[beyond] == refined.face_height[f])
      return errors[beyond].edges[side_towards(beyond, f)];
    const HeightLayer layer = layer_of(f);
    return worst_on_edge(reference, end_at(face.vertices[(i + 1) % 3], layer),
                         end_at(face.vertices[(i + 2) % 3], layer), layer);
  }

  // Returns which edge of a face its neighbour shares.
  int side_towards(std::uint32_t f, std::uint32_t neighbour) const {
    const auto& neighbours = refined.triangulation.faces()[f].neighbours;
    return neighbours[0] == neighbour ? 0 : neighbours[1] == neighbour ? 1 : 2;
  }

  void measure(std::uint32_t f) {
    FaceError& error = errors[f];
    if (refined.face_height[f].level_m) return void(error = {0, {}, {}, {}, true, true});
    if (!error.is_inside_known) error.inside = worst_inside(reference, corners_of(f), layer_of(f));
    error.is_inside_known = true;
    // corners are rounded to the grid by up to half a step
    error.reducible = error.inside, error.error_m = std::max(kQuantum_m / 2, error.inside.error_m);
    if (looks_at_edges) measure_edges(f);
  }

  void measure_edges(std::uint32_t f) {
    FaceError& error = errors[f];
    for (int i = 0; i < 3; ++i) {
      const WorstPoint worst = error.edges[i] = worst_on(f, i);
      error.error_m = std::max(error.error_m, worst.error_m);
      if (!refined.triangulation.faces()[f].is_constrained[i] && worst.error_m > error.reducible.error_m)
        error.reducible = worst;
    }
    error.are_edges_known = true;
  }

  void find_worst(double tolerance_m) {
    for (std::uint32_t f = 0; f < errors.size(); ++f) {
      if (errors[f].error_m > tolerance_m) refined.off.push_back(f);
      if (errors[f].error_m <= refined.error_m) continue;
      const std::array<Vec3, 3> corners = corners_of(f);
      refined.error_m = errors[f].error_m, refined.worst = in_plan(corners[0] + corners[1] + corners[2]) * (1.0 / 3);
    }
  }

  // Returns the face's error at a point inside it.
  double error_at(std::uint32_t f, Vec2 p) const {
    const std::array<Vec3, 3> corners = corners_of(f);
    const Vec3 a = corners[0], u = corners[1] - a, v = corners[2] - a;
    const double area = cross(in_plan(u), in_plan(v));
    const double s = cross(p - in_plan(a), in_plan(v)) / area, t = cross(in_plan(u), p - in_plan(a)) / area;
    return std::abs(a.z + s * u.z + t * v.z - height_m_at(reference, p, layer_of(f)));
  }

  // A point to insert and the face it splits; kNoFace where it is a vertex already, or on a border.
  struct Insertion {
    Vec2 point;
    std::uint32_t face;
  };

  // Returns whether a face is wide enough for further vertices: its least altitude.
  bool has_room(std::uint32_t f) const {
    const std::array<Vec3, 3> c = corners_of(f);
    const double longest_m = std::max({distance(in_plan(c[0]), in_plan(c[1])), distance(in_plan(c[1]), in_plan(c[2])),
                                       distance(in_plan(c[2]), in_plan(c[0]))});
    return cross(in_plan(c[1] - c[0]), in_plan(c[2] - c[0])) >= kRoom_m * longest_m;
  }

  // The face is searched from `near`: rounding, or choosing a better point, may have moved the point out of it.
  Insertion insertion_at(Vec2 at, std::uint32_t near) const {
    const Vec2 point = snapped(at);
    return {point, refined.triangulation.face_to_split(grid_point(point), near)};
  }

  // Returns the worst place, or rather a corner of the reference's piece there: a corner improves all edges about it, a
  // point between corners only one. So corners are preferred even where their own error is small. (A twentieth fewer
  // triangles at small tolerances.)
  Insertion best_insertion(std::uint32_t f, double tolerance_m) const {
    const Vec2 worst = errors[f].reducible.at;
    Insertion best = insertion_at(nearest_vertex(reference, worst), f);
    if (best.point == worst) return best;
    double best_m = best.face == kNoFace ? 0 : error_at(best.face, best.point) + kFartherOff * tolerance_m;
    for (const Vec2 corner : corners_about(reference, worst)) {
      const Insertion other = insertion_at(corner, f);
      const double off_m = other.face == kNoFace ? 0 : error_at(other.face, other.point);
      if (off_m > best_m) best = other, best_m = off_m;
    }
    return best.face == kNoFace && has_room(f) ? insertion_at(worst, f) : best;
  }

  // Returns the edge with the largest error; 3 where it lies inside.
  int worst_edge(std::uint32_t f) const {
    int i = errors[f].are_edges_known ? 0 : 3;
    while (i < 3 && errors[f].edges[i].at != errors[f].reducible.at) ++i;
    return i;
  }

  // An edge may be off because it passes close by a vertex beyond it. A point on this side of the edge makes Delaunay
  // flip it, so that the vertex becomes a corner on this side.
  Insertion insertion_beside(std::uint32_t f) const {
    constexpr double kInwards = 0.125;
    const Vec2 worst = errors[f].reducible.at;
    const int i = worst_edge(f);
    if (i == 3) return {worst, kNoFace};
    const Vec2 apex = plane_point(refined.triangulation.vertices()[refined.triangulation.faces()[f].vertices[i]]);
    return insertion_at(worst + (apex - worst) * kInwards, f);
  }

  // Returns whether a face would be within the tolerance, its edges left out.
  bool fits(const std::array<std::uint32_t, 3>& v, HeightLayer layer, double tolerance_m) const {
    return worst_inside(reference, places_of(v, layer), layer).error_m <= tolerance_m;
  }

  // Returns whether flipping an edge would leave nothing between its four corners off by more than the tolerance.
  bool flip_suffices(std::uint32_t f, int i, double tolerance_m) const {
    const DelaunayFace& face = refined.triangulation.faces()[f];
    const std::uint32_t beyond = face.neighbours[i];
    if (face.is_constrained[i] || beyond == kNoFace) return false;
    const std::uint32_t a = face.vertices[i], b = face.vertices[(i + 1) % 3], c = face.vertices[(i + 2) % 3],
                        d = refined.triangulation.faces()[beyond].vertices[side_towards(beyond, f)];
    const auto& places = refined.triangulation.vertices();
    if (turn(places[a], places[b], places[d]) <= 0 || turn(places[a], places[d], places[c]) <= 0) return false;
    const HeightLayer layer = layer_of(f);
    return worst_on_edge(reference, end_at(a, layer), end_at(d, layer), layer).error_m <= tolerance_m &&
           fits({a, b, d}, layer, tolerance_m) && fits({a, d, c}, layer, tolerance_m);
  }

  std::span<const std::uint32_t> turn_round(std::uint32_t f, int i) {
    const auto changed = refined.triangulation.flip(f, i);
    for (const std::uint32_t c : changed) errors[c].is_inside_known = errors[c].are_edges_known = false;
    return changed;
  }

  // Flips an edge or inserts a point to reduce the face's largest error, or one nearby; where there is no room for a
  // point, as on cliffs one step of the grid wide, a flip that leaves a smaller error. Returns the changed faces; none
  // where nothing helps. Terminates: flips reduce the number of edges and faces that are off, or the largest error of
  // four corners by a factor, and points are new vertices of a finite grid.
  std::span<const std::uint32_t> mend(std::uint32_t f, double tolerance_m) {
    const int edge = worst_edge(f);
    if (edge < 3 && flip_suffices(f, edge, tolerance_m)) return turn_round(f, edge);
    Insertion insertion = best_insertion(f, tolerance_m);
    if (insertion.face == kNoFace && has_room(f)) insertion = insertion_beside(f);
    const auto [p, split] = insertion;
    if (split == kNoFace) {
      const bool helps = edge < 3 && flip_suffices(f, edge, kBetter * errors[f].reducible.error_m);
      return helps ? turn_round(f, edge) : std::span<const std::uint32_t>();
    }
    const std::uint32_t surface = refined.face_cover[split];
    const FaceHeight height = refined.face_height[split];
    const auto changed = refined.triangulation.insert(grid_point(p), split);
    add_vertex(p);
    // the new vertex lies inside a land cover face, or on an edge between two triangles of one, so all triangles about
    // it belong to that face
    const std::size_t count = refined.triangulation.faces().size();
    refined.face_cover.resize(count, surface), refined.face_height.resize(count, height), errors.resize(count);
    for (const std::uint32_t c : changed)
      refined.face_cover[c] = surface, refined.face_height[c] = height,
      errors[c].is_inside_known = errors[c].are_edges_known = false;
    return changed;
  }
};

struct UnsettledFace {
  double error_m;
  std::uint32_t face;
  bool operator<(const UnsettledFace& o) const { return std::tie(error_m, face) < std::tie(o.error_m, o.face); }
};

// Handles the worst face first, until none is off by more than the tolerance or nothing helps.
void grow(Growing& growing, double tolerance_m) {
  std::priority_queue<UnsettledFace> waiting;
  const auto measure = [&](std::uint32_t f) {
    growing.measure(f);
    if (growing.errors[f].reducible.error_m > tolerance_m) waiting.push({growing.errors[f].reducible.error_m, f});
  };
  for (std::uint32_t f = 0; f < growing.errors.size(); ++f) measure(f);
  while (!waiting.empty()) {
    const UnsettledFace worst = waiting.top();
    waiting.pop();
    // stale: measured again since
    if (growing.errors[worst.face].reducible.error_m != worst.error_m) continue;
    const auto changed = growing.mend(worst.face, tolerance_m);
    for (const std::uint32_t f : changed) measure(f);
    // a neighbour changed: this face is handled again
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
  assert(face_height.size() == partition.face_cover.size() && tolerance_m > 0);
  Refined refined{
      std::move(partition.triangulation), std::move(partition.face_cover), std::move(face_height), {}, 0, {}, {}};
  Growing growing{reference, refined, std::vector<FaceError>(refined.face_cover.size())};
  for (const GridPoint p : refined.triangulation.vertices()) growing.add_vertex(plane_point(p));
  grow(growing, kFirst * tolerance_m);
  growing.looks_at_edges = true;
  grow(growing, tolerance_m);
  growing.find_worst(tolerance_m);
  return refined;
}

}  // namespace citykiln::ground
