#include "compiler/buildings/blocks/merge_buildings.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <tuple>

#include "compiler/contract/disjoint_sets.h"
#include "compiler/contract/erase_repeated.h"
#include "compiler/geometry/snap.h"
#include "compiler/ground/cover/label_faces.h"
#include "compiler/ground/cover/merge_slivers.h"
#include "compiler/ground/cover/simplify_borders.h"

namespace citykiln::buildings {
namespace {

using ground::Border;
using ground::kNoOwner;

// No block: the ground.
constexpr std::uint32_t kFree = ground::kNoOwner;

double height_m(const Building& b) { return b.top_m - b.bottom_m; }

// Whole metres about all footprints, so that no building touches the border.
Box2 cell_about(std::span<const Building> buildings, std::span<const BlockRole> roles) {
  Box2 box;
  for (std::size_t i = 0; i < buildings.size(); ++i)
    if (roles[i] != BlockRole::kAbsent)
      for (const Vec2 p : buildings[i].footprint.outer) box.grow(p);
  if (box.is_empty()) return box;
  return {{std::floor(box.min.x) - 2, std::floor(box.min.y) - 2}, {std::ceil(box.max.x) + 2, std::ceil(box.max.y) + 2}};
}

// The rings of all buildings, and points on long edges, so that triangles across a gap are about as wide as the gap.
struct Rings {
  std::vector<OwnedSegment> segments;
  std::vector<GridPoint> points;
};

void add_block_ring(Rings& rings, const Ring& ring, std::uint32_t owner, double apart_m) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    rings.segments.push_back({grid_point(ring[j]), grid_point(ring[i]), owner, 1});
    const double steps = std::ceil(distance(ring[j], ring[i]) / apart_m);
    for (double s = 1; s < steps; ++s)
      rings.points.push_back(grid_point(snapped(ring[j] + (ring[i] - ring[j]) * (s / steps))));
  }
}

Rings block_rings_of(std::span<const Building> buildings, std::span<const BlockRole> roles, double apart_m) {
  Rings rings;
  for (std::uint32_t i = 0; i < buildings.size(); ++i)
    if (roles[i] != BlockRole::kAbsent)
      for (const Ring* ring : rings_of(buildings[i].footprint)) add_block_ring(rings, *ring, i, apart_m);
  return rings;
}

// The triangulated plan: which building has each face, and which buildings have faces at each vertex.
struct Plan {
  Delaunay net;
  std::vector<std::uint32_t> owner;                   // of each face; kFree without
  std::vector<std::vector<std::uint32_t>> at_vertex;  // sorted

  std::span<const std::uint32_t> at(GridPoint p) const {
    const auto place = std::ranges::lower_bound(net.vertices(), p);
    assert(place != net.vertices().end() && *place == p);
    return at_vertex[static_cast<std::size_t>(place - net.vertices().begin())];
  }
};

Delaunay triangulated(const Arrangement& arrangement) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const ArrangedEdge& edge : arrangement.edges) edges.emplace_back(edge.a, edge.b);
  return Delaunay(arrangement.vertices, edges);
}

// A face at the cell's border, outside of all buildings.
std::uint32_t outer_face(const Delaunay& net) {
  for (std::uint32_t f = 0; f < net.faces().size(); ++f)
    if (std::ranges::find(net.faces()[f].neighbours, kNoFace) != net.faces()[f].neighbours.end()) return f;
  return kNoFace;
}

std::vector<std::uint32_t> highest_first(std::span<const Building> buildings) {
  std::vector<std::uint32_t> order(buildings.size()), ranks(buildings.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, [&](auto i, auto j) { return buildings[i].top_m > buildings[j].top_m; });
  for (std::uint32_t rank = 0; rank < order.size(); ++rank) ranks[order[rank]] = rank;
  return ranks;
}

