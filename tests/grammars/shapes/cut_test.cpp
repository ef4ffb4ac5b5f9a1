#include "grammars/shapes/cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace citykiln::grammars {
namespace {

CutPlane opposite(CutPlane plane) { return {plane.normal * -1.0, -plane.offset_m}; }

double total_area_m2(const std::vector<Face>& faces) {
  double sum = 0;
  for (const Face& face : faces) sum += area_m2(face);
  return sum;
}

double enclosed_volume_m3(const std::vector<Face>& faces) {
  double sum = 0;
  for (const Face& face : faces) sum += dot(double_area_vector_m2(face) * 0.5, face.outer.front()) / 3;
  return sum;
}

struct Cut : testing::Test {
  std::mt19937 chance{11};
  double between(double low, double high) { return low + (high - low) * static_cast<double>(chance()) / 4294967296.0; }
  Vec3 direction() { return unit(Vec3{between(-1, 1), between(-1, 1), between(-1, 1)}); }

  /// A star around the origin with a star-shaped hole, on a plane of any tilt; some vertices on a grid, so that planes
  /// pass through them.
  Face star() {
    const Vec3 z = direction(), x = unit(cross(z, direction())), y = cross(z, x);
    Face face;
    const auto ring = [&](double low_m, double high_m, bool clockwise) {
      Ring3 points;
      const int n = 3 + static_cast<int>(chance() % 12);
      for (int i = 0; i < n; ++i) {
        const double turn = 6.283185307 * (clockwise ? n - i : i) / n, r = between(low_m, high_m);
        points.push_back(x * (std::round(r * std::cos(turn) * 4) / 4) + y * (std::round(r * std::sin(turn) * 4) / 4));
      }
      return points;
    };
    face.outer = ring(3, 10, false);
    if (chance() % 2) face.holes.push_back(ring(0.5, 1.2, true));
    return face;
  }

  CutPlane plane_for(const Face& face) {
    const Vec3 normal = direction();
    // every other plane passes through a vertex
    const Vec3 through = chance() % 2 ? face.outer[chance() % face.outer.size()] : direction() * between(0, 6);
    return {normal, dot(normal, through)};
  }
};

TEST_F(Cut, InTwoGivesTheSamePartsAsEitherSideAlone) {
  int cut = 0;
  for (int round = 0; round < 20'000; ++round) {
    Face face = star();
    face.tag = FaceTag::kTop, face.street = true;
    const CutPlane plane = plane_for(face);
    Face above = face, below;
    if (!cut_in_two(above, plane, below)) {
      ASSERT_EQ(above, face);
      continue;
    }
    ++cut;
    ASSERT_EQ(std::vector{above}, part_above(face, plane));
    ASSERT_EQ(std::vector{below}, part_above(face, opposite(plane)));
  }
  EXPECT_GT(cut, 2'000);
}

TEST_F(Cut, PartsHaveTheAreaOfTheFace) {
  for (int round = 0; round < 20'000; ++round) {
    const Face face = star();
    const CutPlane plane = plane_for(face);
    const double parts_m2 = total_area_m2(part_above(face, plane)) + total_area_m2(part_above(face, opposite(plane)));
    ASSERT_NEAR(parts_m2, area_m2(face), 1e-6) << "round " << round;
  }
}

TEST_F(Cut, PartsLieOnTheirSide) {
  std::size_t parts = 0;
  for (int round = 0; round < 5000; ++round) {
    const Face face = star();
    const CutPlane plane = plane_for(face);
    for (const Face& part : part_above(face, plane)) {
      each_vertex(part, [&](Vec3 p) { ASSERT_GE(dot(plane.normal, p), plane.offset_m - 1e-6); });
      ++parts;
    }
  }
  EXPECT_GT(parts, 2'000u);
}

TEST_F(Cut, AFaceInThePlaneGoesToOneSide) {
  Face face;
  face.outer = {{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}};
  const CutPlane plane{{0, 0, 1}, 2};
  EXPECT_TRUE(part_above(face, plane).empty());
  EXPECT_EQ(part_above(face, opposite(plane)).size(), 1u);
  EXPECT_EQ(part_above(reversed(face), plane).size(), 1u);
}

std::vector<Face> prism(const Ring3& base, double height_m) {
  std::vector<Face> faces(2);
  Ring3 top = base;
  for (Vec3& p : top) p.z += height_m;
  faces[0].outer = {base.rbegin(), base.rend()};
  faces[1].outer = top;
  for (std::size_t i = 0; i < base.size(); ++i) {
    const std::size_t next = (i + 1) % base.size();
    faces.emplace_back().outer = {base[i], base[next], top[next], top[i]};
  }
  return faces;
}

TEST_F(Cut, SolidsStaySolidAndKeepTheirVolume) {
  // a U, so that caps have several pieces
  const Ring3 base = {{0, 0, 0}, {9, 0, 0}, {9, 8, 0}, {6, 8, 0}, {6, 3, 0}, {3, 3, 0}, {3, 8, 0}, {0, 8, 0}};
  const std::vector<Face> solid = prism(base, 5);
  ASSERT_TRUE(is_closed(solid));
  for (int round = 0; round < 3000; ++round) {
    const Vec3 normal = round % 3 == 0 ? Vec3{0, 1, 0} : round % 3 == 1 ? Vec3{0, 0, 1} : direction();
    const CutPlane plane{normal, dot(normal, Vec3{4, round % 2 ? 3.0 : between(0, 8), between(0, 5)})};
    const auto above = solid_above(solid, plane, true), below = solid_above(solid, opposite(plane), true);
    ASSERT_NEAR(enclosed_volume_m3(above) + enclosed_volume_m3(below), enclosed_volume_m3(solid), 1e-6)
        << "round " << round;
    if (!above.empty()) {
      ASSERT_TRUE(is_closed(above)) << "round " << round;
    }
    if (!below.empty()) {
      ASSERT_TRUE(is_closed(below)) << "round " << round;
    }
  }
}

TEST_F(Cut, OpenSurfacesGetNoCaps) {
  std::vector<Face> walls = prism({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, 3);
  walls.erase(walls.begin(), walls.begin() + 2);
  ASSERT_FALSE(is_closed(walls));
  EXPECT_EQ(solid_above(walls, {{0, 0, 1}, 1}, false).size(), 4u);
}

TEST_F(Cut, MergedPartsAreTheFaceAgain) {
  for (int round = 0; round < 2000; ++round) {
    Face face = star();
    face.holes.clear();
    const CutPlane plane = plane_for(face);
    std::vector<Face> parts = part_above(face, plane);
    for (Face& part : part_above(face, opposite(plane))) parts.push_back(std::move(part));
    ASSERT_NEAR(total_area_m2(merged(parts)), area_m2(face), 1e-6) << "round " << round;
  }
}

// A hole with an edge in the plane becomes a bay of the part.
TEST_F(Cut, OpensAHoleThatHasAnEdgeInThePlane) {
  Face court;
  court.outer = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  court.holes = {{{1, 1, 0}, {1, 9, 0}, {5, 9, 0}, {5, 1, 0}}};
  const CutPlane east{{1, 0, 0}, 5};
  const auto around = part_above(court, opposite(east)), beside = part_above(court, east);
  ASSERT_EQ(around.size(), 1u);
  EXPECT_TRUE(around.front().holes.empty());
  EXPECT_EQ(around.front().outer.size(), 8u);
  EXPECT_EQ(total_area_m2(around), 50 - 4 * 8);
  ASSERT_EQ(beside.size(), 1u);
  EXPECT_EQ(total_area_m2(beside), 50);
}

}  // namespace
}  // namespace citykiln::grammars
