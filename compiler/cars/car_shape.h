// The shapes of cars: the numbers that a body is made from.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/things/recipe.h"

namespace citykiln::cars {

/// A row of car_shapes.inc, with the size of its body. Values in metres: sill, nose, cowl, tail and belts are heights
/// above the ground, wheel and corner are radii, all others lie along the car from its front end. `lean` is a ratio.
struct CarShape {
  std::string_view body;
  double sill_m = 0, wheel_m = 0, front_axle_m = 0, rear_axle_m = 0, nose_m = 0;
  double screen_from_m = 0, cowl_m = 0, screen_to_m = 0, rear_from_m = 0, rear_to_m = 0, tail_m = 0;
  double belt_m = 0, rear_belt_m = 0, lean = 0, corner_m = 0;
  bool is_clad = false;
  std::span<const double> windows{};  ///< From, to, from, to.
  double width_m = 0, length_m = 0, height_m = 0;
};

/// Returns the shape for a form of kind kCar or kCarParts by the body in its value; std::nullopt for other forms.
std::optional<CarShape> shape_of(const things::Form& form);

/// The number of points of half a section of a body, from the sill to the middle of the roof.
inline constexpr std::size_t kSectionPoints = 10;
/// Half a section at x >= 0. 0: sill, 1: above it, 2: the widest, 3: shoulder, 4: lower edge of the windows, 5: window
/// below, 6: window above, 7: edge of the roof, 8: half of the roof, 9: its middle.
using Section = std::array<Vec3, kSectionPoints>;

/// The shape of a body as sections. A section is not plane: at the ends, bodies are round in plan and lean back.
class Sections {
 public:
  explicit Sections(const CarShape& shape);

  /// Returns the section at a distance from the front end, interpolated linearly between the two nearest key sections.
  /// Its y is the distance along too, moved by the rounding of the ends.
  Section at(double along_m) const;

  /// Distances along at which the profile or the width bends; and those that matter for the sides below the windows.
  const std::vector<double>& keys() const { return keys_; }
  const std::vector<double>& side_keys() const { return side_keys_; }

 private:
  Section key_section(const CarShape& shape, double along_m) const;

  std::vector<double> keys_, side_keys_;
  std::vector<Section> sections_;
};

/// True in the open bed of a pickup.
bool is_bed(const CarShape& shape, double along_m);

}  // namespace citykiln::cars
