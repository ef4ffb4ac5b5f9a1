// The mesh of a car.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "compiler/materials/material_mesh.h"
#include "compiler/things/recipe.h"

namespace citykiln::cars {

/// The kinds of the two forms of a car: its painted shell, which has a colour, and all else, which cars of every colour
/// share. Neither needs a row of the table of things.
inline constexpr std::string_view kCar = "car", kCarParts = "car_parts";

/// The meshes of a form, and a bound of their Hausdorff distance to the full level, in metres.
struct CarMesh {
  std::vector<materials::MaterialMesh> meshes;  ///< Without triangles where the tolerance is not below the height.
  double error_m = 0;
};

/// Returns the form of what is on a car besides its paint.
things::Form parts_of(const things::Form& car);

/// Returns the mesh of a form of either kind whose value is a row of car_shapes.inc; std::nullopt for others. The
/// origin is on the ground below the middle, and the car faces -y. There are three levels: some 2,000 triangles with
/// wheel arches, lamps, mirrors and seams; 500, with wheels; and 100.
///
/// Guarantees: the same bytes on every CPU; error_m <= tolerance_m. Errors are Hausdorff distances of whole cars to the
/// first level, both ways, measured by car_mesh_test.cpp and rounded up. O(triangles).
std::optional<CarMesh> car_mesh(const things::Form& form, double tolerance_m);

}  // namespace citykiln::cars
