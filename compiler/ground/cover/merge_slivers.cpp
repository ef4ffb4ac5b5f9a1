#include "compiler/ground/cover/merge_slivers.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "compiler/contract/erase_repeated.h"
#include "compiler/contract/tolerance.h"
#include "compiler/geometry/point_buckets.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/triangles/delaunay.h"

namespace citykiln::ground {
namespace {

double area_of_steps_m2(std::int64_t twice_steps) {
  return static_cast<double>(twice_steps) / 2 * kQuantum_m * kQuantum_m;
}

// The land cover faces (CoverFace) while some are merged into others. Comments here call the faces of the net
// triangles.
struct MergingRegions {
  const Delaunay& net;
  std::span<const std::uint32_t> of_face;
  std::vector<CoverFace> cover_faces;
};

Delaunay triangulate_borders(std::span<const Border> borders) {
  const std::vector<GridPoint> vertices = ends_of(borders);
  const auto number = [&](GridPoint p) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(vertices, p) - vertices.begin());
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Border& border : borders) edges.emplace_back(number(border.a), number(border.b));
  return Delaunay(vertices, edges);
}

// Returns the polygon on the triangle's side of its edge i.
std::uint32_t surface_by(std::span<const Border> borders, const Delaunay& net, std::uint32_t face, int i) {
  const auto [from, to] = edge_of(net, face, i);
  const Border key{std::min(from, to), std::max(from, to)};
  const auto border = std::lower_bound(borders.begin(), borders.end(), key, is_before);
  return from < to ? border->left : border->right;
}

// Returns the radius of the circle inside a triangle.
double inner_radius_m(const Delaunay& net, std::uint32_t face) {
  double perimeter_m = 0;
  for (int i = 0; i < 3; ++i) {
    const auto [a, b] = edge_of(net, face, i);
    perimeter_m += distance(plane_point(a), plane_point(b));
  }
  const auto [a, b] = edge_of(net, face, 0);
  return 2 * area_of_steps_m2(turn(a, b, edge_of(net, face, 1).second)) / perimeter_m;
}

// Flood-fills a land cover face from one of its triangles.
CoverFace region_from(CoverFaces& all, std::span<const Border> borders, std::uint32_t start) {
  const auto number = static_cast<std::uint32_t>(all.cover_faces.size());
  CoverFace cover_face;
  cover_face.merged_into = number;
  std::vector<std::uint32_t> open = {start};
  all.of_face[start] = number;
  while (!open.empty()) {
    const std::uint32_t f = open.back();
    open.pop_back();
    const auto [a, b] = edge_of(all.net, f, 0);
    cover_face.twice_area += turn(a, b, edge_of(all.net, f, 1).second);
    cover_face.faces.push_back(f);
    cover_face.inner_radius_m = std::max(cover_face.inner_radius_m, inner_radius_m(all.net, f));
    const DelaunayFace& face = all.net.faces()[f];
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t beyond = face.neighbours[i];
      if (beyond == kNoFace) cover_face.touches_cell_border = true;
      if (face.is_constrained[i]) cover_face.polygon = surface_by(borders, all.net, f, i);
      if (face.is_constrained[i] || beyond == kNoFace || all.of_face[beyond] != kNoFace) continue;
      all.of_face[beyond] = number;
      open.push_back(beyond);
    }
  }
  cover_face.own_m2 = area_of_steps_m2(cover_face.twice_area);
  return cover_face;
}

std::uint32_t merged_region_of(const MergingRegions& all, std::uint32_t cover_face) {
  while (all.cover_faces[cover_face].merged_into != cover_face) cover_face = all.cover_faces[cover_face].merged_into;
  return cover_face;
}

// Returns whether edge i of a triangle bounds the land cover face to which the triangle belongs now.
bool is_border(const MergingRegions& all, const DelaunayFace& face, std::uint32_t cover_face, int i) {
  if (!face.is_constrained[i]) return false;
  return face.neighbours[i] == kNoFace || merged_region_of(all, all.of_face[face.neighbours[i]]) != cover_face;
}

