// Claims about a cell's borders and about simplified borders, checked by methods independent of the code under test.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "compiler/geometry/point_buckets.h"
#include "compiler/geometry/triangles/delaunay.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/cover/partition.h"
#include "compiler/ground/cover/simplify_borders.h"

namespace citykiln::ground {

inline std::vector<Border> borders_of(std::span<const LandCoverPolygon> surfaces, const Box2& cell) {
  const NearbyCover layers = land_cover_near(surfaces, cell);
  const Partition all = partition_all_rings(layers, {}, {}, cell);
  return visible_borders(all, ring_joints(layers, all.arrangement, cell));
}

/// Returns the polygon at a place, read from the border vertically above it. The cell's own borders must be included.
inline std::uint32_t surface_between(std::span<const Border> borders, Vec2 p) {
  const Border* above = nullptr;
  double least_m = 0;
  for (const Border& border : borders) {
    const Vec2 a = plane_point(border.a), b = plane_point(border.b);
    // a is the western end; vertical borders are skipped
    if (p.x < a.x || p.x >= b.x) continue;
    const double rise_m = a.y + (b.y - a.y) * ((p.x - a.x) / (b.x - a.x)) - p.y;
    if (rise_m < 0 || (above != nullptr && rise_m >= least_m)) continue;
    above = &border;
    least_m = rise_m;
  }
  return above == nullptr ? kNoLandCover : above->right;
}

inline bool no_two_cross(std::vector<Border> borders) {
  std::ranges::sort(borders, {}, [](const Border& b) { return b.a.x; });
  for (std::size_t i = 0; i < borders.size(); ++i)
    for (std::size_t j = i + 1; j < borders.size() && borders[j].a.x <= borders[i].b.x; ++j) {
      const auto& [a, b, al, ar, ac] = borders[i];
      const auto& [c, d, cl, cr, cc] = borders[j];
      const auto side = [](std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; };
      const int abc = side(turn(a, b, c)), abd = side(turn(a, b, d)), cda = side(turn(c, d, a)),
                cdb = side(turn(c, d, b));
      const auto inside = [](GridPoint p, GridPoint from, GridPoint to) {
        return p > from && p < to;  // order of points on one line
      };
      if (abc * abd < 0 && cda * cdb < 0) return false;
      if ((abc == 0 && inside(c, a, b)) || (abd == 0 && inside(d, a, b))) return false;
      if ((cda == 0 && inside(a, c, d)) || (cdb == 0 && inside(b, c, d))) return false;
      if (a == c && b == d) return false;
    }
  return true;
}

/// One connected face between borders.
struct BorderFace {
  std::uint32_t surface = 0;
  double area_m2 = 0;
  auto operator<=>(const BorderFace&) const = default;
};

inline std::vector<BorderFace> border_faces_between(std::span<const Border> borders) {
  std::vector<GridPoint> vertices;
  for (const Border& b : borders) vertices.insert(vertices.end(), {b.a, b.b});
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto number = [&](GridPoint p) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(vertices, p) - vertices.begin());
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> left_of;  // by directed edge
  for (const Border& b : borders) {
    edges.emplace_back(number(b.a), number(b.b));
    left_of[{number(b.a), number(b.b)}] = b.left;
    left_of[{number(b.b), number(b.a)}] = b.right;
  }
  const Delaunay net(vertices, edges);
  std::vector<int> seen(net.faces().size(), 0);
  std::vector<BorderFace> faces;
  for (std::uint32_t start = 0; start < seen.size(); ++start) {
    if (seen[start]++) continue;
    std::set<std::uint32_t> labels;
    double twice = 0;
    std::vector<std::uint32_t> open = {start};
    while (!open.empty()) {
      const DelaunayFace& f = net.faces()[open.back()];
      open.pop_back();
      twice += static_cast<double>(turn(vertices[f.vertices[0]], vertices[f.vertices[1]], vertices[f.vertices[2]]));
      for (int i = 0; i < 3; ++i) {
        if (f.is_constrained[i]) labels.insert(left_of.at({f.vertices[(i + 1) % 3], f.vertices[(i + 2) % 3]}));
        if (!f.is_constrained[i] && !seen[f.neighbours[i]]++) open.push_back(f.neighbours[i]);
      }
    }
    EXPECT_EQ(labels.size(), 1u) << "a face has one label, whichever of its borders is read";
    faces.push_back({*labels.begin(), twice / 2 * 0x1p-20});
  }
  return faces;
}

