#include "compiler/ground/cover/land_cover_index.h"

#include <gtest/gtest.h>

#include "tests/compiler/ground/wavy_surfaces.h"

namespace citykiln::ground {
namespace {

TEST(LandCoverIndex, AnswersAreThoseOfAnyBuckets) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const std::vector<LandCoverPolygon> surfaces = wavy_surfaces(seed, 50, 1);
    const LandCoverIndex large = index_land_cover(surfaces, kWavyCell),
                         small = index_land_cover(surfaces, kWavyCell, 8);
    const RandomSequence draw(seed, StableId{34}, "places");
    int covered = 0;
    for (std::uint32_t i = 0; i < 4000; ++i) {
      const Vec2 p{draw.between(kWavyCell.min.x, kWavyCell.max.x, 3 * i),
                   draw.between(kWavyCell.min.y, kWavyCell.max.y, 3 * i + 1)};
      const double search_radius_m = draw.between(0, 20, 3 * i + 2);
      EXPECT_EQ(land_cover_at(small, p), land_cover_at(large, p));
      covered += land_cover_at(small, p) != kNoLandCover;
      for (const int priority : {0, 40, 80})
        EXPECT_NEAR(clearance_m(small, p, priority, search_radius_m), clearance_m(large, p, priority, search_radius_m),
                    1e-9);
    }
    EXPECT_GT(covered, 0);
  }
}

}  // namespace
}  // namespace citykiln::ground
