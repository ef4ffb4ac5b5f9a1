// Operations that move, turn and scale: t, r, s, center, alignScopeToAxes, alignScopeToGeometry, reverseNormals.
#include <algorithm>
#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "grammars/operations/operations.h"

namespace citykiln::grammars {
namespace {

/// Moves every vertex of the shape and adds the displacement.
template <typename Move>
void move_vertices(Execution& execution, Move move) {
  std::vector<Face> before;
  if (execution.run.measures()) before = execution.shape.faces;
  for (Face& face : execution.shape.faces) each_vertex(face, [&](Vec3& p) { p = move(p); });
  execution.moved = execution.moved + affine_displacement(before, execution.shape.faces);
}

// The surface of an asset counts as its scope.
void add_asset_displacement(Execution& execution, const Scope& before) {
  if (execution.shape.asset.empty()) return;
  const auto a = before.corners(), b = execution.shape.scope.corners();
  execution.moved = execution.moved + any_displacement(a, b);
}

void translate(Execution& execution, Vec3 by) {
  const Scope before = execution.shape.scope;
  move_vertices(execution, [&](Vec3 p) { return p + by; });
  execution.shape.scope.origin = before.origin + by;
  add_asset_displacement(execution, before);
}

/// v turned about a unit axis by Rodrigues' formula.
Vec3 turned(Vec3 v, Vec3 axis, double cosine, double sine) {
  return v * cosine + cross(axis, v) * sine + axis * (dot(axis, v) * (1 - cosine));
}

void turn(Execution& execution, int axis_index, double angle_deg, Vec3 about) {
  if (angle_deg == 0) return;
  const Scope before = execution.shape.scope;
  const Vec3 axis = before.axis[axis_index];
  const double c = cosine(angle_deg), s = sine(angle_deg);
  move_vertices(execution, [&](Vec3 p) { return about + turned(p - about, axis, c, s); });
  Scope& scope = execution.shape.scope;
  scope.origin = about + turned(before.origin - about, axis, c, s);
  for (Vec3& other : scope.axis) other = unit(turned(other, axis, c, s));
  add_asset_displacement(execution, before);
}

void set_axes(Shape& shape, const std::array<Vec3, 3>& axis) {
  const Vec3 origin = shape.scope.origin;
  shape.scope = scope_around(shape.faces, axis, origin);
}

/// Right-handed axes of which number `vertical` points up and the next is the nearest horizontal direction to its own.
std::array<Vec3, 3> axes_with_up(const Scope& scope, int vertical) {
  const Vec3 up{0, 0, 1};
  const Vec3 level = cross(up, scope.axis[(vertical + 2) % 3]);
  const Vec3 next = length(level) > 1e-6 ? unit(level) : unit(cross(up, Vec3{0, -1, 0}));
  std::array<Vec3, 3> axis;
  axis[vertical] = up;
  axis[(vertical + 1) % 3] = next;
  axis[(vertical + 2) % 3] = cross(up, next);
  return axis;
}

}  // namespace

void op_translate(Execution& execution, const Statement&, Arguments arguments) {
  const Scope& scope = execution.shape.scope;
  Vec3 by;
  for (int i = 0; i < 3; ++i) by = by + scope.axis[i] * size_or_share(arguments[i], scope.size_m[i]);
  translate(execution, by);
}

void op_rotate(Execution& execution, const Statement&, Arguments arguments) {
  const Scope& scope = execution.shape.scope;
  const bool about_centre = arguments.size() == 4 && word_of(arguments[0]) == "scopeCenter";
  const Vec3 about = about_centre ? scope.centre() : scope.origin;
  const Arguments angles = arguments.last(3);
  for (int i = 0; i < 3; ++i) turn(execution, i, metres(angles[i]), about);
}

void op_size(Execution& execution, const Statement&, Arguments arguments) {
  const Scope before = execution.shape.scope;
  std::array<double, 3> factor;
  Scope& scope = execution.shape.scope;
  for (int i = 0; i < 3; ++i) {
    const double size_m = std::max(size_or_share(arguments[i], before.size_m[i]), 0.0);
    factor[i] = before.size_m[i] > kSmallest_m ? size_m / before.size_m[i] : 1;
    scope.size_m[i] = size_m;
  }
  move_vertices(execution, [&](Vec3 p) {
    Vec3 moved = before.origin;
    for (int i = 0; i < 3; ++i) moved = moved + before.axis[i] * (dot(before.axis[i], p - before.origin) * factor[i]);
    return moved;
  });
  execution.shape.deviation_m *= std::max({1.0, factor[0], factor[1], factor[2]});
  add_asset_displacement(execution, before);
}

void op_center(Execution& execution, const Statement&, Arguments arguments) {
  const Scope& scope = execution.shape.scope;
  // the parent scope was assigned together with the later of both indices
  execution.run.depends_on(std::max(execution.shape.in_split.since_node, execution.shape.in_comp.since_node));
  const Vec3 way = execution.shape.parent_scope.centre() - scope.centre();
  const std::string_view axes = word_of(arguments[0]);
  Vec3 by;
  for (int i = 0; i < 3; ++i)
    if (axes.find("xyz"[i]) != std::string_view::npos) by = by + scope.axis[i] * dot(scope.axis[i], way);
  translate(execution, by);
}

void op_align_to_axes(Execution& execution, const Statement&, Arguments arguments) {
  execution.run.depends_on(0);
  const std::string_view word = arguments.empty() ? "" : word_of(arguments[0]);
  const int vertical = word == "x" ? 0 : word == "z" ? 2 : 1;
  const std::array<Vec3, 3> east = {Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}};
  set_axes(execution.shape, word.empty() ? east : axes_with_up(execution.shape.scope, vertical));
}

void op_align_to_geometry(Execution& execution, const Statement&, Arguments) {
  if (execution.shape.faces.empty()) return;
  std::array<Vec3, 3> axis = axes_of(execution.shape.faces.front());
  // y is up in the scope of a horizontal face, as in that of a lot
  if (std::abs(axis[2].z) > 0.9999) axis = {axis[0], axis[2], axis[1] * -1.0};
  set_axes(execution.shape, axis);
}

void op_reverse_normals(Execution& execution, const Statement&, Arguments) {
  for (Face& face : execution.shape.faces) face = reversed(face);
}

}  // namespace citykiln::grammars
