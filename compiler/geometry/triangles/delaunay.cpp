// Incremental insertion with flips: Lawson, "Software for C1 surface interpolation", Mathematical Software III, 1977.
// Constrained edges: Sloan, "A fast algorithm for generating constrained Delaunay triangulations", Computers &
// Structures 47, 1993. Four points on a circle: Devillers and Teillaud, "Perturbations and vertex removal in a 3D
// Delaunay triangulation", SODA 2003; so the result does not depend on the order of insertion. All tests are exact.
#include "compiler/geometry/triangles/delaunay.h"

#include <algorithm>
#include <cassert>
#include <deque>

#include "compiler/geometry/grid_point_set.h"

namespace citykiln {
namespace {

__extension__ using Wide = __int128;

// The corner beyond the convex hull: while points are inserted, each outer edge has a face with this corner.
constexpr std::uint32_t kBeyond = 0xffffffffu;

int next_corner(int i) { return i == 2 ? 0 : i + 1; }
int last_corner(int i) { return i == 0 ? 2 : i - 1; }

// The order in which points on a circle count as inside: from the north, then from the west.
bool comes_before(GridPoint a, GridPoint b) { return a.y != b.y ? a.y > b.y : a.x < b.x; }

// Decides for a point on the circle about a triangle as if each point were lifted by an amount of its own, the last
// point by the most.
bool is_in_perturbed_circle(GridPoint a, GridPoint b, GridPoint c, GridPoint p) {
  std::array<GridPoint, 4> points = {a, b, c, p};
  std::ranges::sort(points, comes_before);
  for (int i = 3; i > 0; --i) {
    if (points[i] == p) return false;
    const std::int64_t turned = points[i] == c ? turn(a, b, p) : points[i] == b ? turn(a, p, c) : turn(p, b, c);
    if (turned != 0) return turned > 0;
  }
  return false;
}

// Returns whether p lies in the circle through the corners of a counter-clockwise triangle.
bool is_in_circle(GridPoint a, GridPoint b, GridPoint c, GridPoint p) {
  const GridPoint u{a.x - p.x, a.y - p.y}, v{b.x - p.x, b.y - p.y}, w{c.x - p.x, c.y - p.y};
  const auto squared = [](GridPoint q) { return q.x * q.x + q.y * q.y; };
  const auto area = [](GridPoint q, GridPoint r) { return q.x * r.y - q.y * r.x; };
  // differences are below 2^30, so squares and areas fit 64 bits
  const Wide lifted = Wide{squared(u)} * area(v, w) + Wide{squared(v)} * area(w, u) + Wide{squared(w)} * area(u, v);
  return lifted != 0 ? lifted > 0 : is_in_perturbed_circle(a, b, c, p);
}

bool is_between(GridPoint a, GridPoint b, GridPoint p) {
  return (p.x - a.x) * (b.x - p.x) + (p.y - a.y) * (b.y - p.y) > 0;
}

// Returns the place along Hilbert's curve of a point with coordinates below 2^16.
std::uint32_t place_on_curve(std::uint32_t x, std::uint32_t y) {
  std::uint32_t place = 0;
  for (std::uint32_t side = 1u << 15; side > 0; side /= 2) {
    const std::uint32_t east = (x & side) != 0, north = (y & side) != 0;
    place = place * 4 + ((3 * east) ^ north);
    if (north != 0) continue;
    if (east != 0) x = ~x, y = ~y;
    std::swap(x, y);
  }
  return place;
}

// Returns the points' numbers in an order in which neighbours follow each other.
std::vector<std::uint32_t> insertion_order(std::span<const GridPoint> points) {
  GridPoint min = points.front(), max = min;
  for (const GridPoint p : points) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
  int shift = 0;
  while (std::max(max.x - min.x, max.y - min.y) >> shift >= 1 << 16) ++shift;
  std::vector<std::uint64_t> keys;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto x = static_cast<std::uint32_t>((points[i].x - min.x) >> shift),
               y = static_cast<std::uint32_t>((points[i].y - min.y) >> shift);
    keys.push_back(std::uint64_t{place_on_curve(x, y)} << 32 | i);
  }
  std::ranges::sort(keys);
  std::vector<std::uint32_t> order;
  for (const std::uint64_t key : keys) order.push_back(static_cast<std::uint32_t>(key));
  return order;
}

}  // namespace

struct Delaunay::Triangulation {
  explicit Triangulation(std::span<const GridPoint> points)
      : vertices(points.begin(), points.end()), places(points), face_at(points.size(), kNoFace) {}

