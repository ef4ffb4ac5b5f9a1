#include "grammars/shapes/cut.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace citykiln::grammars {
namespace {

constexpr double kSamePlace_m = 1e-6;  // above rounding error, below any detail
constexpr double kNoArea_m2 = 1e-12;   // of twice the area: below it is rounding error

double height_above(const CutPlane& plane, Vec3 p) {
  const double d_m = dot(plane.normal, p) - plane.offset_m;
  return std::abs(d_m) <= kOnPlane_m ? 0 : d_m;
}

// Where an edge crosses the plane, from the heights of its ends above it. Independent of the direction of the edge.
Vec3 crossing(Vec3 a, double a_m, Vec3 b, double b_m) {
  if (b < a) std::swap(a, b), std::swap(a_m, b_m);
  return a + (b - a) * (a_m / (a_m - b_m));
}

struct Chains {
  std::vector<Ring3> chains;  ///< The parts of rings from a rise through the plane to the next descent.
  std::vector<Ring3> whole;   ///< Rings entirely above the plane.
};

// The chain that begins at vertex `first`. Its ends are on the plane: vertices, or crossings.
Ring3 chain_from(std::span<const Vec3> ring, std::size_t first, std::span<const double> heights) {
  const std::size_t n = ring.size();
  const auto before = [n](std::size_t i) { return i == 0 ? n - 1 : i - 1; };
  const auto between = [&](std::size_t i, std::size_t j) { return crossing(ring[i], heights[i], ring[j], heights[j]); };
  Ring3 chain;
  if (heights[first] > 0) chain.push_back(between(before(first), first));
  std::size_t i = first;
  for (; heights[i] >= 0; i = i + 1 == n ? 0 : i + 1) chain.push_back(ring[i]);
  const std::size_t last = before(i);
  if (heights[last] > 0) chain.push_back(between(last, i));
  return chain;
}

// Chains from each edge of the ring in the plane to the next such edge.
void open_ring(std::span<const Vec3> ring, std::span<const double> heights, Chains& out) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (heights[i] != 0 || heights[(i + n - 1) % n] != 0) continue;
    Ring3 chain = {ring[i]};
    for (std::size_t k = i; heights[k] != 0 || heights[(k + 1) % n] != 0; k = (k + 1) % n)
      chain.push_back(ring[(k + 1) % n]);
    if (chain.size() > 2) out.chains.push_back(std::move(chain));
  }
}

void cut_ring(std::span<const Vec3> ring, const CutPlane& plane, bool is_hole, Chains& out) {
  const std::size_t n = ring.size();
  std::vector<double> heights(n);
  bool below = false, above = false, has_edge_in_plane = false;
  for (std::size_t i = 0; i < n; ++i) {
    heights[i] = height_above(plane, ring[i]);
    below |= heights[i] < 0;
    above |= heights[i] > 0;
  }
  if (!above) return;
  for (std::size_t i = 0; i < n; ++i) has_edge_in_plane |= heights[i] == 0 && heights[(i + 1) % n] == 0;
  // below such an edge of a hole nothing is left that separates it from the outside
  if (!below && is_hole && has_edge_in_plane) return open_ring(ring, heights, out);
  if (!below) return out.whole.emplace_back(ring.begin(), ring.end()), void();
  for (std::size_t i = 0; i < n; ++i) {
    if (heights[i] < 0 || heights[(i + n - 1) % n] >= 0) continue;
    Ring3 chain = chain_from(ring, i, heights);
    const bool rises = std::any_of(chain.begin(), chain.end(), [&](Vec3 p) { return height_above(plane, p) > 0; });
    // a chain that only touches the plane bounds no area above it
    if (rises) out.chains.push_back(std::move(chain));
  }
}

std::vector<std::size_t> sorted_along(Vec3 along, const std::vector<Ring3>& chains, bool by_end) {
  std::vector<std::size_t> order(chains.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto at = [&](std::size_t i) { return dot(along, by_end ? chains[i].back() : chains[i].front()); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return at(a) < at(b); });
  return order;
}

