#include "compiler/map/plane/clip_ring.h"

#include <gtest/gtest.h>

#include "compiler/geometry/snap.h"

namespace citykiln::map {
namespace {

const Box2 kClipBox{{-64, -32}, {128, 96}};

// Stars without chance: rings of n points in and out of the box, crossing themselves.
Ring star(int n, int step) {
  Ring ring;
  for (int i = 0; i < n; ++i)
    ring.push_back(snapped(Vec2{(i * step * 37 % 997) - 480.3, (i * step * 61 % 883) - 410.7}));
  return ring;
}

TEST(ClipRing, PointsInsideKeepTheirWindingNumber) {
  for (int n = 3; n < 40; n += 3) {
    const Ring ring = star(n, n + 1), kept = clip_ring(ring, kClipBox);
    for (double x = -63.3; x < 128; x += 9.7)
      for (double y = -31.4; y < 96; y += 8.3)
        EXPECT_EQ(kept.empty() ? 0 : winding_number(kept, {x, y}), winding_number(ring, {x, y}))
            << n << " " << x << " " << y;
  }
}

TEST(ClipRing, NothingLiesOutsideAndAllIsOnTheGrid) {
  std::size_t points = 0;
  for (int n = 3; n < 40; ++n)
    for (const Vec2 p : clip_ring(star(n, 7), kClipBox)) {
      EXPECT_TRUE(kClipBox.contains(p));
      EXPECT_EQ(p, snapped(p));
      ++points;
    }
  EXPECT_GT(points, 0u);
}

TEST(ClipRing, ARingInsideStaysAsItIs) {
  const Ring ring = {{0, 0}, {100, 0}, {100, 50}, {3, 60}};
  EXPECT_EQ(clip_ring(ring, kClipBox), ring);
}

TEST(ClipRing, ARingAroundTheBoxBecomesTheBox) {
  EXPECT_EQ(signed_area_m2(clip_ring(Ring{{-1e6, -1e6}, {2e6, -1e6}, {0, 3e6}}, kClipBox)),
            kClipBox.width() * kClipBox.height());
}

TEST(ClipRing, ARingElsewhereIsNothing) {
  EXPECT_TRUE(clip_ring(Ring{{200, 0}, {300, 0}, {300, 50}}, kClipBox).empty());
}

}  // namespace
}  // namespace citykiln::map
