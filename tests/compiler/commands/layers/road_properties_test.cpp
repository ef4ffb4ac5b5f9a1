#include "compiler/commands/layers/road_properties.h"

#include <gtest/gtest.h>

namespace citykiln::commands {
namespace {

TEST(RoadProperties, NameWhatIsAssumed) {
  Properties properties;
  add_assumed(properties, kNoAssumptions);
  EXPECT_EQ(properties.json(), "");
  add_assumed(properties, bit_of(Assumption::kPavements) | bit_of(Assumption::kLamps));
  EXPECT_EQ(properties.json(), R"(,"assumed":["pavements","lamps"])");
}

}  // namespace
}  // namespace citykiln::commands
