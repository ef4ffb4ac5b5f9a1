#include "exporters/gltf/plant_tints.h"

#include <gtest/gtest.h>

#include "tests/exporters/made_tile.h"

namespace citykiln::exporters {
namespace {

using materials::Tint;

bake::Primitive made_plant(std::vector<Tint> colours) {
  bake::Primitive plant;
  plant.layer = bake::Layer::kPlants, plant.colours = std::move(colours);
  return plant;
}

TEST(PlantTints, AreReadBackFromSharesOfTheLargest) {
  for (int largest = 0; largest < 256; ++largest)
    for (int own = 0; own <= largest; ++own) {
      const Tint of_all = {static_cast<std::uint8_t>(largest), 255, 3, 255};
      const Tint tint = {static_cast<std::uint8_t>(own), 17, 2, 254};
      ASSERT_EQ(tint_of(share_of(tint, of_all), of_all), tint) << own << " of " << largest;
    }
}

TEST(PlantTints, OfTheLargestAreWhite) {
  const bake::Primitive plant = made_plant({{20, 100, 0, 254}, {40, 60, 0, 255}});
  EXPECT_EQ(largest_tint(plant), (Tint{40, 100, 0, 255}));
  EXPECT_EQ(share_of({40, 100, 0, 254}, largest_tint(plant)), (Tint{255, 255, 0, 254}));
}

TEST(PlantTints, LeaveOtherLayersAsTheyAre) {
  bake::Primitive wall = made_plant({{20, 100, 0, 255}});
  wall.layer = bake::Layer::kBuildings;
  EXPECT_EQ(largest_tint(wall), materials::kNoTint);
  EXPECT_EQ(share_of(wall.colours[0], materials::kNoTint), wall.colours[0]);
}

}  // namespace
}  // namespace citykiln::exporters
