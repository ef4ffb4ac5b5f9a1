// Bands along the edges of faces: setback, offset.
#include <algorithm>
#include <cmath>

#include "compiler/geometry/polygons/offset_polygon.h"
#include "compiler/geometry/segment.h"
#include "grammars/operations/face_parts.h"
#include "grammars/operations/operations.h"
#include "grammars/shapes/cut.h"

namespace citykiln::grammars {
namespace {

constexpr double kSnap_m = 1e-4;  // what comes back from the overlay's grid and was a vertex is that vertex again

struct FaceEdge {
  Vec3 a, b;
  bool street = false;
};

std::vector<FaceEdge> face_edges(const Face& face) {
  std::vector<FaceEdge> edges;
  const auto add = [&](const Ring3& ring, const std::vector<std::uint8_t>& street) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      edges.push_back({ring[i], ring[(i + 1) % ring.size()], i < street.size() && street[i] != 0});
  };
  add(face.outer, face.street_edges);
  for (const Ring3& hole : face.holes) add(hole, {});
  return edges;
}

std::string side_of_edge(const Scope& scope, const Face& face, const FaceEdge& edge) {
  const PlanAxes axes = plan_axes(scope, face);
  const Vec3 outward = cross(unit(edge.b - edge.a), normal_of(face));
  const double ahead = dot(outward, axes.front), aside = dot(outward, axes.right);
  if (std::abs(ahead) >= std::abs(aside) - 1e-9) return ahead > 0 ? "front" : "back";
  return aside > 0 ? "right" : "left";
}

bool selects_edge(const Key& key, std::size_t index, const Scope& scope, const Face& face, const FaceEdge& edge) {
  if (key.index) return *key.index == index;
  if (key.word == "all") return true;
  if (key.word == "street" || key.word == "street.front") return edge.street;
  if (key.word == "street.back") return !edge.street;
  return key.word == side_of_edge(scope, face, edge);
}

std::vector<int> selectors_of(const std::vector<Key>& keys, const Scope& scope, const Face& face,
                              const std::vector<FaceEdge>& edges) {
  std::vector<int> chosen(edges.size(), -1);
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t k = 0; k < keys.size() && chosen[i] < 0; ++k)
      if (selects_edge(keys[k], i, scope, face, edges[i])) chosen[i] = static_cast<int>(k);
  return chosen;
}

/// The result of an offset, in space.
struct FaceOffset {
  std::vector<Face> moved;
  std::vector<std::vector<Face>> bands;  ///< Per edge.
  bool on_grid = false;
  double reach_m = 0;  ///< No band's point is farther from its edge: distance to a segment is largest at a vertex.
};

// Limits depths to the length of the border, which is larger than any distance within the face, since greater depths
// lose digits. Bands that would snap to their edge are left out.
std::vector<double> limited_depths(std::vector<double> depths_m, const std::vector<FaceEdge>& edges) {
  double border_m = 0;
  for (const FaceEdge& edge : edges) border_m += length(edge.b - edge.a);
  for (double& depth_m : depths_m) depth_m = depth_m <= kSnap_m ? 0 : std::min(depth_m, border_m);
  return depths_m;
}

// Offsets are computed on the plane's grid. Larger faces come from rules that scale without bound: they have no bands.
constexpr double kMaxExtent_m = 100000;

bool fits_grid(const Polygon& polygon) {
  return std::ranges::all_of(polygon.outer,
                             [](Vec2 p) { return std::max(std::abs(p.x), std::abs(p.y)) <= kMaxExtent_m; });
}

FaceOffset cut_bands(const Face& face, const std::vector<double>& depth_m, bool outward) {
  const FaceFrame frame = frame_of(face);
  const Polygon polygon = flat(face, frame);
  if (!fits_grid(polygon)) return {};
  const std::vector<FaceEdge> edges = face_edges(face);
  const OffsetPolygon offset = outward ? outset(polygon, depth_m) : inset(polygon, limited_depths(depth_m, edges));
  FaceOffset cut;
  cut.on_grid = offset.on_grid;
  for (const Polygon& moved : offset.moved) cut.moved.push_back(lifted(moved, frame, face, kSnap_m));
  for (std::size_t i = 0; i < offset.bands.size(); ++i) {
    auto& bands = cut.bands.emplace_back();
    for (const Polygon& band : offset.bands[i]) {
      bands.push_back(lifted(band, frame, face, kSnap_m));
      each_vertex(bands.back(),
                  [&](Vec3 p) { cut.reach_m = std::max(cut.reach_m, distance_to_segment(edges[i].a, edges[i].b, p)); });
    }
  }
  return cut;
}