  std::vector<GridPoint> vertices;
  GridPointSet places;  // the vertices again
  std::vector<DelaunayFace> faces;
  std::vector<std::uint32_t> face_at;  // one per vertex: a face with this corner
  std::vector<std::uint32_t> changed;
  std::vector<std::uint32_t> unchecked{};  // faces with the new vertex whose opposite edge may have to be flipped

  int side_towards(std::uint32_t f, std::uint32_t neighbour) const {
    const auto& neighbours = faces[f].neighbours;
    return neighbours[0] == neighbour ? 0 : neighbours[1] == neighbour ? 1 : 2;
  }

  int corner_of(std::uint32_t f, std::uint32_t vertex) const {
    const auto& v = faces[f].vertices;
    return v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2;
  }

  int corner_beyond(std::uint32_t f) const {
    const auto& v = faces[f].vertices;
    return v[0] == kBeyond ? 0 : v[1] == kBeyond ? 1 : v[2] == kBeyond ? 2 : 3;
  }

  // Returns which way a point lies from the edge opposite to corner i, 0 on its line.
  std::int64_t side_of_edge(const DelaunayFace& face, int i, GridPoint p) const {
    return turn(vertices[face.vertices[next_corner(i)]], vertices[face.vertices[last_corner(i)]], p);
  }

  // Returns whether the face cannot stay if p is inserted: p lies in its circle or, beyond the hull, sees its edge.
  bool conflicts(std::uint32_t f, GridPoint p) const {
    const DelaunayFace& face = faces[f];
    const int i = corner_beyond(f);
    if (i == 3)
      return is_in_circle(vertices[face.vertices[0]], vertices[face.vertices[1]], vertices[face.vertices[2]], p);
    const std::int64_t side = side_of_edge(face, i, p);
    const GridPoint a = vertices[face.vertices[next_corner(i)]], b = vertices[face.vertices[last_corner(i)]];
    return side != 0 ? side > 0 : is_between(a, b, p);
  }

  void put(std::uint32_t f, const DelaunayFace& face) {
    faces[f] = face;
    for (const std::uint32_t v : face.vertices)
      if (v != kBeyond) face_at[v] = f;
  }

  // Tells a neighbour that another face lies on its side now.
  void replace_neighbour(std::uint32_t f, std::uint32_t old, std::uint32_t now) {
    if (f != kNoFace) faces[f].neighbours[side_towards(f, old)] = now;
  }

  // Flips edge i of a face: both faces get the corner opposite to it as their first.
  std::array<std::uint32_t, 2> flip(std::uint32_t f, int i) {
    const DelaunayFace one = faces[f];
    const std::uint32_t g = one.neighbours[i];
    const DelaunayFace other = faces[g];
    const int j = side_towards(g, f), i1 = next_corner(i), i2 = last_corner(i), j1 = next_corner(j),
              j2 = last_corner(j);
    const std::uint32_t a = one.vertices[i], b = one.vertices[i1], c = one.vertices[i2], d = other.vertices[j];
    put(f, {{a, b, d},
            {other.neighbours[j1], g, one.neighbours[i2]},
            {other.is_constrained[j1], false, one.is_constrained[i2]}});
    put(g, {{a, d, c},
            {other.neighbours[j2], one.neighbours[i1], f},
            {other.is_constrained[j2], one.is_constrained[i1], false}});
    replace_neighbour(other.neighbours[j1], g, f);
    replace_neighbour(one.neighbours[i1], f, g);
    return {f, g};
  }

  std::uint32_t add_face() {
    faces.emplace_back();
    return static_cast<std::uint32_t>(faces.size() - 1);
  }

  // Splits a face into three about a vertex.
  void split_face(std::uint32_t f, std::uint32_t vertex) {
    const DelaunayFace old = faces[f];
    const std::array<std::uint32_t, 3> parts = {f, add_face(), add_face()};
    for (int i = 0; i < 3; ++i) {
      const int i1 = next_corner(i), i2 = last_corner(i);
      put(parts[i], {{vertex, old.vertices[i1], old.vertices[i2]},
                     {old.neighbours[i], parts[i1], parts[i2]},
                     {old.is_constrained[i], false, false}});
      if (parts[i] != f) replace_neighbour(old.neighbours[i], f, parts[i]);
    }
    unchecked.assign(parts.begin(), parts.end());
  }

