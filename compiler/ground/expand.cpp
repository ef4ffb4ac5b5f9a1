// Garland and Heckbert, "Fast polygonal approximation of terrains and height fields", CMU-CS-95-181, 1995 (greedy insertion). Where we differ: the
// triangulation is constrained by class borders, and the error is taken at every vertex of the overlay of mesh and field, not at samples alone.
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

// One planar partition of the cell: its edges, its triangles, and what covers each of them (an index into the surfaces, or kNoSurface).
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
    if (std::any_of(rings.begin(), rings.end(), [&](const Ring& ring) { return box_of(ring).touches(reach); })) layers.order.push_back(i);
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

// The borders that are seen, each with what lies to its left and right, and the cell's own border.
struct Borders {
  std::vector<std::pair<GridPoint, GridPoint>> edges;
  std::vector<OwnedSegment> segments;  // owners: number of the surface in `surfaces`, see owner_of
  std::vector<std::uint32_t> surfaces; // sorted
};

std::uint32_t owner_of(const Borders& borders, std::uint32_t surface) {
  return static_cast<std::uint32_t>(std::lower_bound(borders.surfaces.begin(), borders.surfaces.end(), surface) - borders.surfaces.begin());
}

Borders seen_borders(const Partition& all) {
  Borders borders;
  borders.surfaces = all.face_surface;
  std::sort(borders.surfaces.begin(), borders.surfaces.end());
  borders.surfaces.erase(std::unique(borders.surfaces.begin(), borders.surfaces.end()), borders.surfaces.end());
  const auto& faces = all.triangulation.faces();
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t beyond = faces[f].neighbours[i];
      // inner edges once; the hull's edges have one face anyway
      if (!faces[f].is_constrained[i] || (beyond != kNoFace && beyond < f)) continue;
      const GridPoint a = all.triangulation.vertices()[faces[f].vertices[(i + 1) % 3]], b = all.triangulation.vertices()[faces[f].vertices[(i + 2) % 3]];
      if (beyond == kNoFace) {
        borders.edges.emplace_back(a, b);
      } else if (all.face_surface[f] != all.face_surface[beyond]) {
        borders.edges.emplace_back(a, b);
        borders.segments.push_back({a, b, owner_of(borders, all.face_surface[f]), 1});
        borders.segments.push_back({a, b, owner_of(borders, all.face_surface[beyond]), -1});
      }
    }
  return borders;
}

Vec3 on_field(const Heightfield& heights, Vec2 p) { return at_height(p, snapped(map::height_m_at(heights, p))); }

// Splits an edge until the straight line between its points is nowhere off by more than the tolerance. Depends on the edge and the field alone.
void split_edge(const Heightfield& heights, Vec3 a, Vec3 b, double tolerance_m, std::vector<GridPoint>& points) {
  const WorstPoint worst = worst_on_edge(heights, a, b);
  if (worst.error_m <= tolerance_m) return;
  const Vec3 middle = on_field(heights, snapped(worst.at));
  if (in_plan(middle) == in_plan(a) || in_plan(middle) == in_plan(b)) return;
  points.push_back(grid_point(in_plan(middle)));
  split_edge(heights, a, middle, tolerance_m, points);
  split_edge(heights, middle, b, tolerance_m, points);
}

// Step 3: the points that borders need to follow the field, and all ends, so that none on the cell's border is lost.
std::vector<GridPoint> points_along(const Borders& borders, const Heightfield& heights, double tolerance_m) {
  std::vector<GridPoint> points;
  for (const auto& [p, q] : borders.edges) {
    // from the lower end, so that both cells of a common border split it alike
    const auto [a, b] = std::minmax(p, q);
    points.push_back(a), points.push_back(b);
    split_edge(heights, on_field(heights, plane_point(a)), on_field(heights, plane_point(b)), tolerance_m, points);
  }
  return points;
}

// Only the borders that are seen, split where the height asks for it.
Partition partition_seen(const Partition& all, const Layers& layers, const Heightfield& heights, const Box2& cell, double tolerance_m) {
  const Borders borders = seen_borders(all);
  Arrangement arrangement = arrange(borders.segments, points_along(borders, heights, tolerance_m), cell);
  Delaunay triangulation = triangulated(arrangement);
  const Seed seed = seed_of(triangulation, layers);
  const std::uint32_t on_top = [&] {
    for (const WindingStep& step : seed.windings)
      if (step.winding > 0) return layers.order[step.owner];
    return kNoSurface;
  }();
  std::vector<std::uint32_t> ranks(borders.surfaces.size());
  for (std::uint32_t i = 0; i < ranks.size(); ++i) ranks[i] = i;
  KnownFace known{seed.face, {}};
  if (std::binary_search(borders.surfaces.begin(), borders.surfaces.end(), on_top)) known.windings.push_back({owner_of(borders, on_top), 1});
  std::vector<std::uint32_t> top = cover(triangulation, arrangement, known, ranks);
  for (std::uint32_t& owner : top) owner = owner == kNoOwner ? kNoSurface : borders.surfaces[owner];
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
    const std::array<Vec3, 3> corners = {vertices[face.vertices[0]], vertices[face.vertices[1]], vertices[face.vertices[2]]};
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

  // Puts the face's worst point in; the faces that changed.
  std::span<const std::uint32_t> insert_worst(std::uint32_t f) {
    const Vec3 p = on_field(heights, snapped(errors[f].mendable.at));
    const auto changed = triangulation.insert(grid_point(in_plan(p)), f);
    if (changed.empty()) return changed;
    vertices.push_back(p);
    // the new vertex lies inside a region, or on an edge between two faces of one, so all faces about it are of that region
    const std::uint32_t surface = face_surface[f];
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
    for (const std::uint32_t f : growing.insert_worst(worst.face)) measure(f);
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

GroundMesh expand_cell(std::span<const Surface> surfaces, const Heightfield& heights, const Box2& cell, double tolerance_m, Report& report) {
  const Layers layers = layers_near(surfaces, cell);
  const Partition all = partition_all(layers, cell);
  Partition seen = partition_seen(all, layers, heights, cell, tolerance_m);
  Growing growing{heights, seen.triangulation, seen.face_surface, {}, std::vector<FaceError>(seen.face_surface.size())};
  for (const GridPoint p : seen.triangulation.vertices()) growing.vertices.push_back(on_field(heights, plane_point(p)));
  refine(growing, tolerance_m);
  GroundMesh ground = finished(growing);
  if (ground.error_m > tolerance_m) report.add(Code::kToleranceNotMet, {}, ground.error_m);
  return ground;
}

}  // namespace citykiln::ground
