#include "compiler/simplify/distance_bound.h"

#include <gtest/gtest.h>

#include "tests/compiler/simplify/samples.h"

namespace citykiln::simplify {
namespace {

std::vector<Corners> square_at(double z, double side_m = 10) {
  return {{{0, 0, z}, {side_m, 0, z}, {side_m, side_m, z}}, {{0, 0, z}, {side_m, side_m, z}, {0, side_m, z}}};
}

std::vector<Corners> random_triangles(std::uint64_t seed, std::size_t count) {
  std::vector<Corners> all;
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = [&](std::uint64_t k) { return noise(seed * 1000003 + i * 16 + k) * 40; };
    const Vec3 at{number(0), number(1), number(2) / 4};
    const auto near = [&](std::uint64_t k) { return Vec3{number(k) / 4, number(k + 1) / 4, number(k + 2) / 8}; };
    all.push_back({at, at + near(3), at + near(6)});
  }
  return all;
}

TEST(DistanceBound, IsTheDistanceOfParallelSquares) {
  const double bound_m = distance_bound_m(square_at(3), TriangleTree(square_at(0)), {.precision_m = 0.01});
  EXPECT_GE(bound_m, 3);
  EXPECT_LE(bound_m, 3.02);
}

TEST(DistanceBound, GoesOneWay) {
  const std::vector<Corners> small = square_at(0, 10), large = square_at(0, 50);
  EXPECT_LE(distance_bound_m(small, TriangleTree(large), {.precision_m = 0.01}), 0.01);
  EXPECT_GE(distance_bound_m(large, TriangleTree(small), {.precision_m = 0.01}), 40);
}

TEST(DistanceBound, IsNoLessThanAnySampleAndNoMoreThanThePrecisionAboveTheFarthest) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<Corners> from = random_triangles(seed, 30), to = random_triangles(seed + 100, 30);
    const DistanceBound bound = distance_bound(from, TriangleTree(to), {.precision_m = 0.05});
    const double sampled_m = sampled_distance_m(from, to, 40);
    EXPECT_GT(sampled_m, 1);
    EXPECT_GE(bound.distance_m, sampled_m);
    // samples are up to 0.25 m apart
    EXPECT_LE(bound.distance_m, sampled_m + 0.05 + 0.25);
    EXPECT_NEAR(nearest_of(to).distance_m(bound.at), bound.distance_m, 0.06);
  }
}

TEST(DistanceBound, EndsAtTheFirstPlaceThatIsTooFar) {
  const double found_m =
      distance_bound_m(square_at(30), TriangleTree(square_at(0)), {.precision_m = 0.01, .most_m = 5});
  EXPECT_GT(found_m, 5);
}

TEST(DistanceBound, OfNothingIsLeastAndToNothingInfinite) {
  EXPECT_EQ(distance_bound_m({}, TriangleTree(square_at(0)), {.precision_m = 1, .least_m = 2}), 2);
  EXPECT_EQ(distance_bound_m(square_at(0), TriangleTree({}), {.precision_m = 1}),
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace citykiln::simplify
