#include "grammars/roofs/raise_facets.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "compiler/contract/disjoint_sets.h"
#include "compiler/geometry/snap.h"
#include "grammars/roofs/plan_cells.h"

namespace citykiln::roofs {
namespace {

// Computes the heights of a roof at the corners of its plan. The plan is divided into cells (triangles) and facets
// (pieces over which the roof is planar); an uncovered cell lies outside of all facets and has the facet of a
// neighbour. Facets with equal Facet::surface meet in height; between two surfaces there may be a wall.

// The heights of all corners of cells, and measures of the misfit of facets.
struct PlanHeights {
  /// By cell and corner: height over the eaves plane, a multiple of 2^-10 m.
  std::vector<std::array<double, 3>> corners_m;
  double uncovered_m2 = 0;   ///< The area of uncovered cells.
  double largest_gap_m = 0;  ///< The largest height difference at a point between facets of one surface.
};

// A corner of a cell; corners with equal point and surface share a height.
struct Corner {
  std::uint32_t point, surface, cell;
  int index;
  bool is_uncovered;
  double z_m;
};

std::vector<Corner> corners_of_plan(const PlanCells& plan, std::span<const Facet> facets) {
  std::vector<Corner> corners;
  corners.reserve(3 * plan.cells.size());
  for (std::uint32_t c = 0; c < plan.cells.size(); ++c) {
    const PlanCell& cell = plan.cells[c];
    const Facet* facet = cell.facet == kNoFacet ? nullptr : &facets[cell.facet];
    for (int i = 0; i < 3; ++i)
      corners.push_back({cell.points[i], facet ? facet->surface : 0, c, i, cell.is_uncovered,
                         facet ? facet->plane.at(plan.points[cell.points[i]]) : 0});
  }
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    return std::tie(a.point, a.surface, a.cell) < std::tie(b.point, b.surface, b.cell);
  });
  return corners;
}

enum class Location : std::uint8_t { kOutside, kInside, kBorder };

// The location of each point relative to the footprint.
std::vector<Location> locations_of(const PlanCells& plan) {
  std::vector<Location> locations(plan.points.size(), Location::kOutside);
  for (const PlanCell& cell : plan.cells)
    for (const std::uint32_t p : cell.points)
      if (cell.is_over_footprint) locations[p] = Location::kInside;
  for (const PlanCell& cell : plan.cells)
    for (int i = 0; i < 3 && cell.is_over_footprint; ++i) {
      const std::uint32_t beyond = cell.neighbours[i];
      if (beyond != kNoFacet && plan.cells[beyond].is_over_footprint) continue;
      locations[cell.points[(i + 1) % 3]] = locations[cell.points[(i + 2) % 3]] = Location::kBorder;
    }
  return locations;
}

double at_least_zero(double z_m, Location location, double flush_m) {
  if (location == Location::kOutside) return z_m;
  return z_m < (location == Location::kBorder ? flush_m : 0) ? 0 : z_m;
}

double uncovered_m2(const PlanCells& plan) {
  double sum = 0;
  for (const PlanCell& cell : plan.cells) {
    const Vec2 a = plan.points[cell.points[0]], b = plan.points[cell.points[1]], c = plan.points[cell.points[2]];
    if (cell.is_uncovered) sum += cross(b - a, c - a) / 2;
  }
  return sum;
}

// The range of some heights.
struct Range {
  double low_m = 0, high_m = 0;
  bool is_empty = true;

  void grow(double z_m) {
    low_m = is_empty ? z_m : std::min(low_m, z_m);
    high_m = is_empty ? z_m : std::max(high_m, z_m);
    is_empty = false;
  }
};