  // Splits edge i of a face, and both faces beside it, at a vertex.
  void split_edge(std::uint32_t f, int i, std::uint32_t vertex) {
    const std::uint32_t g = faces[f].neighbours[i], f2 = add_face(), g2 = add_face();
    const DelaunayFace one = faces[f], other = faces[g];
    const int j = side_towards(g, f), i1 = next_corner(i), i2 = last_corner(i), j1 = next_corner(j),
              j2 = last_corner(j);
    const std::uint32_t a = one.vertices[i], b = one.vertices[i1], c = one.vertices[i2], d = other.vertices[j];
    put(f, {{vertex, a, b}, {one.neighbours[i2], g2, f2}, {one.is_constrained[i2], false, false}});
    put(f2, {{vertex, c, a}, {one.neighbours[i1], f, g}, {one.is_constrained[i1], false, false}});
    put(g, {{vertex, d, c}, {other.neighbours[j2], f2, g2}, {other.is_constrained[j2], false, false}});
    put(g2, {{vertex, b, d}, {other.neighbours[j1], g, f}, {other.is_constrained[j1], false, false}});
    replace_neighbour(one.neighbours[i1], f, f2);
    replace_neighbour(other.neighbours[j1], g, g2);
    unchecked = {f, f2, g, g2};
  }

  // Flips edges until no face conflicts with the new vertex, which is the first corner of all unchecked faces.
  void flip_about(std::uint32_t vertex) {
    while (!unchecked.empty()) {
      const std::uint32_t f = unchecked.back(), beyond = faces[f].neighbours[0];
      unchecked.pop_back();
      if (faces[f].is_constrained[0] || beyond == kNoFace || !conflicts(beyond, vertices[vertex])) continue;
      for (const std::uint32_t turned : flip(f, 0)) unchecked.push_back(turned);
    }
  }

  // Walks towards p from a face; returns a face that contains p, or the first one beyond the hull. Which of two ways a
  // walk takes is drawn by chance, since it could go round in circles where edges are constrained.
  std::uint32_t face_containing(GridPoint p, std::uint32_t f) const {
    std::uint32_t before = kNoFace, chance = 1;
    while (f != kNoFace && corner_beyond(f) == 3) {
      const DelaunayFace& face = faces[f];
      chance = chance * 1664525u + 1013904223u;
      int i = static_cast<int>((chance >> 16) % 3), tried = 0;
      while (tried < 3 && ((before != kNoFace && face.neighbours[i] == before) || side_of_edge(face, i, p) >= 0))
        i = next_corner(i), ++tried;
      if (tried == 3) break;
      before = f, f = face.neighbours[i];
    }
    return f;
  }

  // Returns the edge of a face on which p lies; 3 if p lies inside.
  int edge_at(std::uint32_t f, GridPoint p) const {
    int i = 0;
    while (i < 3 && side_of_edge(faces[f], i, p) != 0) ++i;
    return i;
  }

  void insert(std::uint32_t vertex, std::uint32_t f) {
    const int edge = corner_beyond(f) == 3 ? edge_at(f, vertices[vertex]) : 3;
    if (edge == 3)
      split_face(f, vertex);
    else
      split_edge(f, edge, vertex);
    flip_about(vertex);
  }