// A piece of a face's border, listed under each of its ends.
struct BorderEnd {
  std::uint32_t vertex, other;
  auto operator<=>(const BorderEnd&) const = default;
};

std::vector<BorderEnd> border_of(const MergingRegions& all, std::uint32_t cover_face) {
  std::vector<BorderEnd> border;
  for (const std::uint32_t f : all.cover_faces[cover_face].faces)
    for (int i = 0; i < 3; ++i) {
      const DelaunayFace& face = all.net.faces()[f];
      if (!is_border(all, face, cover_face, i)) continue;
      const std::uint32_t u = face.vertices[(i + 1) % 3], v = face.vertices[(i + 2) % 3];
      border.push_back({u, v});
      border.push_back({v, u});
    }
  std::ranges::sort(border);
  return border;
}

// A straight piece of border in plane metres; its ends may be equal.
struct Piece {
  Vec2 a, b;
};

// Returns a bound for the largest distance of a triangle's points to the nearest of some pieces. The distance to one
// piece is convex, so it is largest at a corner. Where that is too far, the triangle is halved: its halves may be near
// different pieces.
double distance_bound_m(std::span<const Piece> pieces, const std::array<Vec2, 3>& corners, double enough_m,
                        int halvings) {
  double reach_m = std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces) {
    double farthest_m = 0;
    for (const Vec2 p : corners) farthest_m = std::max(farthest_m, distance_to_segment(piece.a, piece.b, p));
    reach_m = std::min(reach_m, farthest_m);
  }
  if (reach_m <= enough_m || halvings == 0) return reach_m;
  std::array<double, 3> opposite_m{};
  for (int i = 0; i < 3; ++i) opposite_m[i] = distance(corners[(i + 1) % 3], corners[(i + 2) % 3]);
  const auto i = std::ranges::max_element(opposite_m) - opposite_m.begin();
  const Vec2 tip = corners[i], u = corners[(i + 1) % 3], v = corners[(i + 2) % 3], middle = (u + v) * 0.5;
  const double one_m = distance_bound_m(pieces, {tip, u, middle}, enough_m, halvings - 1);
  if (one_m > enough_m) return one_m;
  return std::max(one_m, distance_bound_m(pieces, {tip, middle, v}, enough_m, halvings - 1));
}

// Returns a triangle and up to `count` triangles about it, breadth first, within one land cover face.
std::vector<std::uint32_t> faces_about(const MergingRegions& all, std::uint32_t cover_face, std::uint32_t face,
                                       std::size_t count) {
  std::vector<std::uint32_t> about = {face};
  for (std::size_t next = 0; next < about.size() && about.size() < count; ++next) {
    const DelaunayFace& here = all.net.faces()[about[next]];
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t beyond = here.neighbours[i];
      if (beyond == kNoFace || merged_region_of(all, all.of_face[beyond]) != cover_face) continue;
      if (std::ranges::find(about, beyond) == about.end()) about.push_back(beyond);
    }
  }
  return about;
}

// Returns the border's pieces at the corners of some triangles: in a strip, those of both sides.
std::vector<Piece> pieces_at(const MergingRegions& all, std::span<const BorderEnd> border,
                             std::span<const std::uint32_t> faces) {
  std::vector<Piece> pieces;
  const auto place = [&](std::uint32_t v) { return plane_point(all.net.vertices()[v]); };
  for (const std::uint32_t f : faces)
    for (const std::uint32_t v : all.net.faces()[f].vertices) {
      const auto first = std::ranges::lower_bound(border, BorderEnd{v, 0});
      for (auto at = first; at != border.end() && at->vertex == v; ++at) pieces.push_back({place(v), place(at->other)});
    }
  return pieces;
}

