#include "compiler/verify/measure_decks.h"

#include <gtest/gtest.h>

#include "tests/compiler/roads/made_road.h"

namespace citykiln::verify {
namespace {

// A bridge of 40 m on a plate of 40 x 20 m, in a tile of 256 m.
scene::Scene scene_with_plate() {
  scene::Scene scene;
  scene.header.extent = {{0, 0}, {256, 256}};
  scene.header.tile_m = 256;
  structures::Span bridge{roads::made_road(1, {{20, 50}, {60, 50}}, 3, map::LandCoverClass::kResidentialRoad, 0, 0)};
  bridge.deck = structures::DeckForm::kPlate;
  bridge.plates = {{{OsmType::kWay, 9},
                    map::LandCoverClass::kSquare,
                    {{{{{{20, 40, 8}}, {{60, 40, 8}}, {{60, 60, 8}}, {{20, 60, 8}}}}, false}}}};
  scene.chunks.push_back({.tile = {0, 0}, .bridges = {bridge}});
  return scene;
}

TEST(MeasureDecks, ABridgeOnAnAreaWithoutAPlateHasNoDeck) {
  scene::Scene scene = scene_with_plate();
  EXPECT_EQ(measure_decks(scene).tests, 1u);
  EXPECT_EQ(measure_decks(scene).missing, 0u);
  structures::Span& bridge = scene.chunks[0].bridges[0];
  bridge.plates.clear();
  EXPECT_EQ(measure_decks(scene).missing, 1u);
  EXPECT_EQ(measure_decks(scene).element.id, 1);
  bridge.deck = structures::DeckForm::kOwn;
  EXPECT_EQ(measure_decks(scene).tests, 0u) << "with a slab of its own";
}

}  // namespace
}  // namespace citykiln::verify
