#include "compiler/ground/yield_slivers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "compiler/contract/tolerance.h"
#include "compiler/geometry/delaunay.h"
#include "compiler/geometry/point_buckets.h"

namespace citykiln::ground {
namespace {

// A connected piece between borders: its triangles are those of one region.
struct Region {
  std::uint32_t surface = 0;
  std::int64_t twice_area = 0;  // grid steps
  double reach = 0;             // grid steps: no point of it is farther from its border
  bool touches_cell_border = false;
  bool has_taken = false;
  std::uint32_t heir = 0;  // itself while it stays
};

struct Regions {
  std::vector<Border> borders;  // sorted
  Delaunay net;
  std::vector<std::uint32_t> of_face;
  std::vector<Region> regions;
};

bool is_before(const Border& one, const Border& other) { return std::tie(one.a, one.b) < std::tie(other.a, other.b); }

Delaunay triangulated(std::span<const Border> borders) {
  std::vector<GridPoint> vertices;
  for (const Border& border : borders) vertices.insert(vertices.end(), {border.a, border.b});
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto number = [&](GridPoint p) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(vertices, p) - vertices.begin());
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Border& border : borders) edges.emplace_back(number(border.a), number(border.b));
  return Delaunay(vertices, edges);
}

std::array<GridPoint, 3> corners_of(const Delaunay& net, std::uint32_t face) {
  const auto& v = net.faces()[face].vertices;
  return {net.vertices()[v[0]], net.vertices()[v[1]], net.vertices()[v[2]]};
}

double length(GridPoint a, GridPoint b) {
  return std::sqrt(static_cast<double>((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)));
}

double distance_to_segment(GridPoint a, GridPoint b, GridPoint p) {
  const auto along = [](GridPoint u, GridPoint v, GridPoint q) {
    return (v.x - u.x) * (q.x - u.x) + (v.y - u.y) * (q.y - u.y);
  };
  if (along(a, b, p) <= 0) return length(a, p);
  if (along(b, a, p) <= 0) return length(b, p);
  return std::abs(static_cast<double>(turn(a, b, p))) / length(a, b);
}

// How far a triangle's points are from borders at most. From an edge of it that is a border the corner opposite is the
// farthest; and no point is farther from the nearest corner than its circle's centre is.
double reach_of(const Delaunay& net, std::uint32_t face) {
  const auto c = corners_of(net, face);
  double reach =
      length(c[0], c[1]) * length(c[1], c[2]) * length(c[2], c[0]) / (2 * static_cast<double>(turn(c[0], c[1], c[2])));
  for (int i = 0; i < 3; ++i)
    if (net.faces()[face].is_constrained[i])
      reach = std::min(reach, distance_to_segment(c[(i + 1) % 3], c[(i + 2) % 3], c[i]));
  return reach;
}

// What lies on a face's side of its edge i, as the border says.
std::uint32_t surface_by(std::span<const Border> borders, const Delaunay& net, std::uint32_t face, int i) {
  const auto c = corners_of(net, face);
  const GridPoint from = c[(i + 1) % 3], to = c[(i + 2) % 3];
  const Border key{std::min(from, to), std::max(from, to)};
  const auto border = std::lower_bound(borders.begin(), borders.end(), key, is_before);
  return from < to ? border->left : border->right;
}

// Fills a region from one of its faces.
Region region_from(Regions& all, std::uint32_t start) {
  const auto number = static_cast<std::uint32_t>(all.regions.size());
  Region region;
  region.heir = number;
  std::vector<std::uint32_t> open = {start};
  all.of_face[start] = number;
  while (!open.empty()) {
    const std::uint32_t f = open.back();
    open.pop_back();
    const auto c = corners_of(all.net, f);
    region.twice_area += turn(c[0], c[1], c[2]);
    region.reach = std::max(region.reach, reach_of(all.net, f));
    const DelaunayFace& face = all.net.faces()[f];
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t beyond = face.neighbours[i];
      if (beyond == kNoFace) region.touches_cell_border = true;
      if (face.is_constrained[i]) region.surface = surface_by(all.borders, all.net, f, i);
      if (face.is_constrained[i] || beyond == kNoFace || all.of_face[beyond] != kNoFace) continue;
      all.of_face[beyond] = number;
      open.push_back(beyond);
    }
  }
  return region;
}