// Limits of the proof that a triangle is thin: how often it is halved, and how many triangles about it are searched.
constexpr int kHalvings = 12;
constexpr std::size_t kFacesAbout = 24;

// More than what rounding adds to a radius.
constexpr double kRoundedUp = 1 + 0x1p-30;

double face_bound_m(const MergingRegions& all, std::span<const BorderEnd> border, std::uint32_t cover_face,
                    std::uint32_t face, double enough_m) {
  const auto corner = [&](int i) { return plane_point(all.net.vertices()[all.net.faces()[face].vertices[i]]); };
  const std::array<Vec2, 3> corners = {corner(0), corner(1), corner(2)};
  // nearly always the pieces at its own corners suffice
  const double reach_m = distance_bound_m(pieces_at(all, border, std::array{face}), corners, enough_m, 0);
  if (reach_m <= enough_m) return reach_m;
  return distance_bound_m(pieces_at(all, border, faces_about(all, cover_face, face, kFacesAbout)), corners, enough_m,
                          kHalvings);
}

// Returns a bound for the largest distance of a face's points to its border; any value above `enough_m` if it is no
// sliver.
double face_bound_m(const MergingRegions& all, std::uint32_t cover_face, double enough_m) {
  const std::vector<BorderEnd> border = border_of(all, cover_face);
  double perimeter_m = 0;
  const auto place = [&](std::uint32_t v) { return plane_point(all.net.vertices()[v]); };
  for (const BorderEnd& piece : border) perimeter_m += distance(place(piece.vertex), place(piece.other)) / 2;
  // a band along the border covers at most its width times its length
  if (area_of_steps_m2(all.cover_faces[cover_face].twice_area) > perimeter_m * enough_m)
    return std::numeric_limits<double>::infinity();
  double reach_m = 0;
  for (const std::uint32_t f : all.cover_faces[cover_face].faces) {
    reach_m = std::max(reach_m, face_bound_m(all, border, cover_face, f, enough_m));
    if (reach_m > enough_m) break;
  }
  return reach_m;
}

// A piece of border, and the face beyond it.
struct Shared {
  std::uint32_t cover_face;
  double length_m;
};

// Returns the neighbour with the longest common border; the face itself if there is none.
std::uint32_t closest_neighbour(const MergingRegions& all, std::uint32_t cover_face) {
  std::vector<Shared> shared;
  for (const std::uint32_t f : all.cover_faces[cover_face].faces)
    for (int i = 0; i < 3; ++i) {
      const DelaunayFace& face = all.net.faces()[f];
      if (!is_border(all, face, cover_face, i)) continue;
      const auto [a, b] = edge_of(all.net, f, i);
      shared.push_back(
          {merged_region_of(all, all.of_face[face.neighbours[i]]), distance(plane_point(a), plane_point(b))});
    }
  std::ranges::stable_sort(shared, {}, &Shared::cover_face);
  Shared longest{cover_face, 0};
  for (std::size_t i = 0, end = 0; i < shared.size(); i = end) {
    Shared sum{shared[i].cover_face, 0};
    for (; end < shared.size() && shared[end].cover_face == sum.cover_face; ++end) sum.length_m += shared[end].length_m;
    if (sum.length_m > longest.length_m) longest = sum;
  }
  return longest.cover_face;
}

void merge_into(MergingRegions& all, std::uint32_t cover_face, std::uint32_t neighbour) {
  CoverFace& from = all.cover_faces[cover_face];
  CoverFace& to = all.cover_faces[neighbour];
  from.merged_into = neighbour;
  to.twice_area += from.twice_area;
  to.inner_radius_m = std::max(to.inner_radius_m, from.inner_radius_m);
  to.touches_cell_border |= from.touches_cell_border;
  to.faces.insert(to.faces.end(), from.faces.begin(), from.faces.end());
  from.faces.clear();
}