// Rings of chains: the k-th end along the cut continues at the k-th start.
std::vector<Ring3> joined(const std::vector<Ring3>& chains, Vec3 along) {
  const auto ends = sorted_along(along, chains, true), starts = sorted_along(along, chains, false);
  std::vector<std::size_t> next(chains.size());
  for (std::size_t k = 0; k < ends.size(); ++k) next[ends[k]] = starts[k];
  std::vector<bool> done(chains.size());
  std::vector<Ring3> rings;
  for (std::size_t first = 0; first < chains.size(); ++first) {
    if (done[first]) continue;
    Ring3& ring = rings.emplace_back();
    for (std::size_t i = first; !done[i]; i = next[i]) {
      done[i] = true;
      ring.append(chains[i].begin(), chains[i].end());
    }
  }
  return rings;
}

bool has_repeats(const Ring3& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (ring[i] == ring[i == 0 ? ring.size() - 1 : i - 1]) return ring.size() > 1;
  return false;
}

Ring3 without_repeats(Ring3 ring) {
  if (!has_repeats(ring)) return ring;
  Ring3 kept;
  for (const Vec3 p : ring)
    if (kept.empty() || !(p == kept.back())) kept.push_back(p);
  while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
  return kept;
}

bool surrounds(const Face& face, Vec3 p, const FaceFrame& frame) {
  const Polygon polygon = flat(face, frame);
  return winding_number(polygon.outer, frame.to_plane(p)) != 0;
}

// The area of the outer ring, holes included.
double outer_m2(const Face& face) { return length(double_area_vector_m2(face.outer)) / 2; }

// Faces of rings: those that turn with the normal are outer rings, the others are holes of the smallest outer ring
// around them.
std::vector<Face> nested(const std::vector<Ring3>& rings, Vec3 normal) {
  std::vector<Face> faces;
  std::vector<Ring3> holes;
  for (const Ring3& raw : rings) {
    const Ring3 ring = without_repeats(raw);
    const double twice_area_m2 = dot(normal, double_area_vector_m2(ring));
    if (ring.size() < 3 || std::abs(twice_area_m2) < kNoArea_m2) continue;
    if (twice_area_m2 > 0) {
      faces.emplace_back().outer = ring;
    } else {
      holes.push_back(ring);
    }
  }
  for (const Ring3& hole : holes) {
    Face* home = nullptr;
    for (Face& face : faces) {
      if (faces.size() > 1 && !surrounds(face, (hole[0] + hole[1]) * 0.5, frame_of(face))) continue;
      if (home == nullptr || outer_m2(face) < outer_m2(*home)) home = &face;
    }
    if (home != nullptr) home->holes.push_back(hole);
  }
  return faces;
}

bool lies_in_plane(const Face& face, const CutPlane& plane) {
  return std::all_of(face.outer.begin(), face.outer.end(), [&](Vec3 p) { return height_above(plane, p) == 0; });
}

