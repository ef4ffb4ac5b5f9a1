#include "compiler/map/plane/degrees.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace citykiln::map {
namespace {

TEST(Degrees, HaveTheDigitsOfTheMap) {
  EXPECT_EQ(degrees_text(10.00016054321), "10.0001605");
  EXPECT_EQ(degrees_text(-0.5), "-0.5000000");
  EXPECT_EQ(degrees_text(43, kFineDegreeDecimals), "43.000000000");
}

TEST(Degrees, AreShortNumbersInJson) {
  // a node's latitude, 520013475 steps of OSM's grid
  EXPECT_EQ(nlohmann::json(520013475 * 1e-7).dump(), "52.001347499999994");
  EXPECT_EQ(nlohmann::json(rounded_degrees(520013475 * 1e-7)).dump(), "52.0013475");
  EXPECT_EQ(nlohmann::json(rounded_degrees(source::LonLatBox{-7.1, 51.998652499999999, 0, 52.00000004})).dump(),
            "[-7.1,51.9986525,0.0,52.0]");
}

TEST(Degrees, OfTheGridStayTheSame) {
  for (int e7 = -1800000000; e7 < 1799000000; e7 += 1234567) EXPECT_EQ(rounded_degrees(e7 * 1e-7), e7 / 1e7) << e7;
}

}  // namespace
}  // namespace citykiln::map