Regions regions_between(std::span<const Border> borders) {
  std::vector<Border> sorted(borders.begin(), borders.end());
  std::ranges::sort(sorted, is_before);
  Delaunay net = triangulated(sorted);
  Regions all{std::move(sorted), std::move(net), {}, {}};
  all.of_face.assign(all.net.faces().size(), kNoFace);
  for (std::uint32_t f = 0; f < all.of_face.size(); ++f)
    if (all.of_face[f] == kNoFace) all.regions.push_back(region_from(all, f));
  return all;
}

std::uint32_t heir_of(const Regions& all, std::uint32_t region) {
  while (all.regions[region].heir != region) region = all.regions[region].heir;
  return region;
}

// A border of a region, as its turn to yield comes.
struct Shared {
  std::uint32_t region;  // beyond it
  double length;
};

// The neighbour with whom a region shares the longest border; itself if there is none.
std::uint32_t closest_neighbour(const Regions& all, std::uint32_t region, std::span<const std::uint32_t> faces) {
  std::vector<Shared> shared;
  for (const std::uint32_t f : faces)
    for (int i = 0; i < 3; ++i) {
      const DelaunayFace& face = all.net.faces()[f];
      if (!face.is_constrained[i]) continue;
      const auto c = corners_of(all.net, f);
      shared.push_back({heir_of(all, all.of_face[face.neighbours[i]]), length(c[(i + 1) % 3], c[(i + 2) % 3])});
    }
  std::ranges::stable_sort(shared, {}, &Shared::region);
  Shared longest{region, 0};
  for (std::size_t i = 0, end = 0; i < shared.size(); i = end) {
    Shared sum{shared[i].region, 0};
    for (; end < shared.size() && shared[end].region == sum.region; ++end) sum.length += shared[end].length;
    if (sum.region != region && sum.length > longest.length) longest = sum;
  }
  return longest.region;
}

std::vector<std::vector<std::uint32_t>> faces_by_region(const Regions& all) {
  std::vector<std::vector<std::uint32_t>> faces(all.regions.size());
  for (std::uint32_t f = 0; f < all.of_face.size(); ++f) faces[all.of_face[f]].push_back(f);
  return faces;
}

// The borders that still lie between two surfaces.
std::vector<Border> borders_left(const Regions& all) {
  std::vector<Border> left;
  const auto& faces = all.net.faces();
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      if (!faces[f].is_constrained[i]) continue;
      const auto c = corners_of(all.net, f);
      const GridPoint a = c[(i + 1) % 3], b = c[(i + 2) % 3];
      const std::uint32_t beyond = faces[f].neighbours[i];
      const std::uint32_t here = all.regions[heir_of(all, all.of_face[f])].surface;
      if (beyond == kNoFace) left.push_back({std::min(a, b), std::max(a, b), here, here, true});
      if (beyond == kNoFace || b < a) continue;
      const std::uint32_t there = all.regions[heir_of(all, all.of_face[beyond])].surface;
      if (here != there) left.push_back({a, b, here, there, false});
    }
  std::ranges::sort(left, is_before);
  return left;
}

}  // namespace

YieldedSlivers yield_slivers(std::span<const Border> borders, double thickness_m,
                             const std::function<bool(std::uint32_t)>& may_yield) {
  if (borders.empty()) return {};
  Regions all = regions_between(borders);
  const auto faces = faces_by_region(all);
  std::vector<std::uint32_t> thin;
  for (std::uint32_t r = 0; r < all.regions.size(); ++r) {
    const Region& region = all.regions[r];
    const bool is_thin = region.reach * kQuantum_m <= thickness_m;
    if (is_thin && !region.touches_cell_border && may_yield(region.surface)) thin.push_back(r);
  }
  // regions are numbered as the triangulation of sorted vertices is, so equals are told apart alike
  std::ranges::stable_sort(thin, {}, [&](std::uint32_t r) { return all.regions[r].twice_area; });
  YieldedSlivers yielded;
  for (const std::uint32_t r : thin) {
    Region& region = all.regions[r];
    const std::uint32_t neighbour = closest_neighbour(all, r, faces[r]);
    if (region.has_taken || neighbour == r) continue;
    region.heir = neighbour;
    all.regions[neighbour].has_taken = true;
    ++yielded.faces;
    yielded.area_m2 += static_cast<double>(region.twice_area) / 2 * kQuantum_m * kQuantum_m;
    yielded.error_m = std::max(yielded.error_m, region.reach * kQuantum_m);
  }
  yielded.borders = borders_left(all);
  return yielded;
}

}  // namespace citykiln::ground