Plan plan_of(std::span<const Building> buildings, std::span<const BlockRole> roles, const Box2& cell, double apart_m) {
  const Rings rings = block_rings_of(buildings, roles, apart_m);
  const Arrangement arrangement = arrange(rings.segments, rings.points, cell);
  Plan plan{triangulated(arrangement), {}, {}};
  plan.owner = ground::label_faces(plan.net, arrangement, {outer_face(plan.net), {}}, highest_first(buildings));
  plan.at_vertex.resize(plan.net.vertices().size());
  for (std::size_t f = 0; f < plan.owner.size(); ++f)
    if (plan.owner[f] != kFree)
      for (const std::uint32_t v : plan.net.faces()[f].vertices) plan.at_vertex[v].push_back(plan.owner[f]);
  for (std::vector<std::uint32_t>& owners : plan.at_vertex) sort_unique(owners);
  return plan;
}

// Whether a free face may close a gap: it is small, and all of its corners are corners of buildings.
bool is_gap(const Plan& plan, std::size_t f, double longest_m) {
  if (plan.owner[f] != kFree) return false;
  const auto& v = plan.net.faces()[f].vertices;
  for (std::size_t i = 0; i < 3; ++i) {
    if (plan.at_vertex[v[i]].empty()) return false;
    const GridPoint a = plan.net.vertices()[v[i]], b = plan.net.vertices()[v[(i + 1) % 3]];
    if (distance(plane_point(a), plane_point(b)) > longest_m) return false;
  }
  return true;
}

using Link = std::tuple<double, std::uint32_t, std::uint32_t>;  // how much heights differ, the two buildings

std::vector<Link> links_of(const Plan& plan, std::span<const Building> buildings, double gap_m) {
  std::vector<Link> links;
  const auto link = [&](std::uint32_t i, std::uint32_t j) {
    if (i != j)
      links.emplace_back(std::abs(height_m(buildings[i]) - height_m(buildings[j])), std::min(i, j), std::max(i, j));
  };
  for (std::size_t f = 0; f < plan.owner.size(); ++f) {
    const DelaunayFace& face = plan.net.faces()[f];
    const bool closes = is_gap(plan, f, gap_m);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t n = face.neighbours[i];
      if (n != kNoFace && plan.owner[f] != kFree && plan.owner[n] != kFree) link(plan.owner[f], plan.owner[n]);
      if (!closes) continue;
      for (const std::uint32_t a : plan.at_vertex[face.vertices[i]])
        for (const std::uint32_t b : plan.at_vertex[face.vertices[(i + 1) % 3]]) link(a, b);
    }
  }
  sort_unique(links);
  return links;
}

// Buildings in sets, each with the range of its heights.
struct Sets {
  struct Range {
    double low_m, high_m;
  };
  DisjointSets sets;
  std::vector<Range> range;  // of the set that a number represents

  explicit Sets(std::span<const Building> buildings) : sets(buildings.size()) {
    for (const Building& b : buildings) range.push_back({height_m(b), height_m(b)});
  }
  void join(std::uint32_t i, std::uint32_t j, double most_m) {
    i = sets.find(i), j = sets.find(j);
    const Range both{std::min(range[i].low_m, range[j].low_m), std::max(range[i].high_m, range[j].high_m)};
    if (i == j || both.high_m - both.low_m > most_m) return;
    sets.join(i, j);
    range[sets.find(i)] = both;
  }
};

// The block of each building: numbers in the order of their first members.
struct Groups {
  std::vector<std::uint32_t> of_building;
  std::vector<std::vector<std::uint32_t>> members;
};

Groups groups_of(const Plan& plan, std::span<const Building> buildings, std::span<const BlockRole> roles,
                 double tolerance_m) {
  Sets blocks(buildings);
  for (const auto& [apart_m, i, j] : links_of(plan, buildings, kGapShare * tolerance_m))
    if (roles[i] == BlockRole::kMerged && roles[j] == BlockRole::kMerged) blocks.join(i, j, kHeightShare * tolerance_m);
  Groups groups{std::vector<std::uint32_t>(buildings.size(), kFree), {}};
  for (std::uint32_t i = 0; i < buildings.size(); ++i) {
    if (roles[i] == BlockRole::kAbsent) continue;
    std::uint32_t& group = groups.of_building[blocks.sets.find(i)];
    if (group == kFree) group = static_cast<std::uint32_t>(groups.members.size()), groups.members.emplace_back();
    groups.members[group].push_back(i);
    groups.of_building[i] = group;
  }
  return groups;
}

