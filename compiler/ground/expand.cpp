// Garland and Heckbert, "Fast polygonal approximation of terrains and height fields", CMU-CS-95-181, 1995 (greedy
// insertion). Where we differ: the triangulation is constrained by class borders, and the error is taken at every
// vertex of the overlay of mesh and field, not at samples alone.
#include "compiler/ground/expand.h"

#include <algorithm>
#include <queue>

#include "compiler/geometry/arrangement.h"
#include "compiler/geometry/delaunay.h"
#include "compiler/geometry/snap.h"
#include "compiler/ground/cover.h"
#include "compiler/ground/height_error.h"

namespace citykiln::ground {
namespace {

using map::Heightfield;

// How much finer than the tolerance borders are split at most.
constexpr double kFinestBorders = 8;

// The cell's own border is split at this share of the tolerance. A vertex close to a border that is off by a, where the
// border is off by b, leaves an edge between them that is off by at most a + b: two halves are the tolerance.
constexpr double kCellBorderShare = 0.5;

// One planar partition of the cell: its edges, its triangles, and what covers each of them (an index into the surfaces,
// or kNoSurface).
struct Partition {
  Arrangement arrangement;
  Delaunay triangulation;
  std::vector<std::uint32_t> face_surface;
};

// The surfaces whose rings come near the cell, from the top down.
struct Layers {
  std::span<const Surface> surfaces;
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> ranks;  // of each in `order`: 0, 1, 2 …
};

Layers layers_near(std::span<const Surface> surfaces, const Box2& cell) {
  Layers layers{surfaces, {}, {}};
  // what ends a grid step outside may still round onto the border
  const Box2 reach = cell.widened(kQuantum_m);
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
    const auto& rings = surfaces[i].rings;
    if (std::any_of(rings.begin(), rings.end(), [&](const Ring& ring) { return box_of(ring).touches(reach); }))
      layers.order.push_back(i);
  }
  std::sort(layers.order.begin(), layers.order.end(), [&](auto a, auto b) { return covers(surfaces[a], surfaces[b]); });
  for (std::uint32_t i = 0; i < layers.order.size(); ++i) layers.ranks.push_back(i);
  return layers;
}

std::vector<OwnedSegment> segments_of(const Layers& layers) {
  std::vector<OwnedSegment> segments;
  for (std::uint32_t owner = 0; owner < layers.order.size(); ++owner)
    for (const Ring& ring : layers.surfaces[layers.order[owner]].rings)
      for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        segments.push_back({grid_point(ring[j]), grid_point(ring[i]), owner, 1});
  return segments;
}

std::vector<WindingStep> windings_at(const Layers& layers, Vec2 p) {
  std::vector<WindingStep> windings;
  for (std::uint32_t owner = 0; owner < layers.order.size(); ++owner) {
    int winding = 0;
    for (const Ring& ring : layers.surfaces[layers.order[owner]].rings) winding += winding_number(ring, p);
    if (winding != 0) windings.push_back({owner, winding});
  }
  return windings;
}

Delaunay triangulated(const Arrangement& arrangement) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const ArrangedEdge& e : arrangement.edges) edges.emplace_back(e.a, e.b);
  return Delaunay(arrangement.vertices, edges);
}

// A face whose circle is wide enough that no rounding has moved a border across its centre.
struct Seed {
  std::uint32_t face;
  std::vector<WindingStep> windings;  // owners as in the layers
};

Seed seed_of(const Delaunay& triangulation, const Layers& layers) {
  const WidestFace widest = widest_face(triangulation);
  return {widest.face, windings_at(layers, {widest.x * kQuantum_m, widest.y * kQuantum_m})};
}

