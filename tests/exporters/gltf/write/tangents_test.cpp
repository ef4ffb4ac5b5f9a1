#include "exporters/gltf/write/tangents.h"

#include <gtest/gtest.h>

#include <cmath>

namespace citykiln::exporters {
namespace {

Vec3 vec(const bake::Float4& t) { return {t[0], t[1], t[2]}; }

// A square of land or of a wall, with uvs along two of its directions.
bake::Primitive square(Vec3 across, Vec3 up, Vec3 u, Vec3 v) {
  bake::Primitive p;
  const Vec3 normal = unit(cross(across, up));
  for (const Vec3 at : {Vec3{}, across, across + up, up}) {
    const auto f = [](double x) { return static_cast<float>(x); };
    p.positions.push_back({f(at.x), f(at.y), f(at.z)});
    p.normals.push_back({f(normal.x), f(normal.y), f(normal.z)});
    p.uvs.push_back({f(dot(at, u)), f(dot(at, v))});
  }
  p.triangles = {{0, 1, 2}, {0, 2, 3}};
  return p;
}

// The tangent is where u grows; with the sign, its cross product with the normal is where v shrinks.
void expect_frame(const bake::Primitive& p, Vec3 u, Vec3 v) {
  const auto tangents = tangents_of(p);
  ASSERT_EQ(tangents.size(), p.positions.size());
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const Vec3 normal{p.normals[i][0], p.normals[i][1], p.normals[i][2]}, t = vec(tangents[i]);
    EXPECT_NEAR(length(t), 1, 1e-6);
    EXPECT_NEAR(dot(t, u), 1, 1e-6);
    EXPECT_NEAR(dot(cross(normal, t) * tangents[i][3], v), -1, 1e-6);
  }
}

TEST(Tangents, OfLandPointEast) {
  expect_frame(square({4, 0, 0}, {0, 4, 0}, {1, 0, 0}, {0, 1, 0}), {1, 0, 0}, {0, 1, 0});
}

TEST(Tangents, OfFieldsPointAcrossTheirRows) {
  const Vec3 u{0.6, 0.8, 0}, v{-0.8, 0.6, 0};
  expect_frame(square({4, 0, 0}, {0, 4, 0}, u, v), u, v);
}

TEST(Tangents, OfWallsThatFaceEitherWayPointEast) {
  const Vec3 east{1, 0, 0}, up{0, 0, 1};
  expect_frame(square(east, up, east, up), east, up);
  expect_frame(square(east * -1, up, east, up), east, up);
}

TEST(Tangents, AreUnitVectorsWhateverUvsSay) {
  bake::Primitive p = square({4, 0, 0}, {0, 4, 0}, {}, {});
  p.positions.push_back({9, 9, 9}), p.normals.push_back({0.6f, 0, 0.8f}), p.uvs.push_back({0, 0});
  EXPECT_EQ(tangents_of(p).size(), p.positions.size());
  for (const bake::Float4& t : tangents_of(p)) {
    EXPECT_NEAR(length(vec(t)), 1, 1e-6);
    EXPECT_EQ(std::abs(t[3]), 1);
  }
}

}  // namespace
}  // namespace citykiln::exporters
