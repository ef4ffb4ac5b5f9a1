// comp: one shape for each face, comp(f), or for each edge, comp(e).
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "grammars/derivation/evaluate.h"
#include "grammars/derivation/execution.h"
#include "grammars/operations/face_parts.h"
#include "grammars/operations/operations.h"

namespace citykiln::grammars {
namespace {

// An edge of the faces, in the direction in which the first face with it runs.
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

// The lowest and the highest z of the faces.
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

// Applies the bodies of the selectors to the edges of the shape's faces, each edge once. The shape of an edge has one
// face of two points, which is not drawn; its scope has x along the edge (upwards, if the edge is vertical), y along
// the normal of the first face with that edge, and no size along y and z. A primitive fills it after s().
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

bool is_vertical(Vec3 normal) { return std::abs(normal.z) < 0.01; }
bool is_level(Vec3 normal) { return std::abs(normal.z) > 0.9999; }

// The tag of a face takes precedence over its direction: a steep roof plane is top.
std::string_view side_of_face(const Scope& scope, const Face& face, Vec3 normal) {
  if (face.tag == FaceTag::kTop) return "top";
  if (face.tag == FaceTag::kBottom) return "bottom";
  const NearestAxis nearest = nearest_axis(scope, normal);
  // in the scope of a horizontal face z is up and y points to the back
  const bool lies = std::abs(scope.axis[1].z) < 0.01 && std::abs(scope.axis[2].z) > 0.9;
  if (lies && nearest.axis == 2) return nearest.against ? "bottom" : "top";
  if (lies && nearest.axis == 1) return nearest.against ? "front" : "back";
  if (nearest.axis == 1) return nearest.against ? "bottom" : "top";
  if (nearest.axis == 2) return nearest.against ? "back" : "front";
  return nearest.against ? "left" : "right";
}

bool is_side(std::string_view side) { return side != "top" && side != "bottom"; }

bool selects_face(std::string_view word, std::string_view side, Vec3 normal, const Face& face) {
  if (word == "all" || word == side) return true;
  if (word == "side") return is_side(side);
  if (word == "vertical") return is_vertical(normal);
  if (word == "horizontal") return is_level(normal);
  if (word == "aslant") return !is_vertical(normal) && !is_level(normal);
  if (word == "inside") return face.tag == FaceTag::kInside;
  if (word == "border") return face.tag == FaceTag::kBorder;
  if (word == "street" || word == "street.front") return face.street && is_side(side);
  if (word == "street.back") return !face.street && is_side(side);
  return false;
}

const char* name_of(FaceTag tag) {
  if (tag == FaceTag::kVertical) return "vertical";
  if (tag == FaceTag::kInside) return "inside";
  return tag == FaceTag::kBorder ? "border" : "";
}

// A selector of the face's tag takes precedence, else the first selector that fits. So gables and rims of eaves are no
// walls, even if `side` comes first.
int selector_of(const std::vector<Key>& keys, const Scope& scope, const Face& face, std::size_t index) {
  const std::string_view own = name_of(face.tag);
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (!own.empty() && !keys[k].index && keys[k].word == own) return static_cast<int>(k);
  const Vec3 normal = normal_of(face);
  const std::string_view side = side_of_face(scope, face, normal);
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (keys[k].index ? *keys[k].index == index : selects_face(keys[k].word, side, normal, face))
      return static_cast<int>(k);
  return -1;
}

constexpr const char* kWords =
    " all front back left right top bottom side vertical horizontal aslant inside border street street.front "
    "street.back ";

}  // namespace

void op_comp(Execution& execution, const Statement& statement, Arguments arguments) {
  if (word_of(arguments[0]) == "e") return comp_edges(execution, statement);
  const std::vector<Key> keys = keys_of(execution, statement, kWords);
  std::vector<PartOf> parts;
  parts.reserve(execution.shape.faces.size());
  const Scope scope = execution.shape.scope;
  for (std::size_t i = 0; i < execution.shape.faces.size(); ++i) {
    const Face& face = execution.shape.faces[i];
    parts.push_back({face, selector_of(keys, scope, face, i)});
  }
  spawn_parts(execution, statement, std::move(parts), {});
}

}  // namespace citykiln::grammars