// The heights of a block, weighted by area.
struct Size {
  double area_m2 = 0, height_m = 0;
};

Size size_of(std::span<const Building> buildings, std::span<const std::uint32_t> members) {
  Size size;
  for (const std::uint32_t i : members) {
    const double area = std::max(area_m2(buildings[i].footprint), kQuantum_m);
    size.area_m2 += area, size.height_m += area * height_m(buildings[i]);
  }
  size.height_m /= size.area_m2;
  return size;
}

bool is_left_out(const Size& size, double tolerance_m) {
  const double small_m = kSmallShare * tolerance_m;
  return size.height_m < kLowShare * tolerance_m || (size.height_m < small_m && size.area_m2 < small_m * small_m);
}

// The lowest of the blocks that have buildings at all corners of a gap.
std::uint32_t closing_group(const Plan& plan, std::size_t f, const Groups& groups, std::span<const Size> sizes) {
  const auto& v = plan.net.faces()[f].vertices;
  std::uint32_t best = kFree;
  for (const std::uint32_t owner : plan.at_vertex[v[0]]) {
    const std::uint32_t group = groups.of_building[owner];
    const auto is_there = [&](std::uint32_t corner) {
      return std::ranges::any_of(plan.at_vertex[corner], [&](auto i) { return groups.of_building[i] == group; });
    };
    if (!is_there(v[1]) || !is_there(v[2])) continue;
    if (best == kFree || sizes[group].height_m < sizes[best].height_m) best = group;
  }
  return best;
}

// The edges between faces of different blocks, and the cell's own.
std::vector<Border> borders_between(const Plan& plan, std::span<const std::uint32_t> group_of_face) {
  std::vector<Border> borders;
  for (std::uint32_t f = 0; f < group_of_face.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t n = plan.net.faces()[f].neighbours[static_cast<std::size_t>(i)];
      const auto [from, to] = ground::edge_of(plan.net, f, i);
      const std::uint32_t left = group_of_face[f], right = n == kNoFace ? left : group_of_face[n];
      if (n == kNoFace)
        borders.push_back({std::min(from, to), std::max(from, to), left, left, true});
      else if (left != right && from < to)
        borders.push_back({from, to, left, right});
    }
  std::ranges::sort(borders, ground::is_before);
  return borders;
}

// Heights at the vertices of a block.
struct Heights {
  const Plan& plan;
  std::span<const Building> buildings;
  const Groups& groups;
  std::span<const Size> sizes;

  struct Column {
    double foot_m, roof_m;
  };
  Column at(std::uint32_t group, GridPoint p) const {
    double lowest_m = 0, sum_m = 0;
    int count = 0;
    for (const std::uint32_t i : plan.at(p)) {
      if (groups.of_building[i] != group) continue;
      lowest_m = count == 0 ? buildings[i].bottom_m : std::min(lowest_m, buildings[i].bottom_m);
      sum_m += buildings[i].bottom_m, ++count;
    }
    assert(count > 0);
    return {lowest_m, snapped(sum_m / count + sizes[group].height_m)};
  }
};

