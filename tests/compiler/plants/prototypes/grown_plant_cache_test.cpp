#include "compiler/plants/prototypes/grown_plant_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace citykiln::plants {
namespace {

// The extents of a plant as shares of its height.
struct Reach {
  double width = 0;      // the mean of the extents along x and y
  double in_plan = 0;    // of leaves from the axis through the foot
  double from_foot = 0;  // of leaves from the foot
};

Reach reach_of(const GrownPlant& grown) {
  Reach reach;
  Box2 box;
  for (const Card& card : grown.foliage.cards)
    for (const Vec3 p : corners_of(card)) {
      box.grow(in_plan(p));
      reach.in_plan = std::max(reach.in_plan, length(in_plan(p)) / grown.height_m);
      reach.from_foot = std::max(reach.from_foot, length(p) / grown.height_m);
    }
  if (!box.is_empty()) reach.width = (box.width() + box.height()) / 2 / grown.height_m;
  return reach;
}

// Bounds of plants and the error of plants that are left out (compiler/bake) rely on this.
TEST(ShippedSpecies, AreNoWiderThanTheWidestCrown) {
  const GrownPlantCache cache({});
  for (const Species species : cache.table().all()) {
    const SpeciesValues& values = cache.table()[species];
    EXPECT_LE(values.crown_share, kWidestCrown) << values.file;
    if (values.leaf_form == LeafForm::kBlade) continue;
    for (std::uint8_t variant = 0; variant < kVariants; ++variant) {
      const Reach reach = reach_of(*cache.grown_or_regrown({species, variant}));
      EXPECT_LE(reach.width, kWidestCrown) << values.file << " " << int{variant};
      EXPECT_LE(reach.in_plan, kCrownReach) << values.file << " " << int{variant};
      EXPECT_LE(reach.from_foot, std::sqrt(1 + kWidestCrown * kWidestCrown / 4)) << values.file << " " << int{variant};
    }
  }
}

}  // namespace
}  // namespace citykiln::plants