// Returns the heights of all corners. Corners of one surface at one point get one height: the lowest of the surface's
// facets in the covered cells at the point; without covered cells, the lowest in the uncovered cells; 0 without a
// facet. Over the footprint, heights below 0 become 0. O(n log n).
// @param flush_m  On the border of the footprint, heights below this become 0, so that the roof meets the wall.
PlanHeights plan_heights(const PlanCells& plan, std::span<const Facet> facets, double flush_m) {
  PlanHeights heights{std::vector<std::array<double, 3>>(plan.cells.size()), uncovered_m2(plan), 0};
  const std::vector<Corner> corners = corners_of_plan(plan, facets);
  const std::vector<Location> locations = locations_of(plan);
  const auto is_joined = [](const Corner& a, const Corner& b) { return a.point == b.point && a.surface == b.surface; };
  for (std::size_t i = 0, end = 0; i < corners.size(); i = end) {
    Range covered, bare;
    for (end = i; end < corners.size() && is_joined(corners[end], corners[i]); ++end)
      (corners[end].is_uncovered ? bare : covered).grow(corners[end].z_m);
    heights.largest_gap_m = std::max(heights.largest_gap_m, covered.high_m - covered.low_m);
    const double low_m = (covered.is_empty ? bare : covered).low_m;
    const double z_m = at_least_zero(snapped(low_m), locations[corners[i].point], flush_m);
    for (std::size_t k = i; k < end; ++k) heights.corners_m[corners[k].cell][corners[k].index] = z_m;
  }
  return heights;
}

// ---- columns --------------------------------------------------------------------------------------------------------

struct PlanColumns {
  std::vector<Vec2> positions;
  std::vector<std::array<std::uint32_t, 3>> of_corners;  // By cell and corner: index into positions.
};

std::uint32_t corner_at(const PlanCells& plan, std::uint32_t cell, std::uint32_t point) {
  const auto& points = plan.cells[cell].points;
  return 3 * cell + static_cast<std::uint32_t>(std::find(points.begin(), points.end(), point) - points.begin());
}

void join_across(const PlanCells& plan, std::uint32_t cell, int edge, DisjointSets& corners) {
  const std::uint32_t beyond = plan.cells[cell].neighbours[edge];
  if (beyond == kNoFacet || beyond < cell) return;
  for (const int end : {(edge + 1) % 3, (edge + 2) % 3})
    corners.join(3 * cell + end, corner_at(plan, beyond, plan.cells[cell].points[end]));
}

// Finds the columns. Corners at one point share a column if their cells are connected by edges there. O(n α(n)).
PlanColumns plan_columns(const PlanCells& plan) {
  DisjointSets corners(3 * plan.cells.size());
  for (std::uint32_t c = 0; c < plan.cells.size(); ++c)
    for (int edge = 0; edge < 3; ++edge) join_across(plan, c, edge, corners);
  PlanColumns columns;
  columns.of_corners.resize(plan.cells.size());
  std::vector<std::uint32_t> number(corners.size());
  for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
    const std::uint32_t root = corners.find(corner);
    // a root is the lowest of its corners, so it is numbered first
    if (root == corner) {
      number[corner] = static_cast<std::uint32_t>(columns.positions.size());
      columns.positions.push_back(plan.points[plan.cells[corner / 3].points[corner % 3]]);
    }
    columns.of_corners[corner / 3][corner % 3] = number[root];
  }
  return columns;
}

// A vertical segment of a column.
struct Stretch {
  std::uint32_t column;
  double low_m, high_m;
};

// Borders that turn by a smaller sine belong to the same wall: rounding turns them by a grid step per metre.
constexpr double kSameWall = 0.02;

class Builder {
 public:
  Builder(const PlanCells& plan, std::span<const Facet> facets, const PlanHeights& heights, double thickness_m)
      : plan_(plan), facets_(facets), heights_(heights), thickness_m_(thickness_m), columns_(plan_columns(plan)) {
    place_vertices();
    trace_eaves();
    for (std::uint32_t c = 0; c < plan.cells.size(); ++c) {
      cover(c);
      for (int edge = 0; edge < 3; ++edge) wall_off(c, edge);
    }
  }