  // Makes the first triangle, with faces beyond its edges. Returns false if all points are on one line.
  bool start(std::vector<std::uint32_t>& order) {
    std::size_t third = 2;
    while (third < order.size() && turn(vertices[order[0]], vertices[order[1]], vertices[order[third]]) == 0) ++third;
    if (third >= order.size()) return false;
    std::rotate(order.begin() + 2, order.begin() + static_cast<std::ptrdiff_t>(third),
                order.begin() + static_cast<std::ptrdiff_t>(third) + 1);
    if (turn(vertices[order[0]], vertices[order[1]], vertices[order[2]]) < 0) std::swap(order[0], order[1]);
    faces.resize(4);
    put(0, {{order[0], order[1], order[2]}, {1, 2, 3}, {}});
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t from = order[last_corner(i)], to = order[next_corner(i)];
      put(static_cast<std::uint32_t>(i + 1),
          {{kBeyond, from, to},
           {0, static_cast<std::uint32_t>(last_corner(i) + 1), static_cast<std::uint32_t>(next_corner(i) + 1)},
           {}});
    }
    for (const std::uint32_t v : {order[0], order[1], order[2]}) face_at[v] = 0;
    return true;
  }

  void insert_all() {
    std::vector<std::uint32_t> order = insertion_order(vertices);
    faces.reserve(2 * vertices.size() + 2);
    if (!start(order)) return;
    for (std::size_t n = 3; n < order.size(); ++n) {
      std::uint32_t near = face_at[order[n - 1]];
      // a face beyond the hull has one inside as its neighbour
      if (const int i = corner_beyond(near); i != 3) near = faces[near].neighbours[i];
      insert(order[n], face_containing(vertices[order[n]], near));
    }
  }

  // Returns the face to the left of the edge from a to b, and the edge's number in it. Where the edge is missing, the
  // face at a through which the line to b leaves, if any, with kCrossed added to its edge's number.
  static constexpr int kCrossed = 4;
  struct FoundEdge {
    std::uint32_t face;
    int i;
  };
  FoundEdge find_edge(std::uint32_t a, std::uint32_t b) const {
    for (std::uint32_t f = face_at[a];;) {
      const DelaunayFace& face = faces[f];
      const int i = corner_of(f, a);
      const std::uint32_t right = face.vertices[next_corner(i)], left = face.vertices[last_corner(i)];
      if (right == b) return {f, last_corner(i)};
      if (right != kBeyond && left != kBeyond && left != b && turn(vertices[a], vertices[b], vertices[right]) < 0 &&
          turn(vertices[a], vertices[b], vertices[left]) > 0)
        return {f, i + kCrossed};
      f = face.neighbours[next_corner(i)];
      if (f == face_at[a]) return {kNoFace, kCrossed};
    }
  }

  void set_constrained(std::uint32_t f, int i) {
    faces[f].is_constrained[i] = true;
    const std::uint32_t beyond = faces[f].neighbours[i];
    faces[beyond].is_constrained[side_towards(beyond, f)] = true;
  }

  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  // Returns the edges that the line from a to b crosses, the right end of each first.
  std::deque<Edge> crossed_edges(std::uint32_t a, std::uint32_t b, FoundEdge first) const {
    std::deque<Edge> crossed;
    std::uint32_t f = first.face;
    int i = first.i - kCrossed;
    for (;;) {
      const DelaunayFace& face = faces[f];
      crossed.emplace_back(face.vertices[next_corner(i)], face.vertices[last_corner(i)]);
      const std::uint32_t beyond = face.neighbours[i];
      const int tip = side_towards(beyond, f);
      const std::uint32_t v = faces[beyond].vertices[tip];
      if (v == b) return crossed;
      const std::int64_t side = turn(vertices[a], vertices[b], vertices[v]);
      assert(side != 0);
      // the corner after the tip is the left end
      f = beyond, i = side > 0 ? next_corner(tip) : last_corner(tip);
    }
  }

  bool is_convex_about(std::uint32_t f, int i) const {
    const DelaunayFace& face = faces[f];
    const std::uint32_t beyond = face.neighbours[i];
    const GridPoint a = vertices[face.vertices[i]], b = vertices[face.vertices[next_corner(i)]],
                    c = vertices[face.vertices[last_corner(i)]],
                    d = vertices[faces[beyond].vertices[side_towards(beyond, f)]];
    return turn(a, b, d) > 0 && turn(a, d, c) > 0;
  }

  // Flips crossed edges until the edge from a to b exists. Returns the edges that were made.
  std::deque<Edge> uncross(std::uint32_t a, std::uint32_t b, std::deque<Edge> crossed) {
    std::deque<Edge> made;
    for (; !crossed.empty(); crossed.pop_front()) {
      const auto [right, left] = crossed.front();
      const auto [f, i] = find_edge(right, left);
      assert(!faces[f].is_constrained[i]);
      if (!is_convex_about(f, i)) {
        crossed.push_back(crossed.front());
        continue;
      }
      flip(f, i);
      // the flipped edge joins the first two corners that the faces share
      const std::uint32_t from = faces[f].vertices[0], to = faces[f].vertices[2];
      const std::int64_t one = from == a || from == b ? 0 : turn(vertices[a], vertices[b], vertices[from]);
      const std::int64_t other = to == a || to == b ? 0 : turn(vertices[a], vertices[b], vertices[to]);
      if ((one < 0 && other > 0) || (one > 0 && other < 0))
        crossed.push_back(one < 0 ? Edge{from, to} : Edge{to, from});
      else
        made.emplace_back(from, to);
    }
    return made;
  }

  // Flips edges, and those about them, until all are Delaunay.
  void make_delaunay(std::deque<Edge> edges) {
    for (; !edges.empty(); edges.pop_front()) {
      const auto [f, i] = find_edge(edges.front().first, edges.front().second);
      // flipped away meanwhile
      if (i >= kCrossed || faces[f].is_constrained[i]) continue;
      const std::uint32_t beyond = faces[f].neighbours[i];
      if (corner_beyond(f) != 3 || corner_beyond(beyond) != 3) continue;
      if (!conflicts(beyond, vertices[faces[f].vertices[i]])) continue;
      for (const std::uint32_t turned : flip(f, i))
        for (int k = 0; k < 3; ++k)
          if (const auto& v = faces[turned].vertices; faces[turned].neighbours[k] != (turned == f ? beyond : f))
            edges.emplace_back(v[next_corner(k)], v[last_corner(k)]);
    }
  }

  void constrain(std::uint32_t a, std::uint32_t b) {
    FoundEdge found = find_edge(a, b);
    if (found.i < kCrossed) return set_constrained(found.face, found.i);
    std::deque<Edge> made = uncross(a, b, crossed_edges(a, b, found));
    found = find_edge(a, b);
    set_constrained(found.face, found.i);
    make_delaunay(std::move(made));
  }

  // Removes the faces beyond the hull.
  void remove_beyond() {
    std::vector<std::uint32_t> numbers(faces.size(), kNoFace);
    std::uint32_t count = 0;
    for (std::uint32_t f = 0; f < faces.size(); ++f)
      if (corner_beyond(f) == 3) numbers[f] = count++;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      if (numbers[f] == kNoFace) continue;
      DelaunayFace face = faces[f];
      for (std::uint32_t& neighbour : face.neighbours) neighbour = numbers[neighbour];
      put(numbers[f], face);
    }
    faces.resize(count);
  }

  // Lists the faces about an inner vertex, counter-clockwise.
  void list_faces_about(std::uint32_t vertex) {
    changed.clear();
    std::uint32_t f = face_at[vertex];
    do {
      changed.push_back(f);
      f = faces[f].neighbours[next_corner(corner_of(f, vertex))];
    } while (f != changed.front());
  }
};

