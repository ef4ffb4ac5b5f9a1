// Operations that replace the faces of a shape: primitiveQuad, primitiveCube, primitiveCylinder, primitiveCone,
// primitiveSphere, primitiveDome, i.
#include <algorithm>

#include "grammars/operations/operations.h"
#include "grammars/shapes/round_body.h"

namespace citykiln::grammars {
namespace {

// Scope::corners(): bits 1, 2 and 4 of an index select the far side along x, y and z.
constexpr int kCube[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

// The deviation of round bodies at tolerance 0: a fiftieth of the radius, within these limits. So they have twelve
// sides up to a radius of half a metre, and no more sides than at a tolerance of 2 cm.
constexpr double kFinest_m = 0.001, kFinestOfLarge_m = 0.01, kFinestShare = 0.02;
// The share of the tolerance that round bodies take, so that rules for their faces have the rest.
constexpr double kRoundShare = 0.5;

void replace_faces(Execution& execution, std::vector<Face> faces, std::string asset, double deviation_m = 0) {
  const Ring3 before = surface_points(execution.shape);
  execution.shape.faces = std::move(faces);
  execution.shape.asset = std::move(asset);
  execution.shape.deviation_m = deviation_m;
  execution.moved = execution.moved + any_displacement(before, surface_points(execution.shape)) +
                    Displacement{deviation_m, deviation_m};
}

double allowed_deviation_m(const Execution& execution, int axis) {
  const double tolerance_m = execution.run.options.tolerance_m;
  if (tolerance_m > 0) return kRoundShare * tolerance_m;
  const auto& size_m = execution.shape.scope.size_m;
  const double radius_m = std::max(size_m[(axis + 1) % 3], size_m[(axis + 2) % 3]) / 2;
  return std::clamp(kFinestShare * radius_m, kFinest_m, kFinestOfLarge_m);
}

/// The axis and the sides of a round body, and the argument after them.
struct RoundArguments {
  int axis = 1;
  RoundSides sides;
  double third = 0;
};

// (axis, sides, third), (sides) or, as in CGA, (sides, radius, height), which set the scope's size.
RoundArguments round_arguments(Execution& execution, Arguments arguments) {
  RoundArguments round;
  const std::string_view word = arguments.empty() ? "" : word_of(arguments[0]);
  if (word == "x") round.axis = 0;
  if (word == "z") round.axis = 2;
  if (!word.empty()) arguments = arguments.subspan(1);
  const double sides = std::clamp(number_or(arguments, 0, 0), 0.0, 1.0 * RoundSides::kMost);
  round.sides.given = static_cast<int>(sides);
  if (!word.empty()) round.third = number_or(arguments, 1, 0);
  if (word.empty() && arguments.size() == 3) {
    const double across_m = 2 * std::max(number_or(arguments, 1, 0), 0.0);
    execution.shape.scope.size_m = {across_m, std::max(number_or(arguments, 2, 0), 0.0), across_m};
  }
  round.sides.most_m = allowed_deviation_m(execution, round.axis);
  return round;
}

void insert_round(Execution& execution, RoundBody body) {
  execution.run.spend(vertex_count(body.faces));
  replace_faces(execution, std::move(body.faces), "", body.deviation_m);
}

}  // namespace

void op_primitive_quad(Execution& execution, const Statement&, Arguments arguments) {
  Scope& scope = execution.shape.scope;
  scope.size_m = {number_or(arguments, 0, scope.size_m[0]), 0, number_or(arguments, 1, scope.size_m[2])};
  const double x_m = scope.size_m[0], z_m = scope.size_m[2];
  Face quad;
  quad.outer = {scope.to_space(0, 0, z_m), scope.to_space(x_m, 0, z_m), scope.to_space(x_m, 0, 0), scope.origin};
  replace_faces(execution, {std::move(quad)}, "");
}

void op_primitive_cube(Execution& execution, const Statement&, Arguments arguments) {
  Scope& scope = execution.shape.scope;
  for (std::size_t i = 0; i < 3; ++i) scope.size_m[i] = number_or(arguments, i, scope.size_m[i]);
  const auto corners = scope.corners();
  std::vector<Face> faces;
  for (const auto& side : kCube) {
    Face& face = faces.emplace_back();
    for (const int corner : side) face.outer.push_back(corners[static_cast<std::size_t>(corner)]);
  }
  replace_faces(execution, std::move(faces), "");
}

void op_primitive_cylinder(Execution& execution, const Statement&, Arguments arguments) {
  const RoundArguments round = round_arguments(execution, arguments);
  insert_round(execution, cylinder_in(execution.shape.scope, round.axis, 1, round.sides));
}

void op_primitive_cone(Execution& execution, const Statement&, Arguments arguments) {
  const RoundArguments round = round_arguments(execution, arguments);
  insert_round(execution, cylinder_in(execution.shape.scope, round.axis, round.third, round.sides));
}

void op_primitive_sphere(Execution& execution, const Statement&, Arguments arguments) {
  const RoundArguments round = round_arguments(execution, arguments);
  insert_round(execution, sphere_in(execution.shape.scope, round.axis, round.sides));
}

void op_primitive_dome(Execution& execution, const Statement&, Arguments arguments) {
  const RoundArguments round = round_arguments(execution, arguments);
  insert_round(execution, dome_in(execution.shape.scope, round.axis, round.sides));
}

void op_insert(Execution& execution, const Statement& statement, Arguments arguments) {
  const std::string name = text_of(arguments[0].value);
  if (name.empty()) return execution.run.warn(statement.position, "an asset without a name");
  replace_faces(execution, {}, name);
}

}  // namespace citykiln::grammars
