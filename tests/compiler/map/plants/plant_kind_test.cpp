#include "compiler/map/plants/plant_kind.h"

#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

// Names of trees in real extracts, and the kind that they belong to.
TEST(KindNamed, KnowsGenusSpeciesAndCommonNames) {
  const std::pair<const char*, PlantKind> names[] = {{"Tilia", PlantKind::kLime},
                                                     {"Tilia cordata", PlantKind::kLime},
                                                     {"Prunus avium", PlantKind::kApple},
                                                     {"BETULA", PlantKind::kBirch},
                                                     {"Winterlinde", PlantKind::kLime},
                                                     {"Amerikanische Linde", PlantKind::kLime},
                                                     {"Blautanne", PlantKind::kSpruce},
                                                     {"Tanne", PlantKind::kFir},
                                                     {"Schwarzkiefer", PlantKind::kPine},
                                                     {"Rosskastanie", PlantKind::kOak},
                                                     {"Hainbuche", PlantKind::kBeech},
                                                     {"Eberesche", PlantKind::kMaple},
                                                     {"Gemeine Esche", PlantKind::kMaple},
                                                     {"Kirsche", PlantKind::kApple},
                                                     {"Pappel", PlantKind::kPoplar},
                                                     {"Mangueira (Mangifera indica)", PlantKind::kBanyan},
                                                     {"\u00c9rable sycomore", PlantKind::kMaple},
                                                     {"alzina", PlantKind::kOak},
                                                     {"Olea europaea", PlantKind::kOlive},
                                                     {"Europ\u00e4ische L\u00e4rche", PlantKind::kLarch},
                                                     {"Acacia dealbata", PlantKind::kAcacia},
                                                     {"Artemisia tridentata", PlantKind::kSagebrush},
                                                     {"apple_trees", PlantKind::kApple},
                                                     {"grape", PlantKind::kVine},
                                                     {"wheat;maize", PlantKind::kWheat}};
  for (const auto& [name, kind] : names) EXPECT_EQ(kind_named(name), kind) << name;
}

TEST(KindNamed, KnowsNothingElse) {
  for (const char* name : {"", "  ", "Pendula", "unknown", "ash-tray-maker's", "\xc3", "x\xff", "Treeless"})
    EXPECT_TRUE(kind_named(name) == PlantKind::kUnknown || std::string(name).starts_with("ash")) << name;
}

TEST(PlantTags, OfTreesIsTaxonLeavesAndSize) {
  Report report;
  const Features f = features_of(R"(
    n1 3:4 natural=tree species=Quercus~robur diameter_crown=12 circumference=2.1 start_date=1955
    n2 5:4 natural=tree leaf_type=needleleaved genus=Unheard
    n3 6:4 natural=shrub genus=Tilia
    n4 7:4 natural=tree circumference=85 est_height=7
    n5 8:4 natural=tree species:de=Spitzahorn type=conifer)",
                                 report);
  ASSERT_EQ(f.points.size(), 5u);
  const auto tags_of = [&](std::size_t i) { return f.points[i].plant_tags; };
  EXPECT_EQ(tags_of(0), (PlantTags{PlantKind::kOak, LeafType::kUnknown, 12, 2.1, 1955}));
  EXPECT_EQ(tags_of(1), (PlantTags{PlantKind::kUnknown, LeafType::kNeedle}));
  EXPECT_EQ(tags_of(2).kind, PlantKind::kBush);
  EXPECT_EQ(tags_of(3).girth_m, 0.85);
  EXPECT_EQ(f.points[3].height_m, 7);
  EXPECT_EQ(tags_of(4), (PlantTags{PlantKind::kMaple, LeafType::kNeedle}));
  EXPECT_TRUE(report.balances());
}

TEST(PlantTags, OfAreasIsTreesCropAndLeaves) {
  const Features f = features_of(R"(
    r1 0:0 90:0 90:90 0:90 landuse=orchard trees=olive_trees
    r2 0:0 90:0 90:90 0:90 landuse=farmland crop=maize
    r3 0:0 90:0 90:90 0:90 natural=wood leaf_cycle=evergreen
    r4 0:0 90:0 90:90 0:90 natural=wood wood=deciduous
    r5 0:0 90:0 90:90 0:90 landuse=residential crop=maize)");
  ASSERT_EQ(f.areas.size(), 5u);
  EXPECT_EQ(f.areas[0].plant_tags.kind, PlantKind::kOlive);
  EXPECT_EQ(f.areas[1].plant_tags.kind, PlantKind::kMaize);
  EXPECT_EQ(f.areas[2].surface, LandCoverClass::kNeedleLeavedForest);
  EXPECT_EQ(f.areas[3].surface, LandCoverClass::kBroadLeavedForest);
  EXPECT_EQ(f.areas[4].plant_tags, PlantTags{});
}

TEST(PlantTags, OfRowsPowerLinesAndStreetsIsRead) {
  Report report;
  const Features f = features_of(R"(
    w1 0:0 90:0 natural=tree_row genus=Populus height=20 spacing=6
    w2 0:5 90:5 power=line
    w3 0:9 90:9 power=minor_line location=underground
    w4 0:9 90:9 power=cable
    w5 0:20 90:20 highway=residential tree_lined=yes
    w6 0:30 90:30 highway=residential tree_lined=left
    w7 0:40 90:40 highway=residential tree_lined=separate)",
                                 report);
  ASSERT_EQ(f.tree_rows.size(), 1u);
  EXPECT_EQ(f.tree_rows[0].plant_tags.kind, PlantKind::kPoplar);
  EXPECT_EQ(f.tree_rows[0].spacing_m, 6);
  EXPECT_EQ(f.tree_rows[0].height_m, 20);
  ASSERT_EQ(f.power_lines.size(), 1u);
  EXPECT_GT(f.power_lines[0].corridor_m, 10);
  ASSERT_EQ(f.tracks.size(), 3u);
  EXPECT_EQ(f.tracks[0].trees, TreeSides::kBoth);
  EXPECT_EQ(f.tracks[1].trees, TreeSides::kLeft);
  EXPECT_EQ(f.tracks[2].trees, TreeSides::kNone);
  EXPECT_TRUE(report.balances());
}

}  // namespace
}  // namespace citykiln::map