Delaunay::Delaunay(std::span<const GridPoint> vertices, std::span<const std::pair<std::uint32_t, std::uint32_t>> edges)
    : triangulation_(std::make_unique<Triangulation>(vertices)) {
  assert(std::ranges::all_of(
      edges, [&](auto e) { return std::max(e.first, e.second) < vertices.size() && e.first != e.second; }));
  Triangulation& t = *triangulation_;
  if (vertices.size() < 3) return;
  t.insert_all();
  if (t.faces.empty()) return;
  for (const auto& [a, b] : edges) t.constrain(a, b);
  t.remove_beyond();
}

Delaunay::~Delaunay() = default;
Delaunay::Delaunay(Delaunay&&) noexcept = default;
Delaunay& Delaunay::operator=(Delaunay&&) noexcept = default;

const std::vector<GridPoint>& Delaunay::vertices() const { return triangulation_->vertices; }
const std::vector<DelaunayFace>& Delaunay::faces() const { return triangulation_->faces; }

std::uint32_t Delaunay::face_to_split(GridPoint p, std::uint32_t near) const {
  assert(near < faces().size());
  const Triangulation& t = *triangulation_;
  // refining asks for many vertices that the mesh has already, far from the face
  if (t.places.contains(p)) return kNoFace;
  const std::uint32_t f = t.face_containing(p, near);
  if (f == kNoFace) return kNoFace;
  const int edge = t.edge_at(f, p);
  return edge < 3 && (t.faces[f].is_constrained[edge] || t.faces[f].neighbours[edge] == kNoFace) ? kNoFace : f;
}

std::span<const std::uint32_t> Delaunay::insert(GridPoint p, std::uint32_t face) {
  assert(face < faces().size());
  Triangulation& t = *triangulation_;
  const auto vertex = static_cast<std::uint32_t>(t.vertices.size());
  t.vertices.push_back(p);
  t.face_at.push_back(kNoFace);
  t.places.insert(p);
  t.insert(vertex, face);
  t.list_faces_about(vertex);
  return t.changed;
}

std::span<const std::uint32_t> Delaunay::flip(std::uint32_t face, int i) {
  assert(face < faces().size() && i >= 0 && i < 3);
  assert(!faces()[face].is_constrained[i] && faces()[face].neighbours[i] != kNoFace);
  Triangulation& t = *triangulation_;
  const auto turned = t.flip(face, i);
  t.changed.assign(turned.begin(), turned.end());
  return t.changed;
}

}  // namespace citykiln
