#include "compiler/cars/car_mesh.h"

#include <algorithm>
#include <array>

#include "compiler/cars/car_body.h"

namespace citykiln::cars {
namespace {

// Errors of the levels, in metres, and the least tolerances at which they are shown.
constexpr std::array<double, 3> kErrors_m = {0, 0.4, 0.75};

CarLevel level_at(double tolerance_m) {
  std::size_t level = kErrors_m.size() - 1;
  while (kErrors_m[level] > tolerance_m) --level;
  return static_cast<CarLevel>(level);
}

materials::Tint paint_of(const things::Form& form) {
  materials::Tint tint = materials::kNoTint;
  if (!form.colour) return tint;
  // a tint multiplies the reflectance of the paint, 0.9
  for (std::size_t c = 0; c < 3; ++c)
    tint[c] =
        static_cast<std::uint8_t>(std::min(255.0, materials::linear_of_srgb((*form.colour)[c]) / 0.9 * 255 + 0.5));
  return tint;
}

}  // namespace

things::Form parts_of(const things::Form& car) {
  things::Form parts = car;
  parts.kind = kCarParts, parts.colour.reset();
  return parts;
}

std::optional<CarMesh> car_mesh(const things::Form& form, double tolerance_m) {
  const std::optional<CarShape> shape = shape_of(form);
  if (!shape) return std::nullopt;
  if (form.height_m <= tolerance_m) return CarMesh{{}, form.height_m};
  const CarLevel level = level_at(tolerance_m);
  const CarSurfaces surfaces = car_surfaces(paint_of(form));
  Facets facets;
  add_body(*shape, level, surfaces, facets);
  add_wheels(*shape, level, surfaces, facets);
  return CarMesh{meshes_of(facets, form.kind == kCar), kErrors_m[static_cast<std::size_t>(level)]};
}

}  // namespace citykiln::cars
