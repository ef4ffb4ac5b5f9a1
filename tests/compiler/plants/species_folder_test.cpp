#include "compiler/plants/species_folder.h"

#include <gtest/gtest.h>

#include "compiler/plants/species_texts.h"

namespace citykiln::plants {
namespace {

constexpr const char* kTree =
    "Shape = 1\nScale = 9\nLevels = 2\n1Branches = 20\n1Length = 0.4\n1DownAngle = 60\nLeaves = 30\n";

UserSpecies species_of_folder(const std::vector<SpeciesText>& files) {
  Result<UserSpecies> own = read_species_folder(files, "mine");
  EXPECT_TRUE(own) << to_string(own.error());
  return own ? std::move(*own) : UserSpecies{};
}

map::PlantKind kind_of(Species species) { return static_cast<map::PlantKind>(static_cast<std::uint8_t>(species) + 1); }

TEST(SpeciesFolder, AFileAddsASpeciesWithThePlantsSize) {
  const UserSpecies own = species_of_folder({{"elder.tree", kTree}});
  const std::optional<Species> elder = own.table.named("elder");
  ASSERT_EQ(elder, static_cast<Species>(kFirstUserSpecies));
  // a trunk of 9 m; branches of at most 0.4 · 9 m to either side
  EXPECT_NEAR(own.table[*elder].height_m, 9, 0.6);
  EXPECT_GT(own.table[*elder].crown_share, 0.5);
  EXPECT_LT(own.table[*elder].crown_share, 0.95);
  EXPECT_NEAR(own.table[*elder].tallest_m, 1.4 * own.table[*elder].height_m, 1e-3);
  EXPECT_EQ(own.table[*elder].leaf, values_of(Species::kLime).leaf);
}

TEST(SpeciesFolder, RowsSayTheRest) {
  const UserSpecies own = species_of_folder(
      {{"elder.tree", kTree},
       {"species.txt",
        "elder like=birch height=5 tallest=7 crown=0.75 leaf=#ffffff bark=1,2,3 leaves=needle\noak leaf=9,8,7\n"}});
  const SpeciesValues& elder = own.table[*own.table.named("elder")];
  EXPECT_EQ(elder.height_m, 5);
  EXPECT_EQ(elder.tallest_m, 7);
  EXPECT_EQ(elder.crown_share, 0.75);
  EXPECT_EQ(elder.leaf, (Thousandths{1000, 1000, 1000}));
  EXPECT_EQ(elder.bark, (Thousandths{1, 2, 3}));
  EXPECT_EQ(elder.leaf_form, LeafForm::kNeedle);
  EXPECT_EQ(elder.months, values_of(Species::kBirch).months);
  // a row of a shipped species changes its values alone
  EXPECT_EQ(own.table[Species::kOak].leaf, (Thousandths{9, 8, 7}));
  EXPECT_EQ(own.table[Species::kOak].height_m, values_of(Species::kOak).height_m);
}

TEST(SpeciesFolder, TheManifestsTextsGiveTheSameTable) {
  const UserSpecies own = species_of_folder({{"elder.tree", kTree},
                                             {"oak.tree", kTree},
                                             {"species.txt", "elder names=sambucus like=birch\n"},
                                             {"spawners.txt", "natural=wood elder*2,oak 5 0.5 0.25 0.5..1\n"}});
  const SpeciesTable again(own.texts);
  for (const Species species : own.table.all()) {
    EXPECT_EQ(again[species].file, own.table[species].file);
    EXPECT_EQ(again[species].height_m, own.table[species].height_m);
    EXPECT_EQ(again[species].crown_share, own.table[species].crown_share);
    EXPECT_EQ(again[species].leaf, own.table[species].leaf);
  }
  const Spawner& spawner = again.spawner(species_mix_of_spawner(0));
  ASSERT_EQ(spawner.species.size(), 2u);
  EXPECT_EQ(spawner.species[0].species, *again.named("elder"));
  EXPECT_EQ(spawner.species[1].species, Species::kOak);
  EXPECT_EQ(spawner.probability, 0.5);
  EXPECT_EQ(spawner.from_scale, 0.5);
}

TEST(SpeciesFolder, AManifestHasTheFilesThatItsPlantsUse) {
  const UserSpecies own = species_of_folder({{"elder.tree", kTree}, {"oak.tree", kTree}, {"yew.tree", kTree}});
  Plants plants;
  for (const Species species : {*own.table.named("elder"), Species::kOak, Species::kBirch})
    plants.trees.push_back({.species_mix = species_mix_of(species)});
  std::vector<std::string> names;
  for (const SpeciesText& text : species_texts_for(plants, false, own.texts, own.table)) names.push_back(text.name);
  EXPECT_EQ(names, (std::vector<std::string>{"birch", "elder.tree", "oak.tree", "species.txt"}));
}

TEST(SpeciesFolder, NamesOfTagsChooseTheLongest) {
  const UserSpecies own = species_of_folder(
      {{"aspen.tree", kTree}, {"elder.tree", kTree}, {"species.txt", "aspen names=populus_tremula,Espe\n"}});
  const auto kind = [&](const char* text) { return map::user_kind_named(text, own.for_map.words); };
  EXPECT_EQ(kind("Populus tremula 'Erecta'"), kind_of(*own.table.named("aspen")));
  EXPECT_EQ(kind("espe"), kind_of(*own.table.named("aspen")));
  EXPECT_EQ(kind("Elder"), kind_of(*own.table.named("elder")));
  EXPECT_EQ(kind("Populus nigra"), map::PlantKind::kUnknown);
  EXPECT_EQ(kind("Elderberry"), map::PlantKind::kUnknown);
  EXPECT_EQ(species_mix_for({kind("Elder")}, {}), species_mix_of(*own.table.named("elder")));
}

TEST(SpeciesTable, NumbersWithoutASpeciesAreBushes) {
  EXPECT_EQ(shipped_table()[static_cast<Species>(77)].file, "bush");
  EXPECT_EQ(shipped_table().spawner(species_mix_of_spawner(3)).species.front().species, Species::kBush);
}

TEST(SpeciesTable, SpawnersDrawByShares) {
  const UserSpecies own =
      species_of_folder({{"elder.tree", kTree}, {"spawners.txt", "landuse=forest elder*3,oak 5 1 0 1\n"}});
  int elders = 0;
  for (int i = 0; i < 100; ++i)
    if (draw_species(own.table, species_mix_of_spawner(0), {}, 0, (i + 0.5) / 100) != Species::kOak) ++elders;
  EXPECT_EQ(elders, 75);
  EXPECT_EQ(name_of(own.table, species_mix_of_spawner(0)), "elder+oak");
}

TEST(SpeciesFolder, AtMost64SpeciesAreAdded) {
  std::vector<SpeciesText> files;
  for (char a = 'a'; a < 'f'; ++a)
    for (char b = 'a'; b < 'n'; ++b) files.push_back({std::string{a, b} + ".tree", "Levels = 1\nScale = 5\n"});
  const Result<UserSpecies> own = read_species_folder(files, "mine");
  ASSERT_FALSE(own);
  EXPECT_EQ(to_string(own.error()), "mine: expected at most 64 species, found 65");
}

}  // namespace
}  // namespace citykiln::plants