std::uint32_t add_vertex(Mesh& mesh, GridPoint p, double z) {
  mesh.positions.push_back(at_height(plane_point(p), z));
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void add_roof_face(Mesh& roof, const Delaunay& net, std::uint32_t f, std::uint32_t group, const Heights& heights) {
  Triangle t{};
  for (std::size_t i = 0; i < 3; ++i) {
    const GridPoint p = net.vertices()[net.faces()[f].vertices[i]];
    t[i] = add_vertex(roof, p, heights.at(group, p).roof_m);
  }
  roof.triangles.push_back(t);
}

// The wall of a block along an edge from a to b, to the left of which it lies: down to the neighbour's roof, if there
// is one. Where the neighbour is higher there is none of it.
void add_wall(Mesh& wall, GridPoint a, GridPoint b, std::uint32_t group, std::uint32_t beyond, const Heights& heights) {
  const auto column = [&](GridPoint p) {
    Heights::Column own = heights.at(group, p);
    if (beyond != kFree) own.foot_m = std::max(own.foot_m, heights.at(beyond, p).roof_m);
    own.foot_m = std::min(own.foot_m, own.roof_m);
    return own;
  };
  const Heights::Column at_a = column(a), at_b = column(b);
  const std::uint32_t low_a = add_vertex(wall, a, at_a.foot_m), low_b = add_vertex(wall, b, at_b.foot_m);
  const std::uint32_t high_b = add_vertex(wall, b, at_b.roof_m), high_a = add_vertex(wall, a, at_a.roof_m);
  // the block lies to the left of a b, so outside is to its right
  if (at_b.foot_m < at_b.roof_m) wall.triangles.push_back({low_a, low_b, high_b});
  if (at_a.foot_m < at_a.roof_m) wall.triangles.push_back({low_a, high_b, high_a});
}

void raise(std::vector<Block>& blocks, const ground::CoverFaces& plan, const Heights& heights) {
  const auto group_of = [&](std::uint32_t f) { return plan.cover_faces[plan.of_face[f]].polygon; };
  for (std::uint32_t f = 0; f < plan.of_face.size(); ++f) {
    const std::uint32_t group = group_of(f);
    if (group == kFree) continue;
    add_roof_face(blocks[group].roof, plan.net, f, group, heights);
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t n = plan.net.faces()[f].neighbours[static_cast<std::size_t>(i)];
      const std::uint32_t beyond = n == kNoFace ? kFree : group_of(n);
      const auto [from, to] = ground::edge_of(plan.net, f, i);
      if (beyond != group) add_wall(blocks[group].walls, from, to, group, beyond, heights);
    }
  }
}

}  // namespace

std::vector<Block> merge_buildings(std::span<const Building> buildings, std::span<const BlockRole> roles,
                                   double tolerance_m) {
  assert(buildings.size() == roles.size() && tolerance_m > 0);
  const Box2 cell = cell_about(buildings, roles);
  if (cell.is_empty()) return {};
  const Plan plan = plan_of(buildings, roles, cell, kGapShare / 2 * tolerance_m);
  const Groups groups = groups_of(plan, buildings, roles, tolerance_m);
  std::vector<Size> sizes;
  std::vector<bool> is_out;
  for (const std::vector<std::uint32_t>& members : groups.members) {
    sizes.push_back(size_of(buildings, members));
    is_out.push_back(roles[members.front()] == BlockRole::kMerged && is_left_out(sizes.back(), tolerance_m));
  }

  std::vector<std::uint32_t> group_of_face(plan.owner.size(), kFree);
  for (std::size_t f = 0; f < plan.owner.size(); ++f) {
    std::uint32_t& group = group_of_face[f];
    if (plan.owner[f] != kFree) group = groups.of_building[plan.owner[f]];
    if (is_gap(plan, f, kGapShare * tolerance_m)) group = closing_group(plan, f, groups, sizes);
    if (group != kFree && is_out[group]) group = kFree;
  }
  const ground::SimplifiedBorders outlines = ground::simplify_borders(
      borders_between(plan, group_of_face), kOutlineShare * tolerance_m, [](GridPoint) { return false; });

  std::vector<Block> blocks;
  for (const std::vector<std::uint32_t>& members : groups.members) blocks.push_back({members, {}, {}});
  raise(blocks, ground::faces_between(outlines.borders), {plan, buildings, groups, sizes});
  return blocks;
}

}  // namespace citykiln::buildings