// Returns true if the parts were rounded to the grid of the overlay.
bool add_setback(Execution& execution, const std::vector<Key>& keys, int remainder, const Face& face, double depth_m,
                 std::vector<PartOf>& parts) {
  const std::vector<FaceEdge> edges = face_edges(face);
  const std::vector<int> chosen = selectors_of(keys, execution.shape.scope, face, edges);
  std::vector<double> depths_m;
  for (const int selector : chosen) depths_m.push_back(selector < 0 ? 0 : depth_m);
  FaceOffset cut = cut_bands(face, depths_m, false);
  for (std::size_t i = 0; i < cut.bands.size(); ++i)
    for (Face& band : cut.bands[i]) parts.push_back({std::move(band), chosen[i]});
  for (Face& rest : cut.moved) parts.push_back({std::move(rest), remainder});
  return cut.on_grid;
}

// Bounds what the grid of the overlay moves points.
constexpr Displacement kOfTheGrid = {1e-4, 1e-4};

void tag(std::vector<Face>& faces, FaceTag as) {
  for (Face& face : faces) face.tag = as;
}

// With mitres up to 64 times as long, larger offsets would leave the range of the grid.
constexpr double kMaxOffset_m = 1000;

void add_offset(const Face& face, double by_m, std::string_view which, std::vector<Face>& faces, double& reach_m) {
  FaceOffset cut =
      cut_bands(face, std::vector<double>(face_edges(face).size(), std::min(std::abs(by_m), kMaxOffset_m)), by_m > 0);
  reach_m = std::max(reach_m, cut.reach_m);
  tag(cut.moved, FaceTag::kInside);
  for (auto& bands : cut.bands) tag(bands, FaceTag::kBorder);
  // the inside of an enlarged face is the face itself, the border is outside of it
  if (by_m > 0 && which == "all") cut.moved = {face}, tag(cut.moved, FaceTag::kInside);
  if (which != "border") faces.insert(faces.end(), cut.moved.begin(), cut.moved.end());
  if (which == "inside") return;
  for (auto& bands : cut.bands) faces.insert(faces.end(), bands.begin(), bands.end());
}

bool can_spend(Execution& execution, const Statement& statement) {
  std::uint64_t steps = 0;
  for (const Face& face : execution.shape.faces) {
    const std::uint64_t n = vertex_count({&face, 1});
    steps += n * n;
  }
  if (execution.run.spend(steps)) return true;
  execution.run.hit(LimitKind::kSteps, execution.name, statement.position);
  return false;
}

}  // namespace

void op_setback(Execution& execution, const Statement& statement, Arguments arguments) {
  constexpr const char* kWords = " front back left right all street street.front street.back remainder ";
  const double depth_m = metres(arguments[0]);
  if (!can_spend(execution, statement)) return;
  if (depth_m < 0) return execution.run.warn(statement.position, "a setback below zero; offset goes outward");
  std::vector<Key> keys = keys_of(execution, statement, kWords);
  const int remainder = index_of(keys, "remainder");
  std::vector<PartOf> parts;
  bool on_grid = false;
  for (const Face& face : execution.shape.faces)
    on_grid |= add_setback(execution, keys, remainder, face, depth_m, parts);
  const Displacement moved = of_cutting(execution.shape.faces);
  spawn_parts(execution, statement, std::move(parts), on_grid ? moved + kOfTheGrid : moved);
}

void op_offset(Execution& execution, const Statement& statement, Arguments arguments) {
  const double by_m = metres(arguments[0]);
  if (std::abs(by_m) <= kSmallest_m || !can_spend(execution, statement)) return;
  const std::string_view which = arguments.size() > 1 ? word_of(arguments[1]) : "all";
  const Ring3 before = vertices_of(execution.shape.faces);
  std::vector<Face> faces;
  double reach_m = kOfTheGrid.to_earlier_m;
  for (const Face& face : execution.shape.faces) add_offset(face, by_m, which, faces, reach_m);
  execution.shape.faces = std::move(faces);
  Displacement moved{by_m > 0 ? reach_m : kOfTheGrid.to_earlier_m, kOfTheGrid.to_later_m};
  // without a part, the rest may be far from the surface
  if (which != "all" && (by_m < 0 || which == "border"))
    moved = any_displacement(before, vertices_of(execution.shape.faces));
  execution.moved = execution.moved + moved;
  fit_scope(execution.shape);
}

}  // namespace citykiln::grammars
