#include "compiler/commands/view/hidden_by_land.h"

#include <gtest/gtest.h>

namespace citykiln::commands {
namespace {

// A ridge of 500 m at x = 1000, land at 100 m elsewhere.
scene::Header ridge() {
  scene::Header header;
  header.extent = {{0, 0}, {256, 256}};
  header.around = {.x_m = {-5000, 900, 1000, 1100, 5000}, .y_m = {-5000, 5000}, .heights_m = {}, .covers = {}};
  header.around.heights_m = {100, 100, 500, 100, 100, 100, 100, 500, 100, 100};
  header.around.covers.assign(10, surroundings::Cover::kLand);
  return header;
}

TEST(IsHiddenByLand, BehindARidgeAndBelowTheGround) {
  const scene::Header header = ridge();
  const Vec3 town{128, 128, 110};
  EXPECT_TRUE(is_hidden_by_land(header, header.extent, {3000, 128, 300}, town));
  EXPECT_FALSE(is_hidden_by_land(header, header.extent, {3000, 128, 3000}, town));
  EXPECT_FALSE(is_hidden_by_land(header, header.extent, {-3000, 128, 300}, town));
  EXPECT_TRUE(is_hidden_by_land(header, header.extent, {-3000, 128, 90}, town));
  EXPECT_FALSE(is_hidden_by_land(header, header.extent, {200, 128, 90}, {3000, 128, 90}));
  // a camera that looks away from the town may look at a ridge
  EXPECT_FALSE(is_hidden_by_land(header, header.extent, {500, 128, 300}, {4000, 128, 300}));
  EXPECT_FALSE(is_hidden_by_land({}, header.extent, {3000, 128, 300}, town));
}

}  // namespace
}  // namespace citykiln::commands