// Step 1 and 2: everything that is drawn, and what lies on top in each face.
Partition partition_all(const Layers& layers, const Box2& cell) {
  Arrangement arrangement = arrange(segments_of(layers), {}, cell);
  Delaunay triangulation = triangulated(arrangement);
  const Seed seed = seed_of(triangulation, layers);
  std::vector<std::uint32_t> top = cover(triangulation, arrangement, {seed.face, seed.windings}, layers.ranks);
  for (std::uint32_t& owner : top) owner = owner == kNoOwner ? kNoSurface : layers.order[owner];
  return {std::move(arrangement), std::move(triangulation), std::move(top)};
}

// A border that is seen: what lies to its left and right. The cell's own border has nothing on one side, and is not
// between two surfaces.
struct Border {
  GridPoint a, b;  // a < b
  std::uint32_t left, right;
  bool is_cell_border;
};

std::vector<Border> seen_borders(const Partition& all) {
  std::vector<Border> borders;
  const auto& faces = all.triangulation.faces();
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t beyond = faces[f].neighbours[i];
      if (!faces[f].is_constrained[i]) continue;
      const GridPoint a = all.triangulation.vertices()[faces[f].vertices[(i + 1) % 3]],
                      b = all.triangulation.vertices()[faces[f].vertices[(i + 2) % 3]];
      const std::uint32_t left = all.face_surface[f];
      if (beyond == kNoFace) borders.push_back({std::min(a, b), std::max(a, b), left, left, true});
      // an inner edge is met from both sides; the one that sees it from its lower end counts
      else if (a < b && left != all.face_surface[beyond])
        borders.push_back({a, b, left, all.face_surface[beyond], false});
    }
  return borders;
}

// The surfaces that are seen, sorted: the owners of the second arrangement are their places in this list.
std::vector<std::uint32_t> seen_surfaces(const Partition& all) {
  std::vector<std::uint32_t> surfaces = all.face_surface;
  std::sort(surfaces.begin(), surfaces.end());
  surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  return surfaces;
}

