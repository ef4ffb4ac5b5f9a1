#include "compiler/ground/grading/grading_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory_resource>

#include "compiler/contract/erase_repeated.h"
#include "compiler/ground/grading/bend_points.h"

namespace citykiln::ground {
namespace {

using Line = std::pair<GridPoint, GridPoint>;

// A road closer to the terrain than this has no bank.
constexpr double kNoBank_m = 0.03125;

// Lower walls between roads need no lines: refine_reference() adds points there.
constexpr double kMinWall_m = 0.5;

// A road whose tilt changes is not flat: its axis is a line where a diagonal of the piece is off the axis by more than
// this.
constexpr double kMinTwist_m = 0x1p-9;

// Roads no wider than kNarrow_m leave no room for points of refine_reference(). Where blending with other roads bends
// their heights, a line goes across, kAcross_m beyond both edges.
constexpr double kNarrow_m = 3;
constexpr double kAcross_m = 0.5;
constexpr SplitLimits kAxisFineness{2, 1, kReferenceError_m / 4};

// Steps of the search for the foot of a bank: each goes to where the terrain's last height would be met.
constexpr int kFootSteps = 4;

void add_line(Vec2 a, Vec2 b, std::vector<Line>& lines) {
  const GridPoint p = grid_point(a), q = grid_point(b);
  if (p != q) lines.push_back(std::minmax({p, q}));
}

void add_bent(GradedHeights& heights, const Line& line, const Box2& cell, std::vector<Line>& lines) {
  GridPoint from = line.first;
  for (const Vec2 bend : bend_points_along(heights, plane_point(line.first), plane_point(line.second), cell)) {
    add_line(plane_point(from), bend, lines);
    from = grid_point(bend);
  }
  add_line(plane_point(from), plane_point(line.second), lines);
}

// A vertex of the terrain's grid, counted from the south-west.
struct Node {
  int i, j;
};

// Adds an edge of the terrain's grid unless both triangles beside it are one level piece. u and v are their corners off
// the edge. Beyond its box the terrain continues as at its border.
void add_terrain_line(const map::Heightfield& terrain, Node a, Node b, Node u, Node v, std::vector<Line>& lines) {
  const auto height = [&](Node n) {
    return terrain.height_m_at_vertex(std::clamp(n.i, 0, terrain.columns - 1), std::clamp(n.j, 0, terrain.rows - 1));
  };
  if (height(a) == height(b) && height(a) == height(u) && height(a) == height(v)) return;
  add_line(terrain.vertex(a.i, a.j), terrain.vertex(b.i, b.j), lines);
}

// Adds rows, columns and diagonals, rectangle by rectangle, so that lines end where they cross.
void add_terrain_lines(const map::Heightfield& terrain, const Box2& cell, std::vector<Line>& lines) {
  const auto column = [&](double x) { return static_cast<int>(std::floor((x - terrain.min.x) / terrain.step_m.x)); };
  const auto row = [&](double y) { return static_cast<int>(std::floor((y - terrain.min.y) / terrain.step_m.y)); };
  const int i0 = std::max(0, column(cell.min.x)), i1 = std::min(terrain.columns - 1, column(cell.max.x) + 1);
  const int j0 = std::max(0, row(cell.min.y)), j1 = std::min(terrain.rows - 1, row(cell.max.y) + 1);
  for (int j = j0; j <= j1; ++j)
    for (int i = i0; i <= i1; ++i) {
      const Node here{i, j}, east{i + 1, j}, north{i, j + 1}, beyond{i + 1, j + 1};
      if (i < i1) add_terrain_line(terrain, here, east, beyond, {i, j - 1}, lines);
      if (j < j1) add_terrain_line(terrain, here, north, beyond, {i - 1, j}, lines);
      if (i < i1 && j < j1) add_terrain_line(terrain, here, beyond, east, north, lines);
    }
}

// Returns where lines across the road are needed: the segment's ends, knots, and multiples of kStation_m along the way.
std::vector<double> stations_of(const GradedSegment& s, const Profile& profile) {
  std::vector<double> stations = {s.from_m, s.to_m};
  for (const Knot& knot : profile) stations.push_back(knot.at_m);
  for (double at_m = std::ceil(s.from_m / kStation_m) * kStation_m; at_m < s.to_m; at_m += kStation_m)
    stations.push_back(at_m);
  std::erase_if(stations, [&](double at_m) { return at_m < s.from_m || at_m > s.to_m; });
  sort_unique(stations);
  return stations;
}

// Returns how far from the edge a bank ends; `out` is a step of one metre.
double foot_m(const map::Heightfield& terrain, Vec2 edge, Vec2 out, double edge_m) {
  double away_m = 0;
  for (int i = 0; i < kFootSteps; ++i) {
    const double rise_m = std::abs(map::height_m_at(terrain, edge + out * away_m) - edge_m);
    away_m = rise_m < kNoBank_m ? 0 : std::min(rise_m / kEarthSlope, kGrading_m);
  }
  return away_m;
}

Vec2 on_axis(const GradedSegment& s, double at_m) {
  return s.from + (s.to - s.from) * ((at_m - s.from_m) / (s.to_m - s.from_m));
}

// Where a line across the road leaves it; `out` is a step of one metre.
struct RoadEdge {
  Vec2 at, out;
  double z_m = 0;
};

std::array<RoadEdge, 2> edges_at(const GradedTerrain& graded, const GradedSegment& s, double at_m) {
  const Vec2 left = left_of(unit(s.to - s.from));
  const Vec2 axis = on_axis(s, at_m);
  const Knot knot = knot_at(graded.roads.profiles[s.road], at_m);
  return {{{axis + left * s.left_m, left, knot.z_m + knot.tilt * s.left_m},
           {axis - left * s.right_m, left * -1.0, knot.z_m - knot.tilt * s.right_m}}};
}

// Returns the feet of both banks.
std::array<Vec2, 2> feet_at(const GradedTerrain& graded, const GradedSegment& s, double at_m) {
  std::array<Vec2, 2> feet;
  const std::array<RoadEdge, 2> edges = edges_at(graded, s, at_m);
  for (std::size_t side = 0; side < 2; ++side) {
    const auto& [at, out, z_m] = edges[side];
    feet[side] = at + out * foot_m(graded.terrain, at, out, z_m);
  }
  return feet;
}

// Returns whether a road lower than the edge by kMinWall_m is within kWallFoot_m.
bool has_wall(const GradedTerrain& graded, const RoadEdge& edge) {
  std::array<std::byte, 4096> room;
  std::pmr::monotonic_buffer_resource memory(room.data(), room.size());
  const Vec2 foot = edge.at + edge.out * kWallFoot_m;
  const auto influences = road_influences_at(graded.roads, foot, map::height_m_at(graded.terrain, foot), &memory);
  return std::ranges::any_of(influences, [&](const RoadInfluence& influence) {
    return influence.beyond_m < kWallFoot_m && edge.z_m - influence.z_m > kMinWall_m;
  });
}

// Adds the top and the foot of walls towards lower roads.
void add_wall_lines(const GradedTerrain& graded, const GradedSegment& s, double from_m, double to_m,
                    std::vector<Line>& lines) {
  const std::array<RoadEdge, 2> from = edges_at(graded, s, from_m), to = edges_at(graded, s, to_m);
  for (std::size_t side = 0; side < 2; ++side) {
    if (!has_wall(graded, from[side]) && !has_wall(graded, to[side])) continue;
    for (const double away_m : {kWallTop_m, kWallFoot_m})
      add_line(from[side].at + from[side].out * away_m, to[side].at + to[side].out * away_m, lines);
  }
}

void add_axis_line(const GradedTerrain& graded, const GradedSegment& s, double from_m, double to_m,
                   std::vector<Line>& lines) {
  const Profile& profile = graded.roads.profiles[s.road];
  const double turned = knot_at(profile, to_m).tilt - knot_at(profile, from_m).tilt;
  if (std::abs(turned) * (s.left_m + s.right_m) / 4 <= kMinTwist_m) return;
  add_line(on_axis(s, from_m), on_axis(s, to_m), lines);
}

bool is_narrow(const GradedSegment& s) { return s.left_m + s.right_m <= kNarrow_m; }

// Adds lines across a narrow road where its heights bend.
void add_bend_lines(GradedHeights& heights, const GradedSegment& s, double from_m, double to_m, const Box2& cell,
                    std::vector<Line>& lines) {
  const Vec2 out = left_of(unit(s.to - s.from));
  const Box2 near = cell.widened(kNarrow_m);
  for (const Vec2 p : bend_points_along(heights, on_axis(s, from_m), on_axis(s, to_m), near, kAxisFineness))
    add_line(p + out * (s.left_m + kAcross_m), p - out * (s.right_m + kAcross_m), lines);
}

void add_road_lines(GradedHeights& heights, const GradedSegment& s, const Box2& cell, std::vector<Line>& lines) {
  const GradedTerrain& graded = heights.graded();
  const Profile& profile = graded.roads.profiles[s.road];
  if (profile.empty()) return;
  const std::vector<double> stations = stations_of(s, profile);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const auto [left, right] = feet_at(graded, s, stations[i]);
    add_line(left, right, lines);
    if (i == 0) continue;
    const auto [before_left, before_right] = feet_at(graded, s, stations[i - 1]);
    add_line(before_left, left, lines);
    add_line(before_right, right, lines);
    add_wall_lines(graded, s, stations[i - 1], stations[i], lines);
    add_axis_line(graded, s, stations[i - 1], stations[i], lines);
    if (is_narrow(s)) add_bend_lines(heights, s, stations[i - 1], stations[i], cell, lines);
  }
}

// Adds the faces of a step or the edges of a crest beside a segment of a landform. They depend on its axis only, as the
// terrain at the far end of a long segment is not known in every tile.
void add_landform_lines(const LandformIndex& landforms, LandformIndex::Piece piece, std::vector<Line>& lines) {
  const Landform& form = landforms.forms[piece.form];
  if (is_area(form.kind)) return;
  const Vec2 from = form.axis[piece.segment], to = form.axis[piece.segment + 1], left = left_of(unit(to - from));
  add_line(from + left * form.left_m, to + left * form.left_m, lines);
  add_line(from - left * form.right_m, to - left * form.right_m, lines);
}

bool may_touch(const Line& line, const Box2& cell) {
  return box_of_segment(plane_point(line.first), plane_point(line.second)).touches(cell.widened(1));
}

}  // namespace

std::vector<Line> grading_lines(GradedHeights& heights, const Box2& cell) {
  const GradedTerrain& graded = heights.graded();
  std::vector<Line> lines;
  for (const std::uint32_t i : boxes_about(graded.roads.grid, cell))
    add_road_lines(heights, graded.roads.segments[i], cell, lines);
  for (const std::uint32_t i : boxes_about(graded.landforms.grid, cell))
    add_landform_lines(graded.landforms, graded.landforms.pieces[i], lines);
  add_terrain_lines(graded.terrain, cell, lines);
  std::erase_if(lines, [&](const Line& line) { return !may_touch(line, cell); });
  std::vector<Line> bent;
  for (const Line& line : lines) add_bent(heights, line, cell, bent);
  std::erase_if(bent, [&](const Line& line) { return !may_touch(line, cell); });
  return bent;
}

std::vector<Line> lines_near_border(std::vector<Line> lines, const Box2& cell) {
  const Box2 inner = cell.widened(-1);
  std::erase_if(lines, [&](const Line& line) {
    return inner.contains(plane_point(line.first)) && inner.contains(plane_point(line.second));
  });
  return lines;
}

}  // namespace citykiln::ground
