// Operations that replace the faces of a shape: primitiveQuad, primitiveCube, i.
#include "grammars/operations/operations.h"

namespace citykiln::grammars {
namespace {

// Scope::corners(): bits 1, 2 and 4 of an index select the far side along x, y and z.
constexpr int kCube[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

void replace_faces(Execution& execution, std::vector<Face> faces, std::string asset) {
  const Ring3 before = surface_points(execution.shape);
  execution.shape.faces = std::move(faces);
  execution.shape.asset = std::move(asset);
  execution.moved = execution.moved + any_displacement(before, surface_points(execution.shape));
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

void op_insert(Execution& execution, const Statement& statement, Arguments arguments) {
  const std::string name = text_of(arguments[0].value);
  if (name.empty()) return execution.run.warn(statement.position, "an asset without a name");
  replace_faces(execution, {}, name);
}

}  // namespace citykiln::grammars
