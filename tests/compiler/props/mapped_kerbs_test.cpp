#include "compiler/props/mapped_kerbs.h"

#include <gtest/gtest.h>

#include "tests/compiler/roads/made_road.h"

namespace citykiln::props {
namespace {

bool is_of_street(double y, double raised_m = 2, map::BarrierKind kind = map::BarrierKind::kKerb) {
  const std::vector<roads::Road> roads = {
      roads::made_road(1, {{0, 0}, {200, 0}}, 6, map::LandCoverClass::kResidentialRoad, raised_m, raised_m)};
  map::Barrier kerb;
  kerb.axis = {{20, y}, {100, y}}, kerb.kind = kind;
  return kerbs_of_streets(std::vector{kerb}, roads).front();
}

TEST(MappedKerbs, BesideTheKerbOfAStreetAreThatKerb) {
  EXPECT_TRUE(is_of_street(3.8));
  EXPECT_TRUE(is_of_street(-1.8));
  EXPECT_FALSE(is_of_street(4.2));
  EXPECT_FALSE(is_of_street(0.5));
  EXPECT_FALSE(is_of_street(3, 0));  // the street has no kerb
  EXPECT_FALSE(is_of_street(3, 2, map::BarrierKind::kWall));
}

}  // namespace
}  // namespace citykiln::props
