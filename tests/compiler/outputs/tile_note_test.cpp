#include "compiler/outputs/tile_note.h"

#include <gtest/gtest.h>

namespace citykiln::outputs {
namespace {

TileNote made_note() {
  TileNote note;
  note.tile = {.file = {"glb/-1_2_L3.glb", 500},
               .tile = {-1, 2},
               .level = 3,
               .tolerance_m = 0.1,
               .error_m = 1.0 / 3,
               .triangles = 6,
               .instances = 2};
  note.diagnosed.add(Code::kRuleErrors, {OsmType::kWay, -5}, 0.1 + 0.2);
  note.diagnosed.add_at(Code::kToleranceNotMet, {1.5, -2.25}, 7);
  note.diagnosed.add_pair(Code::kRuleErrors, {OsmType::kWay, 1}, {OsmType::kRelation, 2}, 3);
  note.diagnosed.add_tag(Code::kRuleErrors, {OsmType::kWay, 1}, "man_made", "mast");
  Account& account = note.diagnosed.account("bake", "derived lamp");
  account.in = 6, account.split = 1, account.out = 2, account.merged = 1, account.without_body = 3;
  note.diagnosed.drop(account, Code::kBelowTolerance, {OsmType::kNode, 9});
  return note;
}

TEST(TileNote, ReadsBackWhatItWrote) {
  const TileNote note = made_note();
  const std::optional<TileNote> back = tile_note(text_of(note));
  ASSERT_TRUE(back);
  EXPECT_EQ(text_of(*back), text_of(note));
  EXPECT_EQ(back->tile.file.name, "glb/-1_2_L3.glb");
  EXPECT_EQ(back->tile.tile, (scene::TileKey{-1, 2}));
  EXPECT_EQ(back->tile.error_m, 1.0 / 3);
  ASSERT_EQ(back->diagnosed.diagnoses().size(), 5u);
  EXPECT_EQ(back->diagnosed.diagnoses()[0].object, (OsmId{OsmType::kWay, -5}));
  EXPECT_EQ(back->diagnosed.diagnoses()[0].size, 0.1 + 0.2);
  EXPECT_EQ(back->diagnosed.diagnoses()[1].at_m, (std::array{1.5, -2.25}));
  EXPECT_EQ(back->diagnosed.diagnoses()[2].other, (OsmId{OsmType::kRelation, 2}));
  EXPECT_EQ(back->diagnosed.diagnoses()[3].tag, "man_made=mast");
  EXPECT_EQ(back->diagnosed.ledger().at("bake/derived lamp").without_body, 3u);
  EXPECT_EQ(back->diagnosed.ledger().at("bake/derived lamp").dropped.at(Code::kBelowTolerance), 1u);
  EXPECT_TRUE(back->diagnosed.balances());
}

TEST(TileNote, IsNothingForOtherTexts) {
  const std::string whole = text_of(made_note());
  for (const std::string& text :
       {std::string(), std::string("{}"), std::string("[1]"), whole.substr(0, whole.size() / 2)})
    EXPECT_FALSE(tile_note(text)) << text;
  std::string renamed = whole;
  renamed.replace(renamed.find("RuleErrors"), 10, "OtherError");
  EXPECT_FALSE(tile_note(renamed));
}

}  // namespace
}  // namespace citykiln::outputs
