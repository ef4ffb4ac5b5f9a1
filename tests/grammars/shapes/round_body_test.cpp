#include "grammars/shapes/round_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "grammars/shapes/cut.h"
#include "tests/grammars/surfaces.h"

namespace citykiln::grammars {
namespace {

Scope box_of(double width_m, double depth_m, double height_m) {
  return {.origin = {3, -2, 5},
          .axis = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}},
          .size_m = {width_m, depth_m, height_m}};
}

double volume_m3_of(const std::vector<Face>& faces) {
  double sum = 0;
  for (const Face& face : faces)
    for (std::size_t i = 2; i < face.outer.size(); ++i)
      sum += dot(face.outer[0], cross(face.outer[i - 1], face.outer[i])) / 6;
  return sum;
}

std::vector<RoundBody> bodies_in(const Scope& scope, RoundSides sides) {
  std::vector<RoundBody> bodies;
  for (const int axis : {0, 1, 2}) {
    bodies.push_back(cylinder_in(scope, axis, 1, sides));
    bodies.push_back(cylinder_in(scope, axis, 0.4, sides));
    bodies.push_back(cylinder_in(scope, axis, 0, sides));
    bodies.push_back(sphere_in(scope, axis, sides));
    bodies.push_back(dome_in(scope, axis, sides));
  }
  return bodies;
}

TEST(RoundBody, RoundBodiesAreClosedPlanarAndTurnOutwards) {
  for (const double most_m : {0.001, 0.01, 0.1, 1.0})
    for (const RoundBody& body : bodies_in(box_of(2, 2, 3), {.most_m = most_m})) {
      EXPECT_TRUE(is_closed(body.faces));
      EXPECT_GT(volume_m3_of(body.faces), 0.5);
      for (const Face& face : body.faces) EXPECT_LT(bend_m(face), 1e-9);
    }
}

TEST(RoundBody, TheDeviationIsAllowedAndFewerSidesDoNotReachIt) {
  for (const double most_m : {0.001, 0.01, 0.05, 0.2}) {
    for (const RoundBody& body : bodies_in(box_of(2, 2, 2), {.most_m = most_m})) EXPECT_LE(body.deviation_m, most_m);
    EXPECT_EQ(cylinder_in(box_of(2, 2, 2), 2, 1, {.most_m = most_m}).faces.size(), sides_for(1, most_m) + 2u);
  }
  EXPECT_GT(sides_for(1, 0.001), sides_for(1, 0.01));
  EXPECT_EQ(sides_for(1, 10), RoundSides::kLeast);
}

// Sampled both ways: points of the polygon from the circle, and points of the circle from the polygon.
TEST(RoundBody, ACylinderIsAsFarFromTheExactOneAsItStates) {
  const Scope scope = box_of(2, 2, 3);
  const Vec3 middle = scope.to_space(1, 1, 0);
  for (const double most_m : {0.003, 0.03, 0.3}) {
    const RoundBody body = cylinder_in(scope, 2, 1, {.most_m = most_m});
    double farthest_m = 0;
    for (const Face& face : body.faces) {
      if (face.outer.size() != 4 || std::abs(normal_of(face).z) > 0.5) continue;
      for (int i = 0; i <= 10; ++i) {
        const Vec3 p = face.outer[0] + (face.outer[1] - face.outer[0]) * (i / 10.0) - middle;
        farthest_m = std::max(farthest_m, std::abs(length(in_plan(p)) - 1));
      }
    }
    EXPECT_NEAR(farthest_m, body.deviation_m, 1e-9);
  }
}

TEST(RoundBody, ASphereIsWithinTheDistanceThatItStates) {
  const Scope scope = box_of(2, 2, 2);
  const Vec3 middle = scope.centre();
  for (const double most_m : {0.01, 0.05, 0.2}) {
    const RoundBody body = sphere_in(scope, 2, {.most_m = most_m});
    for (const Face& face : body.faces) {
      Vec3 inner;
      for (const Vec3 p : face.outer) {
        EXPECT_LE(std::abs(length(p - middle) - 1), body.deviation_m + 1e-9);
        inner = inner + (p - middle) * (1.0 / static_cast<double>(face.outer.size()));
      }
      EXPECT_GE(length(inner), 1 - body.deviation_m - 1e-9);
    }
  }
}

TEST(RoundBody, GivenSidesFillTheScope) {
  const Scope scope = box_of(2, 1, 3);
  EXPECT_NEAR(volume_m3_of(cylinder_in(scope, 2, 1, {.given = 4}).faces), 6, 1e-9);
  for (const int sides : {3, 5, 6, 8, 12}) {
    const RoundBody body = cylinder_in(scope, 2, 1, {.given = sides});
    EXPECT_EQ(body.deviation_m, 0);
    const Scope around = scope_around(body.faces, scope.axis, {});
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(around.size_m[i], scope.size_m[i], 1e-9);
  }
}

TEST(RoundBody, ATriangleAcrossYStandsOnItsSide) {
  const RoundBody body = cylinder_in(box_of(2, 1, 2), 1, 1, {.given = 3});
  double low_m = 0;
  for (const Face& face : body.faces)
    if (normal_of(face).z < -0.99) low_m = face.outer[0].z;
  EXPECT_NEAR(low_m, 5, 1e-12);
}

}  // namespace
}  // namespace citykiln::grammars