inline std::map<std::uint32_t, int> faces_by_surface(const std::vector<BorderFace>& faces) {
  std::map<std::uint32_t, int> count;
  for (const BorderFace& face : faces) ++count[face.surface];
  return count;
}

/// A run of old borders between kept vertices, which one new border replaces.
struct OldRun {
  std::vector<GridPoint> points;  ///< Points along the run, the smaller end first.
  std::uint32_t left = 0, right = 0;
};

/// Returns one run for each new border, in their order; empty if there is none.
inline std::vector<OldRun> runs_behind(std::span<const Border> old, std::span<const Border> now) {
  std::set<GridPoint> kept;
  for (const Border& b : now) kept.insert({b.a, b.b});
  std::multimap<GridPoint, const Border*> at;
  for (const Border& b : old) at.emplace(b.a, &b), at.emplace(b.b, &b);
  std::map<std::pair<GridPoint, GridPoint>, OldRun> runs;
  std::size_t count = 0;
  for (const Border& start : old)
    for (const GridPoint first : {start.a, start.b}) {
      if (!kept.contains(first)) continue;
      const Border* border = &start;
      OldRun run{{first}, first == start.a ? start.left : start.right, first == start.a ? start.right : start.left};
      for (GridPoint p = first;;) {
        p = border->a == p ? border->b : border->a;
        run.points.push_back(p);
        if (kept.contains(p)) break;
        const auto [low, high] = at.equal_range(p);
        EXPECT_EQ(std::distance(low, high), 2) << "a vertex that is gone had two borders";
        border = low->second == border ? std::next(low)->second : low->second;
      }
      if (run.points.back() < first) continue;
      ++count;
      runs[{first, run.points.back()}] = run;
    }
  EXPECT_EQ(count, now.size());
  std::vector<OldRun> behind;
  for (const Border& b : now) behind.push_back(runs[{b.a, b.b}]);
  return behind;
}

inline double distance_m(Vec2 p, Vec2 a, Vec2 b) {
  const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  return distance(p, a + (b - a) * t);
}

/// Returns the Hausdorff distance between a run and a new border, by samples.
inline double sampled_distance_m(const OldRun& run, const Border& now) {
  constexpr int kSamples = 20;
  const Vec2 a = plane_point(now.a), b = plane_point(now.b);
  double farthest = 0;
  for (std::size_t i = 1; i < run.points.size(); ++i)
    for (int k = 0; k <= kSamples; ++k) {
      const Vec2 p = plane_point(run.points[i - 1]), q = plane_point(run.points[i]);
      farthest = std::max(farthest, distance_m(p + (q - p) * (1.0 * k / kSamples), a, b));
    }
  for (int k = 0; k <= kSamples && run.points.size() > 2; ++k) {
    double nearest = 1e300;
    for (std::size_t i = 1; i < run.points.size(); ++i)
      nearest = std::min(nearest, distance_m(a + (b - a) * (1.0 * k / kSamples), plane_point(run.points[i - 1]),
                                             plane_point(run.points[i])));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

/// Checks all guarantees of simplify_borders() that need no second run, for one cell.
inline void expect_simplified(std::span<const Border> old, const SimplifiedBorders& now, double tolerance_m,
                              const Box2& cell) {
  EXPECT_TRUE(no_two_cross(now.borders));
  const auto faces_before = border_faces_between(old), faces_after = border_faces_between(now.borders);
  EXPECT_EQ(faces_by_surface(faces_before), faces_by_surface(faces_after));
  double area_m2 = 0;
  for (const BorderFace& face : faces_after) area_m2 += face.area_m2;
  EXPECT_EQ(area_m2, cell.width() * cell.height());
  const std::vector<OldRun> runs = runs_behind(old, now.borders);
  double measured_m = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    ASSERT_FALSE(runs[i].points.empty());
    EXPECT_EQ(runs[i].left, now.borders[i].left);
    EXPECT_EQ(runs[i].right, now.borders[i].right);
    measured_m = std::max(measured_m, sampled_distance_m(runs[i], now.borders[i]));
    const bool on_border = std::ranges::any_of(
        old, [&](const Border& b) { return b.is_cell_border && b.a == now.borders[i].a && b.b == now.borders[i].b; });
    EXPECT_EQ(on_border, now.borders[i].is_cell_border);
  }
  EXPECT_LE(measured_m, now.error_m + 1e-9);
  EXPECT_GE(measured_m, now.error_m - 1e-9) << "the error is a measure, no estimate";
  EXPECT_LE(now.error_m, tolerance_m);
}

}  // namespace citykiln::ground
