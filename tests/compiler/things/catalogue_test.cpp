#include "compiler/things/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/map/things/thing_role.h"
#include "compiler/pitches/pitch_lines.h"
#include "compiler/pitches/pitch_rules.h"
#include "compiler/things/generate.h"

namespace citykiln::things {
namespace {

std::vector<RuleText> files(const std::string& row, const std::string& rules) {
  return {{"sundial.cga", rules}, {"things.txt", row}};
}

constexpr const char* kRow = "sundial amenity=sundial sundial 0.5x0.5x4 pole any 0 size Sundial";
constexpr const char* kRules = "Thing --> split(z) { ~1 : Pole. | 0.5 : color(\"#ff0000\") Dial. }";

std::string error_of(const std::vector<RuleText>& own) {
  const Result<Catalogue> catalogue = read_catalogue(own, "own");
  return catalogue ? "" : to_string(catalogue.error());
}

TEST(Catalogue, EveryShippedRowHasRulesThatMakeAMeshWithoutErrors) {
  const Result<Catalogue> catalogue = read_catalogue({}, "");
  ASSERT_TRUE(catalogue) << to_string(catalogue.error());
  EXPECT_GE(catalogue->table.size(), 100u);
  const Result<Kinds> kinds = kinds_of(*catalogue);
  ASSERT_TRUE(kinds) << to_string(kinds.error());
  for (const auto& [name, kind] : *kinds)
    for (const double tolerance_m : {0.01, 0.1, 0.5}) {
      const Form form{.kind = name,
                      .width_m = kind.row.width.default_m,
                      .depth_m = kind.row.depth.default_m,
                      .height_m = kind.row.height.default_m,
                      .value = kind.row.tags.empty() ? "" : kind.row.tags.front().front().value,
                      .text = "50"};
      const GeneratedThing thing = generate(form, kind, 1, false, tolerance_m);
      EXPECT_TRUE(thing.rule_faults.empty()) << name << thing.rule_faults.front().text;
      EXPECT_EQ(thing.meshes.empty(), !is_shown(form, kind.row, tolerance_m)) << name << " at " << tolerance_m;
      EXPECT_LE(thing.error_m, tolerance_m) << name;
    }
}

TEST(Catalogue, EveryRoleIsAShippedRowOfItsName) {
  const Result<Catalogue> catalogue = read_catalogue({}, "");
  ASSERT_TRUE(catalogue) << to_string(catalogue.error());
  for (int i = 1; i < static_cast<int>(map::ThingRole::kCount); ++i) {
    const auto role = static_cast<map::ThingRole>(i);
    EXPECT_EQ(map::role_of(map::name_of(role)), role);
    EXPECT_EQ(std::ranges::count(catalogue->table, map::name_of(role), &map::ThingRow::name), 1) << map::name_of(role);
  }
  EXPECT_EQ(map::role_of("bench"), map::ThingRole::kNone);
  EXPECT_EQ(map::role_of(""), map::ThingRole::kNone);
}

TEST(Catalogue, AFolderAddsRowsAndRules) {
  const Result<Catalogue> catalogue = read_catalogue(files(kRow, kRules), "own");
  ASSERT_TRUE(catalogue) << to_string(catalogue.error());
  EXPECT_EQ(catalogue->table.front().name, "sundial");
  const Kinds kinds = *kinds_of(*catalogue);
  EXPECT_EQ(kinds.at("sundial").row.class_name, "Sundial");
  EXPECT_TRUE(kinds.contains("bench"));
  EXPECT_EQ(kinds_of(*catalogue, {"bench"})->size(), 1u);
}

TEST(Catalogue, ABadFolderIsOneLine) {
  EXPECT_EQ(error_of({{"things.txt", kRow}}),
            "own/things.txt:1: rule: there is no file sundial.cga in the folder, nor a shipped one");
  EXPECT_EQ(error_of(files(kRow, "Lot --> Wall.")),
            "sundial.cga: expected a rule \"Thing\", found none (for the thing \"sundial\")");
  EXPECT_EQ(error_of(files("sundial amenity", kRules)).substr(0, 17), "own/things.txt:1:");
  EXPECT_EQ(error_of(files(kRow, "Thing --> split(")).substr(0, 14), "sundial.cga:1:");
}

TEST(Catalogue, AManifestHasWhatItsThingsNeed) {
  const Catalogue catalogue = *read_catalogue(files(kRow, kRules), "own");
  Thing sundial;
  sundial.form.kind = "sundial";
  const std::vector<RuleText> texts = texts_for(catalogue, *kinds_of(catalogue, {"sundial"}), std::span(&sundial, 1));
  ASSERT_EQ(texts.size(), 2u);
  EXPECT_EQ(texts[0], (RuleText{"sundial", kRow}));
  EXPECT_EQ(texts[1].name, "sundial.cga");
  const Kinds kinds = parse_kinds(texts);
  ASSERT_EQ(kinds.size(), 1u);
  EXPECT_EQ(kinds.at("sundial").row.class_name, "Sundial");
}

TEST(Generate, AThingIsTheBoxThatItsRulesDivide) {
  const Catalogue catalogue = *read_catalogue(files(kRow, kRules), "own");
  const Form form{.kind = "sundial", .width_m = 0.5, .depth_m = 0.5, .height_m = 4};
  const Kinds kinds = *kinds_of(catalogue, {"sundial"});
  const GeneratedThing thing = generate(form, kinds.at("sundial"), 1, false, 0.01);
  ASSERT_EQ(thing.meshes.size(), 2u);
  Box2 box;
  double top_m = 0, bottom_m = 9;
  for (const materials::MaterialMesh& mesh : thing.meshes)
    for (const Vec3 p : mesh.mesh.positions)
      box.grow(in_plan(p)), top_m = std::max(top_m, p.z), bottom_m = std::min(bottom_m, p.z);
  EXPECT_EQ(box.min, (Vec2{-0.25, -0.25}));
  EXPECT_EQ(box.max, (Vec2{0.25, 0.25}));
  EXPECT_EQ(top_m, 4);
  EXPECT_EQ(bottom_m, 0);
}

TEST(Catalogue, EquipmentOfPitchesHasRows) {
  const Result<Catalogue> catalogue = read_catalogue({}, "");
  ASSERT_TRUE(catalogue);
  for (std::size_t i = 0; i < pitches::pitch_rules().size(); ++i) {
    const pitches::Pitch pitch{{}, static_cast<pitches::PitchKind>(i), {0, 0}, {100, 0}, 50};
    for (const pitches::Equipment& equipment : pitches::equipment_of(pitch))
      EXPECT_EQ(std::ranges::count(catalogue->table, equipment.thing, &map::ThingRow::name), 1) << equipment.thing;
  }
}

}  // namespace
}  // namespace citykiln::things