  Roof take() && { return std::move(roof_); }

 private:
  // a vertex is identified by its column and its height
  using Level = std::pair<std::uint32_t, double>;

  std::uint32_t column(std::uint32_t cell, int corner) const { return columns_.of_corners[cell][corner]; }
  double under_m(std::uint32_t cell, int corner) const { return heights_.corners_m[cell][corner]; }
  double top_m(std::uint32_t cell, int corner) const { return under_m(cell, corner) + thickness_m_; }
  bool is_over_footprint(std::uint32_t cell) const { return cell != kNoFacet && plan_.cells[cell].is_over_footprint; }
  std::uint32_t face_of(std::uint32_t cell) const {
    const std::uint32_t facet = plan_.cells[cell].facet;
    return facet == kNoFacet ? kNoFacet : facets_[facet].face;
  }
  bool is_border(std::uint32_t cell, int edge) const {
    return is_over_footprint(cell) && !is_over_footprint(plan_.cells[cell].neighbours[edge]);
  }

  void place_vertices() {
    for (std::uint32_t c = 0; c < plan_.cells.size(); ++c)
      for (int i = 0; i < 3; ++i) {
        levels_.emplace_back(column(c, i), top_m(c, i));
        if (is_over_footprint(c)) levels_.emplace_back(column(c, i), 0);
        // for soffits and the walls below them
        if (!is_over_footprint(c)) levels_.emplace_back(column(c, i), under_m(c, i));
      }
    std::sort(levels_.begin(), levels_.end());
    levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
    for (const auto& [column, z_m] : levels_) {
      roof_.positions.push_back(at_height(columns_.positions[column], z_m));
      roof_.height_m = std::max(roof_.height_m, z_m);
    }
  }

  std::uint32_t vertex(std::uint32_t column, double z_m) const {
    const auto found = std::lower_bound(levels_.begin(), levels_.end(), Level{column, z_m});
    assert(found != levels_.end() && *found == Level(column, z_m));
    return static_cast<std::uint32_t>(found - levels_.begin());
  }

  // Exactly one border edge starts at every column on the border.
  void trace_eaves() {
    std::vector<std::uint32_t> next(columns_.positions.size(), kNoFacet);
    for (std::uint32_t c = 0; c < plan_.cells.size(); ++c)
      for (int edge = 0; edge < 3; ++edge)
        if (is_border(c, edge)) next[column(c, (edge + 1) % 3)] = column(c, (edge + 2) % 3);
    wall_of_.assign(next.size(), kNoFacet);
    for (std::uint32_t start = 0; start < next.size(); ++start)
      if (next[start] != kNoFacet && wall_of_[start] == kNoFacet) trace_ring(start, next);
  }

  void trace_ring(std::uint32_t start, const std::vector<std::uint32_t>& next) {
    std::vector<std::uint32_t>& ring = roof_.eaves.emplace_back();
    Vec2 before{};
    for (std::uint32_t at = start; wall_of_[at] == kNoFacet; at = next[at]) {
      const Vec2 along = unit(columns_.positions[next[at]] - columns_.positions[at]);
      if (dot(before, along) <= 0 || std::abs(cross(before, along)) > kSameWall) ++walls_;
      wall_of_[at] = walls_;
      ring.push_back(vertex(at, 0));
      before = along;
    }
  }

  void add(Triangle triangle, RoofPart part, std::uint32_t face) {
    roof_.triangles.push_back(triangle);
    roof_.parts.push_back(part);
    roof_.faces.push_back(face);
  }

  // Adds the roof over a cell, and the floor or soffit below it.
  void cover(std::uint32_t c) {
    Triangle top{}, below{};
    for (int i = 0; i < 3; ++i) {
      top[i] = vertex(column(c, i), top_m(c, i));
      below[i] = vertex(column(c, i), is_over_footprint(c) ? 0 : under_m(c, i));
    }
    add(top, RoofPart::kRoof, face_of(c));
    if (is_over_footprint(c)) return roof_.floor.push_back(below);
    std::swap(below[1], below[2]);
    add(below, RoofPart::kSoffit, face_of(c));
  }

