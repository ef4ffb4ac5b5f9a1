#include "compiler/map/pavements.h"

#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

TEST(Pavements, LieWhereTagsSaySo) {
  const struct {
    const char* tags;
    double left_m, right_m;
  } cases[] = {
      {"", 0, 0},
      {"sidewalk=both", 2, 2},
      {"sidewalk=yes", 2, 2},
      {"sidewalk=left", 2, 0},
      {"sidewalk=right", 0, 2},
      {"sidewalk=no", 0, 0},
      {"sidewalk=separate", 0, 0},
      {"sidewalk:both=separate", 0, 0},
      {"sidewalk:left=yes sidewalk:right=no", 2, 0},
      {"sidewalk=both sidewalk:left=separate", 0, 2},
      {"sidewalk:both=yes sidewalk:right=no", 2, 0},
      {"sidewalk=both sidewalk:both:width=3.1", 3, 3},
      {"sidewalk=both sidewalk:left:width=1.5 sidewalk:width=4", 1.5, 4},
      {"sidewalk=both sidewalk:width=wide", 2, 2},
      {"sidewalk=both sidewalk:width=-3", 2, 2},
  };
  for (const auto& c : cases) {
    const Features features = features_of(std::string("w1 0:0 50:0 highway=residential ") + c.tags);
    ASSERT_EQ(features.tracks.size(), 1u) << c.tags;
    EXPECT_EQ(features.tracks[0].pavement_left_m, c.left_m) << c.tags;
    EXPECT_EQ(features.tracks[0].pavement_right_m, c.right_m) << c.tags;
  }
}

}  // namespace
}  // namespace citykiln::map
