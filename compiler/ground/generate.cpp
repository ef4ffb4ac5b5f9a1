#include "compiler/ground/generate.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "compiler/ground/cover/partition.h"
#include "compiler/ground/cover/simplify_borders.h"
#include "compiler/ground/grading/bend_points.h"
#include "compiler/ground/grading/grading_lines.h"
#include "compiler/ground/mesh/layered_mesh.h"
#include "compiler/ground/mesh/reference_edges.h"
#include "compiler/ground/mesh/refine.h"
#include "compiler/ground/mesh/refine_reference.h"
#include "compiler/ground/mesh/split_borders.h"

namespace citykiln::ground {
namespace {

// Near places that are off, borders are split this many times finer than the heights' tolerance.
constexpr double kFinestBorders = 8;

// The cell's border is split at this share of the tolerance. A vertex close to a border that is off by a, where the
// border is off by b, leaves an edge between them that is off by at most a + b: two halves are the tolerance.
constexpr double kCellBorderShare = 0.5;

// Where a wall meets the cell's border, the ground rises by up to 6 cm with each grid step, and edges of the reference
// end 16 steps before a vertex that the border does not have. Below this tolerance that uses up what the border leaves,
// so the border is split at a smaller share. Coarser levels would get 0.5 % more triangles.
constexpr double kWallsMatter_m = 0.25, kShareWithWalls = 0.25;

// The shares of the tolerance that borders may move in plan and that merged faces may be thick: together 0.7, so that
// √(1 - 0.7²) ≈ 0.7 is left for heights.
constexpr double kBorderShare = 0.5, kSliverShare = 0.2;

// Borders are straightened by this much when a cell is prepared, to be simplified faster for each level: snapping moved
// their points by up to 0.7 grid steps off the straight lines that they split. Levels whose tolerance is not much
// larger begin with the borders as they are.
constexpr double kStraightened_m = 2 * kQuantum_m, kStraightShare = 0.1;

// A mesh that is off gets edges of the reference at most so many times: where they push other faces aside, these can be
// off in turn.
constexpr int kEdgeRounds = 12;

// How often a mesh is made at most before it gets only edges of the reference, and how far around faces that are off
// borders become finer.
constexpr int kFinerRounds = 5;
constexpr double kBesideOff_m = 0.25;

[[maybe_unused]] bool is_whole(const Box2& cell) {
  const auto is_integer = [](double x) { return x == std::floor(x); };
  return !cell.is_empty() && is_integer(cell.min.x) && is_integer(cell.min.y) && is_integer(cell.max.x) &&
         is_integer(cell.max.y);
}

std::vector<FaceHeight> face_heights_of(std::span<const LandCoverPolygon> surfaces) {
  std::vector<FaceHeight> heights;
  for (const LandCoverPolygon& surface : surfaces) heights.push_back(face_height_of(surface));
  return heights;
}

std::vector<FaceHeight> face_heights(std::span<const std::uint32_t> face_cover, std::span<const FaceHeight> heights) {
  std::vector<FaceHeight> of_faces;
  for (const std::uint32_t surface : face_cover)
    of_faces.push_back(surface == kNoLandCover ? FaceHeight{} : heights[surface]);
  return of_faces;
}

double cell_border_m(double side_m) { return side_m * (side_m < kWallsMatter_m ? kShareWithWalls : kCellBorderShare); }

SideTolerances cell_border_m(const SideTolerances& s) {
  return {cell_border_m(s.west_m), cell_border_m(s.east_m), cell_border_m(s.south_m), cell_border_m(s.north_m)};
}

// Borders after thin faces are merged and the rest simplified; none moved by more than the error.
struct SimplerBorders {
  std::vector<Border> borders;
  double error_m;
};

// Boxes about places where heights are off: borders there are not simplified.
using Boxes = std::vector<Box2>;

bool any_contains(const Boxes& boxes, Vec2 p) {
  return std::ranges::any_of(boxes, [&](const Box2& box) { return box.contains(p); });
}

bool any_touches(const Boxes& boxes, const Border& border) {
  const Box2 own = box_of_segment(plane_point(border.a), plane_point(border.b));
  return std::ranges::any_of(boxes, [&](const Box2& box) { return box.touches(own); });
}

// Returns whether a face between borders has a corner in one of the boxes.
bool any_touches(const Boxes& boxes, const CoverFace& face, const Delaunay& net) {
  return std::ranges::any_of(face.faces, [&](std::uint32_t f) {
    return std::ranges::any_of(net.faces()[f].vertices,
                               [&](std::uint32_t v) { return any_contains(boxes, plane_point(net.vertices()[v])); });
  });
}

// @param between   The faces to begin with.
// @param before_m  By how much their borders have moved.
SimplerBorders simpler_borders(const CoverFaces& between, double before_m, double tolerance_m, const Boxes& kept) {
  const auto may_merge = [&](const CoverFace& face) { return kept.empty() || !any_touches(kept, face, between.net); };
  const auto is_pinned = [&](GridPoint p) { return any_contains(kept, plane_point(p)); };
  MergedSlivers merged = merge_slivers(between, kSliverShare * tolerance_m, may_merge);
  SimplifiedBorders simplified = simplify_borders(merged.borders, kBorderShare * tolerance_m, is_pinned);
  return {std::move(simplified.borders), before_m + merged.error_m + simplified.error_m};
}

// @param kept  If there are any, borders in them stay as they are.
SimplerBorders simpler_borders(const PreparedCell& prepared, double tolerance_m, const Boxes& kept) {
  if (kept.empty() && prepared.straightened_m <= kStraightShare * tolerance_m)
    return simpler_borders(prepared.faces_between_borders, prepared.straightened_m, tolerance_m, kept);
  return simpler_borders(faces_between(prepared.borders), 0, tolerance_m, kept);
}

// The height tolerances of the cell's border, of borders inside and of faces.
struct HeightTolerances {
  SideTolerances cell_border_m;
  double borders_m, faces_m;
};

using GridLines = std::vector<std::pair<GridPoint, GridPoint>>;

// Partitions the cell along borders that are split where the ground bends, and along further lines.
// @param lines  Edges of the reference. If there are any, nothing is rounded, or these edges would be bent off it.
Partition partition_along(const Reference& reference, std::span<const Border> whole, const SplitBorders& bent,
                          const GridLines& lines) {
  std::optional<Partition> all;
  if (!lines.empty()) all = partition_of_borders(bent.borders, bent.points, reference.cell, lines, Rounding::kNone);
  if (!all) all = partition_of_borders(bent.borders, bent.points, reference.cell, lines, Rounding::kInside);
  // rounded points have made borders cross at the cell's border; whole ones meet only at their ends
  if (!all) all = partition_of_borders(whole, bent.points, reference.cell, {}, Rounding::kInside);
  assert(all);
  return std::move(*all);
}

// Splits borders where the ground bends, more finely near the boxes.
SplitBorders split_finely(const Reference& reference, std::span<const Border> borders,
                          std::span<const FaceHeight> heights, const HeightTolerances& tolerances, const Boxes& finer) {
  std::vector<Border> sorted(borders.begin(), borders.end());
  const auto first_near = std::stable_partition(sorted.begin(), sorted.end(), [&](const Border& border) {
    return border.is_cell_border || !any_touches(finer, border);
  });
  const std::span<const Border> far(sorted.begin(), first_near);
  const std::span<const Border> near(first_near, sorted.end());
  SplitBorders bent = split_borders(reference, far, heights, tolerances.cell_border_m, tolerances.borders_m);
  const SplitBorders fine =
      split_borders(reference, near, heights, tolerances.cell_border_m, tolerances.borders_m / kFinestBorders);
  bent.borders.insert(bent.borders.end(), fine.borders.begin(), fine.borders.end());
  return bent;
}

// Splits the borders where the ground bends, triangulates them with further lines and refines the faces.
Refined refined_to(const Reference& reference, std::span<const Border> borders, std::span<const FaceHeight> heights,
                   const HeightTolerances& tolerances, const GridLines& lines, const Boxes& finer) {
  const SplitBorders bent = split_finely(reference, borders, heights, tolerances, finer);
  Partition seen = partition_along(reference, borders, bent, lines);
  std::vector<FaceHeight> of_faces = face_heights(seen.face_cover, heights);
  return refine(std::move(seen), std::move(of_faces), reference, tolerances.faces_m);
}

Reference reference_on(Partition&& all, std::span<const FaceHeight> heights, const GradedHeights& cache,
                       const Box2& cell) {
  RefinedReference refined = refine_reference(std::move(all), heights, cache);
  return reference_of(std::move(refined.triangulation), std::move(refined.heights), cell);
}

// Without grading the terrain itself is the reference; its grid lines matter only on the cell's border.
std::vector<Border> ungraded_borders(const NearbyCover& layers, GradedHeights& cache, const Box2& cell) {
  if (layers.order.empty()) return empty_cell_borders(cell);
  const Partition all = partition_all_rings(layers, lines_near_border(grading_lines(cache, cell), cell), {}, cell);
  return visible_borders(all, ring_joints(layers, all.arrangement, cell));
}

// Returns the prepared cell without pieces of its border.
PreparedCell prepared_of(std::vector<FaceHeight>&& heights, std::vector<Border>&& borders, Reference&& reference) {
  const SimplifiedBorders straight = simplify_borders(borders, kStraightened_m, [](GridPoint) { return false; });
  return {std::move(heights),  std::move(borders), faces_between(straight.borders), straight.error_m, {},
          std::move(reference)};
}

// A cell's mesh before it gets its layers, and how far its borders moved in plan.
struct Simplified {
  Refined refined;
  double border_error_m = 0;
};

double height_tolerance_m(double tolerance_m, double border_error_m) {
  return std::sqrt(tolerance_m * tolerance_m - border_error_m * border_error_m);
}

bool keeps(const Simplified& cell, double tolerance_m) {
  return cell.refined.error_m <= height_tolerance_m(tolerance_m, cell.border_error_m);
}

double error_m_of(const Simplified& cell) { return length(Vec2{cell.refined.error_m, cell.border_error_m}); }

void keep_better(Refined& best, Refined&& other) {
  if (other.error_m < best.error_m) best = std::move(other);
}

// The edges of the reference about the faces that are off.
GridLines edges_about_errors(const Reference& reference, const Refined& refined) {
  const std::vector<GridPoint>& vertices = refined.triangulation.vertices();
  std::vector<std::array<GridPoint, 3>> triangles;
  for (const std::uint32_t f : refined.off) {
    const auto& v = refined.triangulation.faces()[f].vertices;
    triangles.push_back({vertices[v[0]], vertices[v[1]], vertices[v[2]]});
  }
  return edges_about(reference, triangles, points_on_border(vertices, reference.cell));
}

// Adds to sorted lines; returns whether any is new.
bool add_lines(GridLines& lines, const GridLines& more) {
  GridLines all;
  std::ranges::set_union(lines, more, std::back_inserter(all));
  const bool any_new = all.size() > lines.size();
  lines = std::move(all);
  return any_new;
}

// Adds the boxes about faces that are off.
void add_boxes(Boxes& boxes, const Refined& refined) {
  const std::vector<GridPoint>& vertices = refined.triangulation.vertices();
  for (const std::uint32_t f : refined.off) {
    Box2 box;
    for (const std::uint32_t v : refined.triangulation.faces()[f].vertices) box.grow(plane_point(vertices[v]));
    boxes.push_back(box.widened(kBesideOff_m));
  }
}

// The needs of a cell's next mesh, by the faces of earlier meshes that were off.
struct Finer {
  Boxes boxes;      // about the faces that were off: borders there are split finely
  Boxes whole;      // borders there are not simplified either
  GridLines lines;  // edges of the reference
};

// Borders are split more finely first. If that did not suffice, they are not simplified either, and edges of the
// reference are added.
void make_finer(Finer& finer, const Reference& reference, const Refined& refined) {
  if (refined.off.empty()) return;
  const bool is_first = finer.boxes.empty();
  add_boxes(finer.boxes, refined);
  if (is_first) return;
  finer.whole = finer.boxes;
  add_lines(finer.lines, edges_about_errors(reference, refined));
}

// Where a border is off by nearly the tolerance, a sliver beside it can be off by more and too thin for a further
// vertex. A border that moves off a step in the ground leaves the step in a face, which may have no room for a vertex
// on it. So borders become finer near faces that are off, round by round. The cell's border does not: its vertices are
// the neighbour's too.
Simplified simplified_to(const PreparedCell& prepared, double tolerance_m, const SideTolerances& sides_m) {
  Finer finer;
  SimplerBorders simpler = simpler_borders(prepared, tolerance_m, {});
  const auto refine_borders = [&] {
    const double height_m = height_tolerance_m(tolerance_m, simpler.error_m);
    const HeightTolerances tolerances{cell_border_m(sides_m), height_m, height_m};
    return Simplified{
        refined_to(prepared.reference, simpler.borders, prepared.heights, tolerances, finer.lines, finer.boxes),
        simpler.error_m};
  };
  Simplified best = refine_borders();
  make_finer(finer, prepared.reference, best.refined);
  for (int round = 1; round < kFinerRounds && !keeps(best, tolerance_m); ++round) {
    if (!finer.whole.empty()) simpler = simpler_borders(prepared, tolerance_m, finer.whole);
    Simplified next = refine_borders();
    make_finer(finer, prepared.reference, next.refined);
    if (error_m_of(next) < error_m_of(best)) best = std::move(next);
  }
  return best;
}

// Where there is no room for a vertex, as on steps of the ground, the mesh gets the reference's own edges, round by
// round, as they push others aside. Borders are not simplified: so they meet these edges at the reference's vertices.
Simplified along_reference(const PreparedCell& prepared, double tolerance_m, const SideTolerances& sides_m) {
  const SimplerBorders whole = simpler_borders(faces_between(prepared.borders), 0, 0, {});
  GridLines lines;
  const auto refine_along_lines = [&] {
    return refined_to(prepared.reference, whole.borders, prepared.heights,
                      {cell_border_m(sides_m), tolerance_m / kFinestBorders, tolerance_m}, lines, {});
  };
  Simplified cell{refine_along_lines(), whole.error_m};
  GridLines more = edges_about_errors(prepared.reference, cell.refined);
  for (int round = 0; round < kEdgeRounds && !keeps(cell, tolerance_m) && add_lines(lines, more); ++round) {
    Refined next = refine_along_lines();
    more = edges_about_errors(prepared.reference, next);
    keep_better(cell.refined, std::move(next));
  }
  return cell;
}

}  // namespace

Reference reference_of_cell(std::span<const LandCoverPolygon> surfaces, const GradedTerrain& graded, const Box2& cell) {
  assert(is_whole(cell));
  if (!has_grading(graded, cell)) return reference_of(graded.terrain, cell);
  return prepare_cell(surfaces, graded, cell).reference;
}

PreparedCell prepare_cell(std::span<const LandCoverPolygon> surfaces, const GradedTerrain& graded, const Box2& cell) {
  assert(is_whole(cell));
  std::vector<FaceHeight> heights = face_heights_of(surfaces);
  GradedHeights cache(graded);
  const std::vector<LandCoverPolygon> bent = rings_with_bends(surfaces, cache, cell);
  const NearbyCover layers = land_cover_near(bent, cell);
  if (!has_grading(graded, cell))
    return prepared_of(std::move(heights), ungraded_borders(layers, cache, cell), reference_of(graded.terrain, cell));
  const auto lines = grading_lines(cache, cell);
  const std::vector<GridPoint> points = bend_points_on_border(cache, cell);
  Partition all = partition_all_rings(layers, lines, points, cell);
  std::vector<Border> borders = visible_borders(all, ring_joints(layers, all.arrangement, cell));
  std::vector<CellBorderPiece> cell_border = cell_border_pieces(layers, lines, points, all.arrangement, cell);
  Reference reference = reference_on(std::move(all), heights, cache, cell);
  PreparedCell prepared = prepared_of(std::move(heights), std::move(borders), std::move(reference));
  prepared.cell_border = std::move(cell_border);
  return prepared;
}

GroundMesh generate_cell(std::span<const LandCoverPolygon> surfaces, const GradedTerrain& graded, const Box2& cell,
                         double tolerance_m, Report& report) {
  GradedNormals normals(graded);
  return generate_cell(prepare_cell(surfaces, graded, cell), normals, tolerance_m, report);
}

GroundMesh generate_cell(const PreparedCell& prepared, GradedNormals& normals, double tolerance_m, Report& report) {
  return generate_cell(prepared, normals, tolerance_m, all_sides(tolerance_m), report);
}

GroundMesh generate_cell(const PreparedCell& prepared, GradedNormals& normals, double tolerance_m,
                         const SideTolerances& sides_m, Report& report) {
  assert(tolerance_m > 0);
  assert(std::min({sides_m.west_m, sides_m.east_m, sides_m.south_m, sides_m.north_m}) > 0);
  Simplified best = simplified_to(prepared, tolerance_m, sides_m);
  if (!keeps(best, tolerance_m)) {
    Simplified exact = along_reference(prepared, tolerance_m, sides_m);
    if (error_m_of(exact) < error_m_of(best)) best = std::move(exact);
  }
  if (!keeps(best, tolerance_m))
    report.add_at(Code::kToleranceNotMet, {best.refined.worst.x, best.refined.worst.y}, best.refined.error_m);
  GroundMesh ground = layered_mesh(best.refined, normals, prepared.heights, prepared.cell_border);
  ground.border_error_m = best.border_error_m;
  return ground;
}

}  // namespace citykiln::ground
