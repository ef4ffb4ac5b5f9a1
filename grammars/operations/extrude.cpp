// Solids over faces: extrude, taper.
#include <algorithm>
#include <cmath>

#include "grammars/operations/operations.h"

namespace citykiln::grammars {
namespace {

Face moved(Face face, Vec3 by) {
  each_vertex(face, [&](Vec3& p) { p = p + by; });
  return face;
}

void add_sides(const Ring3& from, const Ring3& to, const std::vector<std::uint8_t>& street, std::vector<Face>& faces) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::size_t next = (i + 1) % from.size();
    if (length(from[next] - from[i]) <= kOnPlane_m) continue;
    Face& side = faces.emplace_back();
    side.outer = {from[i], from[next], to[next], to[i]};
    side.street = i < street.size() && street[i] != 0;
  }
}

// The normals of both faces point along the way from `lower` to `upper`.
void add_prism(const Face& lower, const Face& upper, std::vector<Face>& faces) {
  faces.push_back(reversed(lower));
  faces.push_back(upper);
  add_sides(lower.outer, upper.outer, lower.street_edges, faces);
  for (std::size_t i = 0; i < lower.holes.size(); ++i) add_sides(lower.holes[i], upper.holes[i], {}, faces);
}

Face without_tag(Face face) {
  face.tag = FaceTag::kNone;
  return face;
}

double highest_m(const std::vector<Face>& faces) {
  double top_m = -HUGE_VAL;
  for (const Face& face : faces)
    for (const Vec3 p : face.outer) top_m = std::max(top_m, p.z);
  return top_m;
}

void extrude_faces(Execution& execution, double height_m, std::string_view direction) {
  std::vector<Face> faces;
  faces.reserve(2 * execution.shape.faces.size() + vertex_count(execution.shape.faces));
  const double flat_top_m = highest_m(execution.shape.faces) + height_m;
  for (const Face& raw : execution.shape.faces) {
    const Face face = without_tag(raw);
    const Vec3 way = direction == "face.normal" ? normal_of(face) : Vec3{0, 0, 1};
    Face other = moved(face, way * height_m);
    if (direction == "world.up.flatTop") each_vertex(other, [&](Vec3& p) { p.z = flat_top_m; });
    // the base is the face that the extrusion leaves along its normal
    const bool is_base = (height_m >= 0) == (dot(way, normal_of(face)) >= 0);
    if (is_base) {
      add_prism(face, other, faces);
    } else {
      add_prism(other, face, faces);
    }
  }
  execution.shape.faces = std::move(faces);
}

Vec3 ring_middle(const Ring3& ring) {
  Vec3 sum;
  for (const Vec3 p : ring) sum = sum + p;
  return sum * (1.0 / static_cast<double>(ring.size()));
}

// Adds a pyramid and returns the largest distance of its apex from a corner, which bounds its displacement, because
// each triangle contains an edge of the face.
double add_pyramid(const Face& face, double height_m, std::vector<Face>& faces) {
  const Vec3 apex = ring_middle(face.outer) + normal_of(face) * height_m;
  double farthest_m = 0;
  faces.push_back(reversed(face));
  for (std::size_t i = 0; i < face.outer.size(); ++i) {
    faces.emplace_back().outer = {face.outer[i], face.outer[(i + 1) % face.outer.size()], apex};
    farthest_m = std::max(farthest_m, length(apex - face.outer[i]));
  }
  return farthest_m;
}

}  // namespace

void op_extrude(Execution& execution, const Statement&, Arguments arguments) {
  const std::string_view direction = arguments.size() == 1 ? "face.normal" : word_of(arguments[0]);
  const double height_m = metres(arguments.back());
  if (std::abs(height_m) <= kSmallest_m) return;
  double reach_m = std::abs(height_m);
  if (direction == "world.up.flatTop") reach_m += execution.shape.scope.diagonal_m();
  if (!execution.run.spend(8 * vertex_count(execution.shape.faces))) return;
  extrude_faces(execution, height_m, direction);
  execution.moved = execution.moved + Displacement{reach_m, 0};
  fit_scope(execution.shape);
}

void op_taper(Execution& execution, const Statement& statement, Arguments arguments) {
  const double height_m = metres(arguments[0]);
  std::vector<Face> faces;
  double reach_m = 0;
  for (const Face& face : execution.shape.faces) {
    if (!face.holes.empty() || height_m <= kSmallest_m) {
      execution.run.warn(statement.position, "taper is not built below zero or on faces with holes");
      return;
    }
    reach_m = std::max(reach_m, add_pyramid(face, height_m, faces));
  }
  execution.shape.faces = std::move(faces);
  execution.moved = execution.moved + Displacement{reach_m, 0};
  fit_scope(execution.shape);
}

}  // namespace citykiln::grammars
