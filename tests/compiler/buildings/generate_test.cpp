#include "compiler/buildings/generate.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "compiler/buildings/styles/building_materials.h"
#include "grammars/language/read_rules.h"
#include "tests/compiler/mesh_volume.h"

namespace citykiln::buildings {
namespace {

using materials::Material;

Building with_court(bool stands) {
  Building b;
  b.id = {{OsmType::kRelation, 7}, 0};
  b.footprint = {{{0, 0}, {30, 0}, {30, 20}, {12, 26}, {0, 20}}, {{{8, 6}, {8, 14}, {20, 14}, {20, 6}}}};
  b.bottom_m = b.floor_m = 10;
  b.top_m = 25;
  b.stands_on_ground = stands;
  b.wall = Material::kPlaster;
  b.roof = Material::kFlatRoof;
  return b;
}

// Without rules.
GeneratedBuilding bare(const Building& building, double tolerance_m) {
  Report report;
  return generate(building, {}, {1}, tolerance_m, report);
}

std::map<std::pair<Vec3, Vec3>, int> open_edges(const GeneratedBuilding& expanded) {
  std::map<std::pair<Vec3, Vec3>, int> edges;
  for (const auto& part : expanded.meshes)
    for (const Triangle& t : part.mesh.triangles)
      for (int i = 0; i < 3; ++i) {
        const Vec3 a = part.mesh.positions[t[i]], b = part.mesh.positions[t[(i + 1) % 3]];
        if (a < b)
          ++edges[{a, b}];
        else
          --edges[{b, a}];
      }
  std::erase_if(edges, [](const auto& edge) { return edge.second == 0; });
  return edges;
}

TEST(Generate, ClosesLiftedBuildings) { EXPECT_TRUE(open_edges(bare(with_court(false), 0.02)).empty()); }

TEST(Generate, IsOpenOnlyUnderTheGround) {
  const auto open = open_edges(bare(with_court(true), 0.02));
  EXPECT_EQ(open.size(), 9u);
  for (const auto& [edge, count] : open) {
    EXPECT_EQ(edge.first.z, 10);
    EXPECT_EQ(edge.second.z, 10);
  }
}

TEST(Generate, HasTheVolumeOfAreaTimesHeight) {
  const Building b = with_court(false);
  EXPECT_NEAR(volume_m3(bare(b, 0.02).meshes), area_m2(b.footprint) * 15, 1e-6);
}

TEST(Generate, DropsWhatIsLowerThanTheTolerance) {
  const GeneratedBuilding dropped = bare(with_court(true), 16);
  EXPECT_TRUE(dropped.meshes.empty());
  EXPECT_EQ(dropped.error_m, 15);
  EXPECT_EQ(bare(with_court(true), 12.5).error_m, 0);
}

// Roof structures made by rules count.
TEST(Generate, KeepsThinSlabsAboveTheGround) {
  // steps of a monument, such as w131446862 of Berlin: without all of them its base hangs in the air
  Building slab = with_court(false);
  slab.top_m = slab.bottom_m + 0.36;
  EXPECT_FALSE(bare(slab, 0.5).meshes.empty());
  EXPECT_TRUE(open_edges(bare(slab, 0.5)).empty());
  slab.stands_on_ground = true;
  EXPECT_TRUE(bare(slab, 0.5).meshes.empty());
}

TEST(Generate, KeepsBuildingsWithHigherRoofStructures) {
  Building b = with_court(true);
  b.style = Style::kBarn;
  Rulebook rulebook;
  rulebook.emplace(b.style, *grammars::read_rules_of("Building --> comp(f) { top : extrude(4) Block. | all : Wall. }"));
  Report report;
  EXPECT_FALSE(generate(b, rulebook, {1}, 16, report).meshes.empty());
  const GeneratedBuilding dropped = generate(b, rulebook, {1}, 20, report);
  EXPECT_TRUE(dropped.meshes.empty());
  EXPECT_EQ(dropped.error_m, 19);
}

TEST(Generate, SaysThatModelsAndTexturesOfRulesAreNotDrawn) {
  Building b = with_court(false);
  b.style = Style::kBarn;
  const auto diagnoses = [&](const char* rules) {
    Rulebook rulebook;
    rulebook.emplace(b.style, *grammars::read_rules_of(rules));
    Report report;
    generate(b, rulebook, {1}, 0.02, report);
    return report.counts()[Code::kRuleWithoutEffect];
  };
  EXPECT_EQ(diagnoses("Building --> comp(f) { top : i(\"tank\") Tank. | all : Wall. }"), 1u);
  EXPECT_EQ(diagnoses("Building --> texture(\"bricks.jpg\") comp(f) { all : Wall. }"), 1u);
  EXPECT_EQ(diagnoses("Building --> comp(f) { all : tileUV(0, 2, 1) Wall. }"), 1u);
  EXPECT_EQ(diagnoses("Building --> report(\"faces\", 1) comp(f) { all : Wall. }"), 0u);
}

TEST(Generate, IsTotalOnCrossingFootprints) {
  Building b = with_court(false);
  b.footprint = {{{0, 0}, {10, 10}, {10, 0}, {0, 14}}, {}};
  const GeneratedBuilding e = bare(b, 0.02);
  EXPECT_TRUE(open_edges(e).empty());
  EXPECT_GT(volume_m3(e.meshes), 40 * 15);
}

TEST(WallTint, DependsOnSeedAndIdAlone) {
  Building a = with_court(true), b = a;
  b.footprint.outer[2].x += 5;
  EXPECT_EQ(wall_tint(a, 3), wall_tint(b, 3));
  std::set<materials::Tint> tints;
  for (int i = 0; i < 100; ++i) {
    a.id.osm.id = i;
    tints.insert(wall_tint(a, 3));
  }
  EXPECT_GT(tints.size(), 60u);
}

TEST(WallTint, ShowsTheTaggedColour) {
  Building b = with_court(true);
  b.wall_colour = map::Srgb{200, 60, 40};
  const auto tint = wall_tint(b, 1);
  EXPECT_GT(tint[0], 2 * tint[1]);
  EXPECT_EQ(tint, wall_tint(b, 2));
}

// Rules read the form of the roof and build on it, so with rules the roof is not simplified to a flat one.
TEST(Generate, PassesRulesTheSameRoofFormOnEveryLevel) {
  Building b = with_court(true);
  b.footprint = {{{0, 0}, {12, 0}, {12, 9}, {0, 9}}, {}};
  b.style = Style::kBarn;
  b.roof_shape.form = roofs::RoofForm::kGabled, b.roof_shape.height_m = 2;
  Rulebook rulebook;
  const auto program = grammars::read_rules_of(R"(
attr roof = ""
Building --> case roof == "gabled" : t(0, 20, 0) Gabled. else : Other.
)");
  ASSERT_TRUE(program) << to_string(program.error());
  rulebook.emplace(b.style, *program);
  double highest_m = 0;
  Report report;
  for (const auto& part : generate(b, rulebook, {1}, 12.5, report).meshes)
    for (const Vec3 p : part.mesh.positions) highest_m = std::max(highest_m, p.z);
  EXPECT_GT(highest_m, 30);
}

}  // namespace
}  // namespace citykiln::buildings
