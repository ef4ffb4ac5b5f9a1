#include "grammars/operations/edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "grammars/operations/face_parts.h"
#include "grammars/operations/operations.h"

namespace citykiln::grammars {
namespace {

/// An edge of the faces, in the direction in which the first face with it runs.
struct SharedEdge {
  Vec3 from, to, normal;
  int faces = 0;  ///< The number of faces with this edge.
};

constexpr const char* kEdgeWords = " all vertical horizontal aslant border inside top bottom ";
constexpr double kNearlyLevel = 0.01;

void add_shared_edges(const Ring3& ring, Vec3 normal, std::vector<SharedEdge>& edges,
                      std::map<std::pair<Vec3, Vec3>, std::size_t>& known) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 a = ring[i], b = ring[(i + 1) % ring.size()];
    if (length(b - a) <= kSmallest_m) continue;
    const auto [place, is_new] = known.try_emplace({std::min(a, b), std::max(a, b)}, edges.size());
    if (is_new) edges.push_back({a, b, normal});
    ++edges[place->second].faces;
  }
}

std::vector<SharedEdge> edges_of(std::span<const Face> faces) {
  std::vector<SharedEdge> edges;
  std::map<std::pair<Vec3, Vec3>, std::size_t> known;
  for (const Face& face : faces) {
    const Vec3 normal = normal_of(face);
    add_shared_edges(face.outer, normal, edges, known);
    for (const Ring3& hole : face.holes) add_shared_edges(hole, normal, edges, known);
  }
  return edges;
}

/// The lowest and the highest z of the faces.
std::pair<double, double> lowest_and_highest(std::span<const SharedEdge> edges) {
  double low_m = HUGE_VAL, high_m = -HUGE_VAL;
  for (const SharedEdge& edge : edges) {
    low_m = std::min({low_m, edge.from.z, edge.to.z});
    high_m = std::max({high_m, edge.from.z, edge.to.z});
  }
  return {low_m, high_m};
}

bool selects_shared_edge(std::string_view word, const SharedEdge& edge, std::pair<double, double> heights_m) {
  const double rise = std::abs(unit(edge.to - edge.from).z);
  if (word == "all") return true;
  if (word == "vertical") return rise > 1 - kNearlyLevel;
  if (word == "horizontal") return rise < kNearlyLevel;
  if (word == "aslant") return rise >= kNearlyLevel && rise <= 1 - kNearlyLevel;
  if (word == "border") return edge.faces == 1;
  if (word == "inside") return edge.faces > 1;
  if (word == "bottom") return std::max(edge.from.z, edge.to.z) - heights_m.first < kSmallest_m;
  return word == "top" && heights_m.second - std::min(edge.from.z, edge.to.z) < kSmallest_m;
}

int selector_of_edge(const std::vector<Key>& keys, const SharedEdge& edge, std::size_t index,
                     std::pair<double, double> heights_m) {
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (keys[k].index ? *keys[k].index == index : selects_shared_edge(keys[k].word, edge, heights_m))
      return static_cast<int>(k);
  return -1;
}

Shape edge_shape(const Shape& from, SharedEdge edge) {
  Shape shape = inherited_from(from);
  shape.parent_scope = from.scope;
  if (std::abs(unit(edge.to - edge.from).z) > 1 - kNearlyLevel && edge.to.z < edge.from.z)
    std::swap(edge.from, edge.to);
  const Vec3 along = unit(edge.to - edge.from);
  shape.scope.axis = {along, edge.normal, cross(along, edge.normal)};
  shape.scope.origin = edge.from;
  shape.scope.size_m = {length(edge.to - edge.from), 0, 0};
  shape.faces.emplace_back().outer = {edge.from, edge.to};
  return shape;
}

// A point of a face is within half the shorter side of its bounding box of an edge.
double farthest_from_edges_m(std::span<const Face> faces) {
  double most_m = 0;
  for (const Face& face : faces) {
    const Scope box = scope_around(std::span(&face, 1), axes_of(face), {});
    most_m = std::max(most_m, std::min(box.size_m[0], box.size_m[1]) / 2);
  }
  return most_m;
}

}  // namespace

void comp_edges(Execution& execution, const Statement& statement) {
  const std::vector<Key> keys = keys_of(execution, statement, kEdgeWords);
  const Shape& from = execution.shape;
  const std::vector<SharedEdge> edges = edges_of(from.faces);
  const auto heights_m = lowest_and_highest(edges);
  std::vector<std::vector<Piece>> by_selector(keys.size() + 1);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const int selector = selector_of_edge(keys, edges[i], i, heights_m);
    const auto k = selector < 0 ? keys.size() : static_cast<std::size_t>(selector);
    by_selector[k].push_back({edge_shape(from, edges[i]), selector < 0 ? nullptr : &statement.selectors[k].body});
  }
  std::vector<Piece> pieces;
  for (std::vector<Piece>& selected : by_selector) {
    const double total = static_cast<double>(selected.size());
    for (std::size_t i = 0; i < selected.size(); ++i) {
      selected[i].shape.in_comp = {static_cast<double>(i), total};
      pieces.push_back(std::move(selected[i]));
    }
  }
  spawn_pieces(execution, std::move(pieces), {0, farthest_from_edges_m(from.faces)});
}

}  // namespace citykiln::grammars
