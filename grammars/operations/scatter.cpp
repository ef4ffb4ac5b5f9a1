// scatter: shapes of points at random places on a surface, or in the scope.
#include <algorithm>

#include "compiler/geometry/triangles/triangulate.h"
#include "grammars/derivation/evaluate.h"
#include "grammars/operations/operations.h"

namespace citykiln::grammars {
namespace {

/// A triangle of the surface, and the area of all triangles up to it.
struct SurfaceTriangle {
  Vec3 a, b, c, normal;
  double sum_m2 = 0;
};

std::vector<SurfaceTriangle> surface_triangles(std::span<const Face> faces) {
  std::vector<SurfaceTriangle> triangles;
  double sum_m2 = 0;
  for (const Face& face : faces) {
    if (face.outer.size() < 3) continue;
    const FaceFrame frame = frame_of(face);
    const PlaneTriangles plane = triangulate(flat(face, frame));
    const auto corner = [&](const Triangle& t, std::size_t i) { return frame.to_space(plane.points[t[i]]); };
    for (const Triangle& t : plane.triangles) {
      const Vec3 a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
      sum_m2 += length(cross(b - a, c - a)) / 2;
      triangles.push_back({a, b, c, frame.z, sum_m2});
    }
  }
  return triangles;
}

Shape point_shape(const Shape& from, Vec3 p) {
  Shape shape = inherited_from(from);
  shape.parent_scope = from.scope;
  shape.scope.origin = p;
  shape.scope.size_m = {0, 0, 0};
  shape.faces.emplace_back().outer = {p};
  return shape;
}

// y along the normal and x as level as it can be, as CGA has it.
std::array<Vec3, 3> axes_on_surface(Vec3 normal, const Scope& scope) {
  const Vec3 level = cross(normal, scope.axis[2]);
  const Vec3 x = length(level) > 1e-6 ? unit(level) : scope.axis[0];
  return {x, normal, cross(x, normal)};
}

Shape on_surface(const Shape& from, std::span<const SurfaceTriangle> triangles, double area, double u, double v) {
  const double at_m2 = area * triangles.back().sum_m2;
  auto t = std::ranges::lower_bound(triangles, at_m2, {}, &SurfaceTriangle::sum_m2);
  if (t == triangles.end()) --t;
  if (u + v > 1) u = 1 - u, v = 1 - v;
  Shape shape = point_shape(from, t->a + (t->b - t->a) * u + (t->c - t->a) * v);
  shape.scope.axis = axes_on_surface(t->normal, from.scope);
  return shape;
}

Shape in_scope(const Shape& from, double u, double v, double w) {
  const Scope& scope = from.scope;
  return point_shape(from, scope.to_space(u * scope.size_m[0], v * scope.size_m[1], w * scope.size_m[2]));
}

// Between the surface and points, whose box stands for them.
Displacement displacement_to_points(const Shape& shape, std::span<const Piece> pieces) {
  std::vector<Face> points;
  for (const Piece& piece : pieces) points.push_back(piece.shape.faces.front());
  const auto corners = scope_around(points, shape.scope.axis, shape.scope.origin).corners();
  return pieces.empty() ? Displacement{} : any_displacement(surface_points(shape), corners);
}

}  // namespace

void op_scatter(Execution& execution, const Statement& statement, Arguments arguments) {
  Run& run = execution.run;
  const bool is_on_surface = word_of(arguments[0]) == "surface";
  const std::vector<SurfaceTriangle> triangles = surface_triangles(execution.shape.faces);
  if (is_on_surface && triangles.empty())
    return run.warn(statement.position, "the shape has no surface; no points are scattered");
  const double most = static_cast<double>(run.options.limits.shapes);
  const auto count = static_cast<std::size_t>(std::clamp(metres(arguments[1]), 0.0, most));
  if (count + run.out.shapes > run.options.limits.shapes)
    return run.hit(LimitKind::kShapes, execution.name, statement.position);
  Context context = context_of(execution);
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = draw_unit(context), u = draw_unit(context), v = draw_unit(context);
    Shape shape = is_on_surface ? on_surface(execution.shape, triangles, a, u, v) : in_scope(execution.shape, a, u, v);
    shape.in_comp = {static_cast<double>(i), static_cast<double>(count)};
    pieces.push_back({std::move(shape), &statement.selectors.front().body});
  }
  const Displacement moved = displacement_to_points(execution.shape, pieces);
  spawn_pieces(execution, std::move(pieces), moved);
}

}  // namespace citykiln::grammars
