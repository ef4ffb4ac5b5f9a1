#include "compiler/cars/car_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>

#include "compiler/cars/car_models.h"
#include "compiler/geometry/snap.h"

namespace citykiln::cars {
namespace {

constexpr double kFine_m = 0.1, kPlain_m = 0.5, kOutline_m = 1;
using Corners = std::array<Vec3, 3>;

std::vector<things::Form> all_forms() {
  std::vector<things::Form> forms;
#define CAR_BODY(name, width, length, height, ...) \
  forms.push_back({.kind = "car", .width_m = width, .depth_m = length, .height_m = height, .value = name});
#include "compiler/cars/car_models.inc"
#undef CAR_BODY
  return forms;
}

std::vector<Corners> triangles_of(const things::Form& form, double tolerance_m) {
  std::vector<Corners> all;
  for (const things::Form& part : {form, parts_of(form)}) {
    const std::optional<CarMesh> car = car_mesh(part, tolerance_m);
    for (const materials::MaterialMesh& mesh : car->meshes)
      for (const auto& [a, b, c] : mesh.mesh.triangles)
        all.push_back({mesh.mesh.positions[a], mesh.mesh.positions[b], mesh.mesh.positions[c]});
  }
  return all;
}

Vec3 nearest_on_edge(Vec3 a, Vec3 b, Vec3 p) {
  const Vec3 along = b - a;
  return a + along * std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
}

double distance_to(const Corners& t, Vec3 p) {
  const Vec3 up = unit(cross(t[1] - t[0], t[2] - t[0])), foot = p - up * dot(p - t[0], up);
  bool is_inside = true;
  double sides = 20;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 a = t[i], b = t[(i + 1) % 3];
    is_inside = is_inside && dot(cross(b - a, foot - a), up) >= 0;
    sides = std::min(sides, length(p - nearest_on_edge(a, b, p)));
  }
  return is_inside ? length(p - foot) : sides;
}

// The greatest distance of the corners of one shape from another.
double distance_of(const std::vector<Corners>& from, const std::vector<Corners>& to) {
  std::set<Vec3> points;
  for (const Corners& t : from) points.insert(t.begin(), t.end());
  double greatest = 0;
  for (const Vec3 p : points) {
    double nearest = 20;
    for (const Corners& other : to) nearest = std::min(nearest, distance_to(other, p));
    greatest = std::max(greatest, nearest);
  }
  return greatest;
}

TEST(CarMesh, DeviatesByNoMoreThanItsError) {
  for (const things::Form& form : all_forms()) {
    const std::vector<Corners> full = triangles_of(form, kFine_m);
    for (const double tolerance_m : {kPlain_m, kOutline_m}) {
      const double error_m = car_mesh(form, tolerance_m)->error_m;
      EXPECT_LE(error_m, tolerance_m);
      EXPECT_LE(distance_of(full, triangles_of(form, tolerance_m)), error_m) << form.value << tolerance_m;
      EXPECT_LE(distance_of(triangles_of(form, tolerance_m), full), error_m) << form.value << tolerance_m;
    }
  }
}

TEST(CarMesh, HasFewerTrianglesAtCoarseLevels) {
  for (const things::Form& form : all_forms()) {
    const std::size_t full = triangles_of(form, kFine_m).size(), plain = triangles_of(form, kPlain_m).size();
    EXPECT_GE(full, 1200u) << form.value;
    EXPECT_LE(full, 3000u) << form.value;
    EXPECT_LE(plain, 560u) << form.value;
    EXPECT_LE(triangles_of(form, kOutline_m).size(), 130u) << form.value;
    EXPECT_TRUE(triangles_of(form, form.height_m).empty());
  }
}

TEST(CarMesh, StandsOnTheGroundWithinItsSize) {
  for (const things::Form& form : all_forms()) {
    Vec3 low{9, 9, 9}, high{-9, -9, -9};
    for (const Corners& t : triangles_of(form, kFine_m))
      for (const Vec3 p : t) {
        EXPECT_EQ(p, snapped(p));
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    EXPECT_NEAR(low.z, 0, 0.01) << form.value;
    EXPECT_NEAR(high.z, form.height_m, 0.02) << form.value;
    EXPECT_NEAR(high.y - low.y, form.depth_m, 0.12) << form.value;
    EXPECT_LE(high.x, form.width_m / 2 + 0.2) << "mirrors stand out";
    EXPECT_NEAR(high.x, -low.x, 1e-9);
  }
}

TEST(CarMesh, LooksOutwards) {
  for (const things::Form& form : all_forms())
    for (const double tolerance_m : {kFine_m, kPlain_m, kOutline_m}) {
      double six_volumes = 0;
      for (const Corners& t : triangles_of(form, tolerance_m)) six_volumes += dot(t[0], cross(t[1], t[2]));
      const double box = form.width_m * form.depth_m * form.height_m;
      EXPECT_GT(six_volumes / 6, 0.4 * box) << form.value;
      EXPECT_LT(six_volumes / 6, 1.1 * box) << form.value;
    }
}

TEST(CarMesh, SharesAllButItsPaintBetweenColours) {
  things::Form form = all_forms().front();
  form.colour = map::Srgb{140, 29, 34};
  EXPECT_FALSE(parts_of(form).colour.has_value());
  const std::optional<CarMesh> car = car_mesh(form, kFine_m);
  for (const materials::MaterialMesh& mesh : car->meshes) {
    EXPECT_EQ(mesh.material, materials::Material::kCarPaint);
    for (const materials::Tint& tint : mesh.tints) EXPECT_EQ(tint, mesh.tints.front());
  }
  EXPECT_FALSE(car_mesh({.kind = "bench"}, kFine_m).has_value());
}

}  // namespace
}  // namespace citykiln::cars