void add_edges(const Ring3& ring, std::vector<Edge3>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

std::vector<Edge3> edges_of_faces(std::span<const Face> faces) {
  std::vector<Edge3> edges;
  for (const Face& face : faces) {
    add_edges(face.outer, edges);
    for (const Ring3& hole : face.holes) add_edges(hole, edges);
  }
  return edges;
}

// A point rounded to 2^-18 m, by which ends of edges are compared.
using GridPoint = std::array<std::int64_t, 3>;

GridPoint grid_point(Vec3 p) {
  const auto cell = [](double v) {
    const double scaled = std::clamp(v * 0x1p18, -9e15, 9e15);
    return static_cast<std::int64_t>(std::floor(scaled + 0.5));
  };
  return {cell(p.x), cell(p.y), cell(p.z)};
}

/// An undirected edge with its direction and index.
struct UndirectedEdge {
  GridPoint low, high;
  bool turned = false;  ///< The edge is directed from `high` to `low`.
  std::size_t index = 0;
  auto operator<=>(const UndirectedEdge&) const = default;
};

// Sorted; edges without length are left out.
std::vector<UndirectedEdge> undirected(std::span<const Edge3> edges) {
  std::vector<UndirectedEdge> sorted;
  sorted.reserve(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const GridPoint a = grid_point(edges[i].first), b = grid_point(edges[i].second);
    if (a != b) sorted.push_back({std::min(a, b), std::max(a, b), b < a, i});
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

// Edges that remain when pairs of opposite edges are removed; of several equal edges the first ones.
std::vector<Edge3> without_opposites(std::span<const Edge3> edges) {
  const std::vector<UndirectedEdge> sorted = undirected(edges);
  std::vector<bool> is_kept(edges.size());
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto is_other = [&](const UndirectedEdge& edge) {
      return edge.low != first->low || edge.high != first->high;
    };
    const auto end = std::find_if(first, sorted.end(), is_other);
    const auto turn = std::find_if(first, end, [](const UndirectedEdge& edge) { return edge.turned; });
    const auto one = turn - first, other = end - turn;
    for (auto edge = first; edge < turn && edge - first < one - other; ++edge) is_kept[edge->index] = true;
    for (auto edge = turn; edge < end && edge - turn < other - one; ++edge) is_kept[edge->index] = true;
    first = end;
  }
  std::vector<Edge3> left;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (is_kept[i]) left.push_back(edges[i]);
  return left;
}

// Increases with the angle to the left, from -2 to 2.
double left_turn(Vec3 in, Vec3 out, Vec3 normal) {
  const double turn = 1 - dot(unit(in), unit(out));
  return dot(normal, cross(in, out)) < 0 ? -turn : turn;
}

// The unused edge that continues `last`. Where rings touch, the one that turns most to the left, which separates parts
// that share a point only.
std::size_t edge_after(const Edge3& last, const std::vector<Edge3>& edges, const std::vector<bool>& used, Vec3 normal) {
  std::size_t best = edges.size();
  double best_turn = -3;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (used[i] || length(edges[i].first - last.second) >= kSamePlace_m) continue;
    const double turn = left_turn(last.second - last.first, edges[i].second - edges[i].first, normal);
    if (turn > best_turn) best = i, best_turn = turn;
  }
  return best;
}

// Splits a ring that passes through a point twice, as bays of a roof that meet in a valley.
void split_where_it_touches(const Ring3& ring, std::vector<Ring3>& rings) {
  std::vector<Vec3> open;
  std::map<GridPoint, std::size_t> index_at;
  for (const Vec3 p : ring) {
    const auto [at, is_new] = index_at.try_emplace(grid_point(p), open.size());
    if (!is_new) {
      const auto from = open.begin() + static_cast<std::ptrdiff_t>(at->second);
      rings.emplace_back(from, open.end());
      for (auto q = from + 1; q != open.end(); ++q) index_at.erase(grid_point(*q));
      open.erase(from + 1, open.end());
    } else {
      open.push_back(p);
    }
  }
  rings.emplace_back(open.begin(), open.end());
}

constexpr std::size_t kMostSimple = 16;

/// A ring of few points relative to a plane.
struct Heights {
  std::array<double, kMostSimple> heights;
  bool below = false, above = false;
  std::size_t rises = 0, first = 0;  ///< The number of rises through the plane, and the vertex after the last one.
};

void find_rises(Heights& ring_heights, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (ring_heights.heights[i] < 0 || ring_heights.heights[i == 0 ? count - 1 : i - 1] >= 0) continue;
    ++ring_heights.rises;
    ring_heights.first = i;
  }
}

Heights heights_of(const Ring3& ring, const CutPlane& plane) {
  const std::size_t n = ring.size();
  Heights ring_heights;
  for (std::size_t i = 0; i < n; ++i) {
    ring_heights.heights[i] = height_above(plane, ring[i]);
    ring_heights.below |= ring_heights.heights[i] < 0;
    ring_heights.above |= ring_heights.heights[i] > 0;
  }
  find_rises(ring_heights, n);
  return ring_heights;
}

bool is_simple(const Face& face) {
  return face.holes.empty() && face.outer.size() <= kMostSimple && face.outer.size() >= 3;
}

bool has_area(const Ring3& ring) { return ring.size() >= 3 && length(double_area_vector_m2(ring)) >= kNoArea_m2; }

Heights upside_down(const Heights& ring_heights, std::size_t count) {
  Heights turned;
  turned.below = ring_heights.above, turned.above = ring_heights.below;
  for (std::size_t i = 0; i < count; ++i) turned.heights[i] = -ring_heights.heights[i];
  find_rises(turned, count);
  return turned;
}

Ring3 chain_of(const Face& face, const Heights& ring_heights) {
  return without_repeats(chain_from(face.outer, ring_heights.first, ring_heights.heights));
}

