#include "compiler/geometry/polygons/straight_skeleton.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

const Polygon kLShape{{{0, 0}, {20, 0}, {20, 8}, {8, 8}, {8, 18}, {0, 18}}, {}};
const Polygon kLargeCourtyard{{{0, 0}, {26, 0}, {26, 22}, {0, 22}}, {{{8, 8}, {8, 14}, {18, 14}, {18, 8}}}};

TEST(StraightSkeleton, HasAFaceForEachEdgeAndCoversThePolygon) {
  for (const SkeletonKernel kernel : {SkeletonKernel::kInexact, SkeletonKernel::kExact})
    for (const Polygon& polygon : {kLShape, kLargeCourtyard}) {
      const auto faces = straight_skeleton(polygon, kernel);
      std::size_t edges = polygon.outer.size();
      for (const Ring& hole : polygon.holes) edges += hole.size();
      ASSERT_EQ(faces.size(), edges);
      double sum = 0;
      for (const SkeletonFace& face : faces) sum += signed_area_m2(face.ring);
      EXPECT_NEAR(sum, area_m2(polygon), 1e-9);
    }
}

TEST(StraightSkeleton, StartsEachFaceWithItsEdge) {
  const std::vector<SkeletonFace> faces = straight_skeleton(kLargeCourtyard, SkeletonKernel::kInexact);
  ASSERT_EQ(faces.size(), 8u);
  for (const SkeletonFace& face : faces) {
    const Ring& ring = face.ring_index == 0 ? kLargeCourtyard.outer : kLargeCourtyard.holes[face.ring_index - 1];
    EXPECT_EQ(face.ring[0], ring[face.edge]);
    EXPECT_EQ(face.ring[1], ring[(face.edge + 1) % ring.size()]);
  }
}

TEST(StraightSkeleton, KeepsFacesNearerToTheirEdgeThanToTheNext) {
  const std::vector<SkeletonFace> faces = straight_skeleton(kLShape, SkeletonKernel::kExact);
  ASSERT_EQ(faces.size(), 6u);
  for (const SkeletonFace& face : faces) {
    const Ring& ring = kLShape.outer;
    const std::size_t n = ring.size();
    const auto inward = [&](std::size_t i, Vec2 p) {
      return dot(left_of(unit(ring[(i + 1) % n] - ring[i % n])), p - ring[i % n]);
    };
    // both neighbours meet this edge in a corner; where it is convex, the lower plane is the face's
    for (const Vec2 p : face.ring) {
      const bool is_convex =
          cross(ring[(face.edge + 1) % n] - ring[face.edge], ring[(face.edge + 2) % n] - ring[(face.edge + 1) % n]) > 0;
      if (!is_convex) continue;
      EXPECT_LE(inward(face.edge, p), inward(face.edge + 1, p) + 1e-9);
    }
  }
}

TEST(StraightSkeleton, GivesNothingForRingsThatTouchOrCross) {
  const Polygon bow{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {}};
  const Polygon hole_on_border{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{0, 0}, {2, 5}, {5, 2}}}};
  const Polygon clockwise{{{0, 0}, {0, 4}, {4, 4}, {4, 0}}, {}};
  for (const Polygon& bad : {bow, hole_on_border, clockwise, Polygon{}})
    EXPECT_TRUE(straight_skeleton(bad, SkeletonKernel::kInexact).empty());
}

}  // namespace
}  // namespace citykiln
