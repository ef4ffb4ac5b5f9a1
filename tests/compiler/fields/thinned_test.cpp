#include "compiler/fields/thinned.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/geometry/segment.h"

namespace citykiln::fields {
namespace {

Ring wavy_ring() {
  Ring ring;
  for (int i = 0; i < 40; ++i) ring.push_back({i * 10.0, i % 3 * 0.1});
  ring.push_back({390, 100}), ring.push_back({0, 100});
  return ring;
}

TEST(Thinned, KeepsCornersAndStaysNear) {
  const Ring ring = wavy_ring(), kept = thinned_ring(ring, 0.3);
  EXPECT_LT(kept.size(), ring.size() / 2);
  for (const Vec2 p : ring) EXPECT_LT(distance_to_ring(kept, p), 1.2);
  for (const Vec2 corner : {Vec2{390, 100}, Vec2{0, 100}, Vec2{0, 0}})
    EXPECT_NE(std::ranges::find(kept, corner), kept.end());
}

TEST(Thinned, DoesNotDependOnTheFirstPoint) {
  const Ring ring = wavy_ring();
  Ring turned(ring.begin() + 17, ring.end());
  turned.insert(turned.end(), ring.begin(), ring.begin() + 17);
  Ring a = thinned_ring(ring, 0.3), b = thinned_ring(turned, 0.3);
  std::ranges::sort(a), std::ranges::sort(b);
  EXPECT_EQ(a, b);
}

}  // namespace
}  // namespace citykiln::fields
