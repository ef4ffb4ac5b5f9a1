// A larger rule file, town_house.cga, from the file to the terminals.
#include <gtest/gtest.h>

#include "grammars/shapes/cut.h"
#include "tests/grammars/on_lot.h"
#include "tests/grammars/plain_roof.h"
#include "tests/grammars/rule_files.h"

namespace citykiln::grammars {
namespace {

Result<std::string> beside(const std::string& file) { return text_of_tree("tests/grammars/" + file); }

struct TownHouse : testing::Test {
  Result<Program> program = read_rules("town_house.cga", beside);

  Derivation house(double width_m, double depth_m, DeriveOptions options = {}, std::uint64_t id = 1) {
    EXPECT_TRUE(program) << to_string(program.error());
    options.roofs = plain_roof;
    return program ? derive(*program, lot_of(width_m, depth_m, id), options) : Derivation{};
  }
};

/// The sum of all area vectors: 0 for a closed surface, however its faces meet.
Vec3 area_vector_sum_m2(const Derivation& derivation) {
  Vec3 sum;
  for (const Terminal& terminal : derivation.terminals)
    for (const Face& face : terminal.faces) sum = sum + double_area_vector_m2(face) * 0.5;
  return sum;
}

double derived_volume_m3(const Derivation& derivation) {
  double sum = 0;
  for (const Terminal& terminal : derivation.terminals)
    for (const Face& face : terminal.faces) sum += dot(double_area_vector_m2(face) * 0.5, face.outer.front()) / 3;
  return sum;
}

TEST_F(TownHouse, HasItsWindowsDoorAndShop) {
  const Derivation derivation = house(11, 9);
  // three floors of five tiles; two panes in each window
  EXPECT_EQ(derivation.reports.size(), 1u);
  std::size_t window_panes = 0;
  for (const Terminal* pane : named(derivation, "GlassPane"))
    window_panes += path_name(derivation, pane->path).find("/Window/") != std::string::npos;
  EXPECT_EQ(window_panes, 3u * 5u * 2u);
  EXPECT_EQ(count_named(derivation, "DoorFrame"), 1u);
  EXPECT_EQ(count_named(derivation, "PlainFacade") + count_named(derivation, "StreetFacade"), 0u);
  EXPECT_TRUE(derivation.limits.empty());
}

TEST_F(TownHouse, IsClosedAtEveryTolerance) {
  for (const double tolerance_m : {0.0, 0.02, 0.1, 0.5, 2.5}) {
    DeriveOptions options;
    options.tolerance_m = tolerance_m;
    const Derivation derivation = house(11, 9, options);
    const Vec3 open = area_vector_sum_m2(derivation);
    EXPECT_NEAR(length(open), 0, 1e-6) << tolerance_m;
    // reveals take a little of the block, cornices and sills add a little
    EXPECT_NEAR(derived_volume_m3(derivation), 11 * 9 * 13.2, 11 * 9 * 13.2 * 0.02) << tolerance_m;
  }
}

TEST_F(TownHouse, LosesFacesWithTheTolerance) {
  std::size_t before = ~std::size_t{0};
  for (const double tolerance_m : {0.0, 0.1, 0.5, 2.5}) {
    DeriveOptions options;
    options.tolerance_m = tolerance_m;
    options.keep_appearances = true;
    const std::size_t faces = house(11, 9, options).terminals.size();
    EXPECT_LT(faces, before) << tolerance_m;
    before = faces;
  }
  EXPECT_LT(before, 20u);
}

TEST_F(TownHouse, WindowsAreNeverCutAtAWallsEnd) {
  std::size_t reveals = 0;
  for (double width_m = 3; width_m < 30; width_m += 0.37) {
    const Derivation derivation = house(width_m, 9);
    for (const Terminal* reveal : named(derivation, "Reveal")) {
      if (path_name(derivation, reveal->path).find("/Window/") == std::string::npos) continue;
      // 16 cm deep, along 1.10 m or 1.75 m
      const double along_m = area_m2(reveal->faces.at(0)) / 0.16;
      EXPECT_TRUE(std::abs(along_m - 1.10) < 1e-9 || std::abs(along_m - 1.75) < 1e-9) << width_m << " " << along_m;
      ++reveals;
    }
  }
  EXPECT_GT(reveals, 1000u);
}

TEST_F(TownHouse, NeighboursDiffer) {
  std::set<double> reds;
  for (std::uint64_t id = 1; id <= 20; ++id) {
    const Derivation derivation = house(11, 9, {}, id);
    reds.insert(derivation.appearances[named(derivation, "Wall").at(0)->appearance].red);
  }
  EXPECT_GT(reds.size(), 2u);
}

TEST_F(TownHouse, StandsOnAnyFootprint) {
  const std::vector<Polygon> footprints = {
      {{{0, 0}, {14, 0}, {14, 6}, {6, 6}, {6, 12}, {0, 12}}, {}},
      {{{0, 0}, {20, 0}, {20, 16}, {0, 16}}, {{{6, 5}, {6, 11}, {14, 11}, {14, 5}}}},
      {{{0, 0}, {9, 1}, {4, 7}}, {}},
      {{{0, 0}, {0.3, 0}, {0.3, 9}, {0, 9}}, {}},
  };
  ASSERT_TRUE(program);
  DeriveOptions options;
  options.roofs = plain_roof;
  for (const Polygon& footprint : footprints) {
    const Derivation derivation = derive(*program, lot(footprint, 3, 0, StableId{1}, {0, 1}), options);
    EXPECT_GT(derivation.terminals.size(), 3u);
    EXPECT_NEAR(length(area_vector_sum_m2(derivation)), 0, 1e-6);
  }
}

TEST_F(TownHouse, PartyWallsCarryNoWindows) {
  DeriveOptions options;
  options.answer_context_query = answer_from_neighbours({{{{{-1, -9}, {12, -9}, {12, 0}, {-1, 0}}, {}}, 0, 15}});
  const Derivation derivation = house(11, 9, options);
  EXPECT_EQ(count_named(derivation, "PartyWall"), 1u);
  EXPECT_EQ(count_named(derivation, "GlassPane"), 0u);
}

}  // namespace
}  // namespace citykiln::grammars