// The part above of a face without holes that rises through the plane once: its only chain.
std::optional<std::vector<Face>> part_of_simple(const Face& face, const CutPlane& plane) {
  if (!is_simple(face)) return std::nullopt;
  const Heights ring_heights = heights_of(face.outer, plane);
  if (ring_heights.above && !ring_heights.below) return std::vector<Face>{face};
  if (!ring_heights.above && ring_heights.below) return std::vector<Face>{};
  if (ring_heights.rises != 1) return std::nullopt;
  std::vector<Face> parts(1);
  Face& part = parts.front();
  part.outer = chain_of(face, ring_heights);
  part.tag = face.tag, part.street = face.street;
  if (!has_area(part.outer)) parts.clear();
  return parts;
}

}  // namespace

std::vector<Face> part_above(const Face& face, const CutPlane& plane) {
  if (std::optional<std::vector<Face>> part = part_of_simple(face, plane)) return std::move(*part);
  const Vec3 normal = normal_of(face);
  if (lies_in_plane(face, plane)) return dot(normal, plane.normal) < 0 ? std::vector{face} : std::vector<Face>{};
  Chains cut;
  cut_ring(face.outer, plane, false, cut);
  for (const Ring3& hole : face.holes) cut_ring(hole, plane, true, cut);
  if (cut.chains.empty() && cut.whole.size() == 1 + face.holes.size()) return {face};
  // the inside is to the left of the cut
  std::vector<Ring3> rings = joined(cut.chains, cross(plane.normal, normal));
  rings.insert(rings.end(), cut.whole.begin(), cut.whole.end());
  std::vector<Face> parts = nested(rings, normal);
  for (Face& part : parts) part.tag = face.tag, part.street = face.street;
  return parts;
}

bool cut_in_two(Face& face, const CutPlane& plane, Face& below) {
  if (!is_simple(face)) return false;
  // the part below has negated heights and the same crossings
  const Heights up = heights_of(face.outer, plane), down = upside_down(up, face.outer.size());
  if (up.rises != 1 || down.rises != 1 || !up.above || !up.below) return false;
  Ring3 above = chain_of(face, up);
  below.outer = chain_of(face, down);
  if (!has_area(above) || !has_area(below.outer)) return false;
  below.tag = face.tag, below.street = face.street;
  face.outer = std::move(above);
  face.street_edges.clear();
  return true;
}

bool is_closed(std::span<const Face> faces) {
  if (faces.size() < 4) return false;
  return without_opposites(edges_of_faces(faces)).empty();
}

std::vector<Face> faces_along(std::span<const Edge3> all, Vec3 normal) {
  const std::vector<Edge3> edges = without_opposites(all);
  std::vector<bool> used(edges.size());
  std::vector<Ring3> rings;
  for (std::size_t first = 0; first < edges.size(); ++first) {
    if (used[first]) continue;
    Ring3 ring;
    std::size_t i = first;
    for (; i < edges.size(); i = edge_after(edges[i], edges, used, normal)) {
      used[i] = true;
      ring.push_back(edges[i].first);
      if (length(edges[i].second - ring.front()) < kSamePlace_m) break;
    }
    if (i < edges.size()) split_where_it_touches(ring, rings);
  }
  return nested(rings, normal);
}

std::vector<Face> solid_above(std::span<const Face> faces, const CutPlane& plane, bool closed) {
  std::vector<Face> parts;
  for (const Face& face : faces)
    for (Face& part : part_above(face, plane)) parts.push_back(std::move(part));
  if (!closed || parts.empty()) return parts;
  std::vector<Edge3> open;
  for (const Edge3& edge : edges_of_faces(parts))
    if (height_above(plane, edge.first) == 0 && height_above(plane, edge.second) == 0)
      open.push_back({edge.second, edge.first});
  for (Face& cap : faces_along(open, plane.normal * -1.0)) parts.push_back(std::move(cap));
  return parts;
}

std::vector<Face> merged(std::span<const Face> faces) {
  if (faces.size() < 2) return {faces.begin(), faces.end()};
  std::vector<Face> made = faces_along(edges_of_faces(faces), normal_of(faces.front()));
  for (Face& face : made) face.tag = faces.front().tag;
  return made;
}

}  // namespace citykiln::grammars
