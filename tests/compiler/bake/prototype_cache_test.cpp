#include "compiler/bake/prototype_cache.h"

#include <gtest/gtest.h>

#include "compiler/bake/bake.h"
#include "compiler/contract/system/for_each_slot.h"

namespace citykiln::bake {
namespace {

using plants::Species;

scene::Header header_with_species(std::vector<plants::SpeciesText> texts) {
  scene::Header header;
  header.extent = {{0, 0}, {128, 128}}, header.tile_m = 128, header.species = std::move(texts);
  return header;
}

// A lawn with trees of one species in a row.
scene::Chunk planted(int trees) {
  scene::Chunk chunk;
  chunk.heights = {{-64, -64}, {16, 16}, 17, 17, std::vector<std::int32_t>(17 * 17, 0), 0};
  for (int i = 0; i < trees; ++i)
    chunk.trees.push_back(
        {{{OsmType::kNode, i + 1}, 0}, {4.0 + 6 * i, 64}, 12, plants::species_mix_of(Species::kBirch)});
  return chunk;
}

TEST(PrototypeCache, MakesAPrototypeOnceForAllThreads) {
  const PrototypeCache prototypes(header_with_species({}));
  const auto shapes = for_each_slot<const BakedPrototype*>(16, 4, [&](std::size_t i) {
    return &prototypes.prototype({Species::kBush, static_cast<std::uint8_t>(i % 2)}, 5, 0.1);
  });
  for (std::size_t i = 2; i < shapes.size(); ++i) EXPECT_EQ(shapes[i], shapes[i % 2]);
  EXPECT_NE(shapes[0]->primitives, shapes[1]->primitives);
  EXPECT_NE(&prototypes.prototype({Species::kBush, 0}, 5, 0.2), shapes[0]);
}

TEST(PrototypeCache, GrowsFromTheHeadersTextsAndElseFromThoseShipped) {
  const auto shipped = plants::shipped_species();
  const PrototypeCache own(header_with_species({shipped.begin(), shipped.end()})), none(header_with_species({}));
  EXPECT_EQ(own.prototype({Species::kOak, 1}, 28, 0.5).primitives,
            none.prototype({Species::kOak, 1}, 28, 0.5).primitives);
  const PrototypeCache other(header_with_species(
      {{"oak", "module oak_leaf\nn: 1\naxiom: F(5)[+(40)F(3)~oak_leaf(2)]-(30)F(3)~oak_leaf(2)\n"}}));
  EXPECT_NE(other.prototype({Species::kOak, 1}, 28, 0.5).primitives,
            none.prototype({Species::kOak, 1}, 28, 0.5).primitives);
  EXPECT_FALSE(other.prototype({Species::kOak, 1}, 28, 0.5).primitives.empty());
}

TEST(PrototypeCache, GivesATileTheSameTreesSharedOrNot) {
  const scene::Header header = header_with_species({});
  const scene::Chunk chunk = planted(20);
  const double tolerances_m[] = {0.1, 2.5, 12.5};
  Report report;
  const auto prototypes = std::make_shared<const PrototypeCache>(header);
  const auto shared = bake(header, chunk, tolerances_m, 2, report, prototypes);
  EXPECT_EQ(bake(header, chunk, tolerances_m, 1, report), shared);
  EXPECT_EQ(bake(header, chunk, tolerances_m, 1, report, prototypes), shared);
}

TEST(PrototypeCache, GrowsInTheMonthOfTheHeadersSky) {
  scene::Header winter = header_with_species({});
  winter.origin = {13, 52}, winter.sky.time = sky::moment_of(std::chrono::year(2026) / 1 / 15, 12 * 60);
  EXPECT_NE(PrototypeCache(winter).prototype({Species::kOak, 0}, 28, 12.5).primitives,
            PrototypeCache(header_with_species({})).prototype({Species::kOak, 0}, 28, 12.5).primitives);
  EXPECT_EQ(PrototypeCache(winter).prototype({Species::kFir, 0}, 40, 12.5).primitives,
            PrototypeCache(header_with_species({})).prototype({Species::kFir, 0}, 40, 12.5).primitives);
}

// Each tree stands once, in its place and with its height.
TEST(PrototypeCache, LosesNoTreeWhereVariantsAreFewer) {
  const scene::Chunk chunk = planted(20);
  Report report;
  for (const double tolerance_m : {0.02, 0.5, 2.0, 11.0}) {
    const BakedTile tile = bake(header_with_species({}), chunk, tolerance_m, 1, report);
    std::vector<float> places;
    for (const InstancedMesh& trees : tile.instanced)
      for (std::size_t i = 0; i < trees.scales.size(); ++i) {
        places.push_back(trees.translations[i][0]);
        EXPECT_FLOAT_EQ(trees.scales[i] * 16, 12);
      }
    std::ranges::sort(places);
    ASSERT_EQ(places.size(), 20u) << tolerance_m;
    for (std::size_t i = 0; i < places.size(); ++i) EXPECT_FLOAT_EQ(places[i], 4.0f + 6 * static_cast<float>(i));
    EXPECT_LE(tile.instanced.size(), static_cast<std::size_t>(plants::variants_at(tolerance_m)));
  }
}

}  // namespace
}  // namespace citykiln::bake