  // Adds the vertical faces under an edge of a cell, facing out of the cell.
  void wall_off(std::uint32_t c, int edge) {
    const std::uint32_t beyond = plan_.cells[c].neighbours[edge];
    const int a = (edge + 1) % 3, b = (edge + 2) % 3;
    if (beyond == kNoFacet && !is_over_footprint(c))
      wall({column(c, a), under_m(c, a), top_m(c, a)}, {column(c, b), under_m(c, b), top_m(c, b)}, RoofPart::kEdge,
           face_of(c));
    else if (beyond == kNoFacet)
      wall({column(c, a), 0, top_m(c, a)}, {column(c, b), 0, top_m(c, b)}, RoofPart::kGable, wall_of_[column(c, a)]);
    else if (is_border(c, edge))
      wall({column(c, a), 0, under_m(c, a)}, {column(c, b), 0, under_m(c, b)}, RoofPart::kGable,
           wall_of_[column(c, a)]);
    else
      step_down(c, a, b, beyond);
  }

  double top_beyond_m(std::uint32_t cell, std::uint32_t point) const {
    const auto& points = plan_.cells[cell].points;
    return top_m(cell, static_cast<int>(std::find(points.begin(), points.end(), point) - points.begin()));
  }

  // Adds the wall from a higher surface down to a lower one. Surfaces cross at points of the plan only.
  void step_down(std::uint32_t c, int a, int b, std::uint32_t beyond) {
    const Stretch first{column(c, a), top_beyond_m(beyond, plan_.cells[c].points[a]), top_m(c, a)};
    const Stretch second{column(c, b), top_beyond_m(beyond, plan_.cells[c].points[b]), top_m(c, b)};
    if (first.high_m > first.low_m || second.high_m > second.low_m) wall(first, second, RoofPart::kGable, ~face_of(c));
  }

  // Triangulates all vertices of both columns in between, so that no vertex is inside of an edge.
  void wall(const Stretch& left, const Stretch& right, RoofPart part, std::uint32_t face) {
    std::uint32_t a = vertex(left.column, left.low_m), b = vertex(right.column, right.low_m);
    const std::uint32_t end_a = vertex(left.column, std::max(left.low_m, left.high_m));
    const std::uint32_t end_b = vertex(right.column, std::max(right.low_m, right.high_m));
    while (a < end_a || b < end_b) {
      const bool is_right = b < end_b && (a == end_a || levels_[b + 1].second <= levels_[a + 1].second);
      add(is_right ? Triangle{a, b, b + 1} : Triangle{a, b, a + 1}, part, face);
      ++(is_right ? b : a);
    }
  }

  const PlanCells& plan_;
  std::span<const Facet> facets_;
  const PlanHeights& heights_;
  double thickness_m_;
  PlanColumns columns_;
  std::vector<Level> levels_;           // sorted; the index is that of the vertex
  std::vector<std::uint32_t> wall_of_;  // by column: the number of the wall that starts there
  std::uint32_t walls_ = 0;
  Roof roof_;
};

}  // namespace

RaisedRoof raise_facets(const Polygon& footprint, const RoofPlan& plan) {
  assert(plan.thickness_m >= 0 && plan.flush_m >= 0);
  const PlanCells cells = plan_cells(footprint, plan.eaves_outline, plan.facets);
  const PlanHeights heights = plan_heights(cells, plan.facets, plan.flush_m);
  const double thickness_m = plan.eaves_outline.outer.empty() ? 0 : snapped(plan.thickness_m);
  return {Builder(cells, plan.facets, heights, thickness_m).take(), heights.uncovered_m2, heights.largest_gap_m};
}

}  // namespace citykiln::roofs