std::uint32_t place_in(const std::vector<std::uint32_t>& sorted, std::uint32_t value) {
  return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

Vec3 on_field(const Heightfield& heights, Vec2 p) { return at_height(p, snapped(map::height_m_at(heights, p))); }

// Splits an edge until the straight line between its points is nowhere off by more than the tolerance. Depends on the
// edge and the field alone.
void split_edge(const Heightfield& heights, Vec3 a, Vec3 b, double tolerance_m, std::vector<GridPoint>& points) {
  const WorstPoint worst = worst_on_edge(heights, a, b);
  if (worst.error_m <= tolerance_m) return;
  const Vec3 middle = on_field(heights, snapped(worst.at));
  if (in_plan(middle) == in_plan(a) || in_plan(middle) == in_plan(b)) return;
  points.push_back(grid_point(in_plan(middle)));
  split_edge(heights, a, middle, tolerance_m, points);
  split_edge(heights, middle, b, tolerance_m, points);
}

// Step 3: the borders bent through the points they need to follow the field. Those of the cell stay straight and only
// need the points.
struct Bent {
  std::vector<OwnedSegment> segments;
  std::vector<GridPoint> points;
};

Bent bend_to_field(std::span<const Border> borders, const std::vector<std::uint32_t>& surfaces,
                   const Heightfield& heights, double tolerance_m, double inner_tolerance_m) {
  Bent bent;
  std::vector<GridPoint> path;
  for (const Border& border : borders) {
    // from the lower end, so that both cells of a common border split it alike
    path = {border.a, border.b};
    split_edge(heights, on_field(heights, plane_point(border.a)), on_field(heights, plane_point(border.b)),
               border.is_cell_border ? kCellBorderShare * tolerance_m : inner_tolerance_m, path);
    if (border.is_cell_border) {
      bent.points.insert(bent.points.end(), path.begin(), path.end());
      continue;
    }
    const auto along = [&](GridPoint p) {
      return (p.x - border.a.x) * (border.b.x - border.a.x) + (p.y - border.a.y) * (border.b.y - border.a.y);
    };
    std::sort(path.begin(), path.end(), [&](GridPoint p, GridPoint q) { return along(p) < along(q); });
    for (std::size_t i = 1; i < path.size(); ++i) {
      bent.segments.push_back({path[i - 1], path[i], place_in(surfaces, border.left), 1});
      bent.segments.push_back({path[i - 1], path[i], place_in(surfaces, border.right), -1});
    }
  }
  return bent;
}

// Only the borders that are seen, split where the height asks for it.
Partition partition_seen(const Partition& all, const Layers& layers, const Heightfield& heights, const Box2& cell,
                         double tolerance_m, double inner_tolerance_m) {
  const std::vector<std::uint32_t> surfaces = seen_surfaces(all);
  const Bent bent = bend_to_field(seen_borders(all), surfaces, heights, tolerance_m, inner_tolerance_m);
  Arrangement arrangement = arrange(bent.segments, bent.points, cell);
  Delaunay triangulation = triangulated(arrangement);
  const Seed seed = seed_of(triangulation, layers);
  const std::uint32_t on_top = [&] {
    for (const WindingStep& step : seed.windings)
      if (step.winding > 0) return layers.order[step.owner];
    return kNoSurface;
  }();
  std::vector<std::uint32_t> ranks(surfaces.size());
  for (std::uint32_t i = 0; i < ranks.size(); ++i) ranks[i] = i;
  KnownFace known{seed.face, {}};
  if (std::binary_search(surfaces.begin(), surfaces.end(), on_top))
    known.windings.push_back({place_in(surfaces, on_top), 1});
  std::vector<std::uint32_t> top = cover(triangulation, arrangement, known, ranks);
  for (std::uint32_t& owner : top) owner = owner == kNoOwner ? kNoSurface : surfaces[owner];
  return {std::move(arrangement), std::move(triangulation), std::move(top)};
}

// The errors of one face: the worst of all, and the worst that a further vertex can mend.
struct FaceError {
  double error_m = 0;
  WorstPoint mendable;
};

// A triangulation that grows: heights of its vertices, surfaces and errors of its faces.
struct Growing {
  const Heightfield& heights;
  Delaunay& triangulation;
  std::vector<std::uint32_t>& face_surface;
  std::vector<Vec3> vertices;
  std::vector<FaceError> errors;

  void measure(std::uint32_t f) {
    const DelaunayFace& face = triangulation.faces()[f];
    const std::array<Vec3, 3> corners = {vertices[face.vertices[0]], vertices[face.vertices[1]],
                                         vertices[face.vertices[2]]};
    FaceError& error = errors[f];
    error = {0, worst_inside(heights, corners)};
    for (int i = 0; i < 3; ++i) {
      // from the lower vertex, so that both faces of an edge agree on its worst point
      const auto [a, b] = std::minmax(corners[(i + 1) % 3], corners[(i + 2) % 3]);
      const WorstPoint worst = worst_on_edge(heights, a, b);
      error.error_m = std::max(error.error_m, worst.error_m);
      if (!face.is_constrained[i] && worst.error_m > error.mendable.error_m) error.mendable = worst;
      error.error_m = std::max(error.error_m, std::abs(corners[i].z - map::height_m_at(heights, in_plan(corners[i]))));
    }
    error.error_m = std::max(error.error_m, error.mendable.error_m);
  }

  // How far a face is off a point of the field.
  double error_at(std::uint32_t f, Vec3 p) const {
    const DelaunayFace& face = triangulation.faces()[f];
    const Vec3 a = vertices[face.vertices[0]], u = vertices[face.vertices[1]] - a, v = vertices[face.vertices[2]] - a;
    const double area = cross(in_plan(u), in_plan(v));
    const double s = cross(in_plan(p - a), in_plan(v)) / area, t = cross(in_plan(u), in_plan(p - a)) / area;
    return std::abs(a.z + s * u.z + t * v.z - p.z);
  }

  // A point to put in, and the face it splits: kNoFace where it is a vertex already, or on a border.
  struct Insertion {
    Vec3 point;
    std::uint32_t face;
  };

  // Rounding, or the search for a better point, may have carried it out of the face `near`, and out of its region.
  Insertion insertion_at(Vec2 at, std::uint32_t near) const {
    const Vec3 point = on_field(heights, snapped(at));
    return {point, triangulation.face_to_split(grid_point(in_plan(point)), near)};
  }

  // Where a face is off most. Close by, one of the field's own vertices may be off too far as well: that one mends all
  // edges about it, a point between two of them only one. (A quarter fewer triangles where the tolerance is small.)
  Insertion best_insertion(std::uint32_t f, double tolerance_m) const {
    const Vec2 worst = errors[f].mendable.at;
    const Insertion sample = insertion_at(map::nearest_vertex(heights, worst), f);
    const bool mends = sample.face != kNoFace && error_at(sample.face, sample.point) >= tolerance_m;
    return mends ? sample : insertion_at(worst, f);
  }

  // Puts a point in that mends the face's worst error, or one nearby; the faces that changed. None where nothing can.
  std::span<const std::uint32_t> mend(std::uint32_t f, double tolerance_m) {
    const auto [p, split] = best_insertion(f, tolerance_m);
    if (split == kNoFace) return {};
    const std::uint32_t surface = face_surface[split];
    const auto changed = triangulation.insert(grid_point(in_plan(p)), split);
    vertices.push_back(p);
    // the new vertex lies inside a region, or on an edge between two faces of one, so all faces about it are of that
    // region
    face_surface.resize(triangulation.faces().size(), surface);
    errors.resize(triangulation.faces().size());
    for (const std::uint32_t c : changed) face_surface[c] = surface;
    return changed;
  }
};

// Step 4: the worst face first, until none is off by more than the tolerance or no point can mend it.
void refine(Growing& growing, double tolerance_m) {
  struct Waiting {
    double error_m;
    std::uint32_t face;
    bool operator<(const Waiting& o) const { return std::tie(error_m, face) < std::tie(o.error_m, o.face); }
  };
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

GroundMesh finished(const Growing& growing) {
  GroundMesh ground;
  ground.face_surface = growing.face_surface;
  ground.mesh.positions = growing.vertices;
  for (const Vec3 p : growing.vertices) ground.mesh.normals.push_back(map::normal_at(growing.heights, in_plan(p)));
  for (const DelaunayFace& face : growing.triangulation.faces()) ground.mesh.triangles.push_back(face.vertices);
  for (const FaceError& error : growing.errors) ground.error_m = std::max(ground.error_m, error.error_m);
  return ground;
}

}  // namespace

GroundMesh expand_cell(std::span<const Surface> surfaces, const Heightfield& heights, const Box2& cell,
                       double tolerance_m, Report& report) {
  const Layers layers = layers_near(surfaces, cell);
  const Partition all = partition_all(layers, cell);
  GroundMesh ground;
  // Where a border is off by nearly the tolerance, a sliver beside it can be off by more, too thin for a further
  // vertex: then the borders are split more finely. The cell's own border is not: its vertices are the neighbour's too.
  for (double inner_m = tolerance_m; inner_m >= tolerance_m / kFinestBorders; inner_m /= 2) {
    Partition seen = partition_seen(all, layers, heights, cell, tolerance_m, inner_m);
    Growing growing{
        heights, seen.triangulation, seen.face_surface, {}, std::vector<FaceError>(seen.face_surface.size())};
    for (const GridPoint p : seen.triangulation.vertices())
      growing.vertices.push_back(on_field(heights, plane_point(p)));
    refine(growing, tolerance_m);
    ground = finished(growing);
    if (ground.error_m <= tolerance_m) return ground;
  }
  report.add(Code::kToleranceNotMet, {}, ground.error_m);
  return ground;
}

}  // namespace citykiln::ground
