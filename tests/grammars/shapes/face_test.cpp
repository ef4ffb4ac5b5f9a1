#include "grammars/shapes/face.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::grammars {
namespace {

// A steep roof plane on a grid of 2^-10 m that begins at corner `first`. One edge is a grid step long.
Face roof_plane(std::size_t first) {
  Face face;
  face.outer = {{8.6494140625, -73.6943359375, -29.1982421875},
                {8.650390625, -73.6943359375, -29.203125},
                {8.650390625, 19.275390625, -29.203125},
                {4.75, 15.375, 2},
                {4.75, -69.794921875, 2}};
  std::rotate(face.outer.begin(), face.outer.begin() + static_cast<std::ptrdiff_t>(first), face.outer.end());
  return face;
}

TEST(FaceFrame, KeepsCornersWhereTheyAreHoweverShortTheFirstEdge) {
  for (std::size_t first = 0; first < 5; ++first) {
    const Face face = roof_plane(first);
    const FaceFrame frame = frame_of(face);
    EXPECT_NEAR(dot(frame.x, frame.z), 0, 1e-6);
    EXPECT_NEAR(length(frame.y), 1, 1e-6);
    for (const Vec3 p : face.outer) EXPECT_LE(length(frame.to_space(frame.to_plane(p)) - p), 0x1p-10) << first;
  }
}

TEST(FaceFrame, BeginsAlongTheFirstEdge) {
  Face wall;
  wall.outer = {{1, 2, 3}, {5, 5, 3}, {5, 5, 9}, {1, 2, 9}};
  EXPECT_LE(length(frame_of(wall).x - Vec3{0.8, 0.6, 0}), 1e-15);
  EXPECT_LE(length(frame_of(wall).y - Vec3{0, 0, 1}), 1e-15);
}

TEST(Face, BendsByWhatItsCornersAreRoundedBy) {
  EXPECT_GT(bend_m(roof_plane(0)), 1e-5);
  EXPECT_LT(bend_m(roof_plane(0)), 0x1p-10);
  Face wall;
  wall.outer = {{1, 2, 3}, {5, 5, 3}, {5, 5, 9}, {1, 2, 9}};
  EXPECT_EQ(bend_m(wall), 0);
}

}  // namespace
}  // namespace citykiln::grammars