// The queue's order: by area, then by number. Numbers follow the triangulation of sorted vertices, so they do not
// depend on the order of the input.
struct QueueEntry {
  std::int64_t twice_area;
  std::uint32_t cover_face;
  bool operator<(const QueueEntry& o) const {
    return std::tie(twice_area, cover_face) > std::tie(o.twice_area, o.cover_face);
  }
};

// Returns the borders that still lie between two polygons.
std::vector<Border> borders_left(const MergingRegions& all) {
  std::vector<Border> left;
  const auto& faces = all.net.faces();
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      if (!faces[f].is_constrained[i]) continue;
      const auto [a, b] = edge_of(all.net, f, i);
      const std::uint32_t beyond = faces[f].neighbours[i];
      const std::uint32_t here = all.cover_faces[merged_region_of(all, all.of_face[f])].polygon;
      if (beyond == kNoFace) left.push_back({std::min(a, b), std::max(a, b), here, here, true});
      if (beyond == kNoFace || b < a) continue;
      const std::uint32_t there = all.cover_faces[merged_region_of(all, all.of_face[beyond])].polygon;
      if (here != there) left.push_back({a, b, here, there, false});
    }
  std::ranges::sort(left, is_before);
  return left;
}

}  // namespace

CoverFaces faces_between(std::span<const Border> borders) {
  std::vector<Border> sorted(borders.begin(), borders.end());
  std::ranges::sort(sorted, is_before);
  CoverFaces all{triangulate_borders(sorted), {}, {}};
  all.of_face.assign(all.net.faces().size(), kNoFace);
  for (std::uint32_t f = 0; f < all.of_face.size(); ++f)
    if (all.of_face[f] == kNoFace) all.cover_faces.push_back(region_from(all, sorted, f));
  return all;
}

MergedSlivers merge_slivers(std::span<const Border> borders, double thickness_m,
                            const std::function<bool(const CoverFace&)>& may_merge) {
  return merge_slivers(faces_between(borders), thickness_m, may_merge);
}

MergedSlivers merge_slivers(const CoverFaces& between, double thickness_m,
                            const std::function<bool(const CoverFace&)>& may_merge) {
  assert(thickness_m >= 0);
  MergingRegions all{between.net, between.of_face, between.cover_faces};
  std::priority_queue<QueueEntry> turns;
  for (std::uint32_t r = 0; r < all.cover_faces.size(); ++r) turns.push({all.cover_faces[r].twice_area, r});
  MergedSlivers merged;
  while (!turns.empty()) {
    const QueueEntry turn = turns.top();
    turns.pop();
    const CoverFace& cover_face = all.cover_faces[turn.cover_face];
    const bool is_stale = cover_face.merged_into != turn.cover_face || cover_face.twice_area != turn.twice_area;
    if (is_stale || cover_face.touches_cell_border) continue;
    // no border crosses a triangle, so the middle of its inner circle is this far from all of them
    if (cover_face.inner_radius_m > thickness_m * kRoundedUp || !may_merge(cover_face)) continue;
    const double reach_m = face_bound_m(all, turn.cover_face, thickness_m);
    if (reach_m > thickness_m) continue;
    const std::uint32_t neighbour = closest_neighbour(all, turn.cover_face);
    if (neighbour == turn.cover_face) continue;
    ++merged.faces;
    merged.error_m = std::max(merged.error_m, reach_m);
    merge_into(all, turn.cover_face, neighbour);
    turns.push({all.cover_faces[neighbour].twice_area, neighbour});
  }
  merged.borders = borders_left(all);
  for (std::uint32_t r = 0; r < all.cover_faces.size(); ++r)
    if (all.cover_faces[r].merged_into != r &&
        all.cover_faces[merged_region_of(all, r)].polygon != all.cover_faces[r].polygon)
      merged.area_m2 += all.cover_faces[r].own_m2;
  return merged;
}

}  // namespace citykiln::ground
