#include "compiler/bake/ground/ground_cells.h"

#include <gtest/gtest.h>

namespace citykiln::bake {
namespace {

using ground::LandCoverPolygon;
using map::LandCoverClass;

constexpr Box2 kTileOfTwoCells{{0, 0}, {256, 128}};

map::Heightfield rough_terrain() {
  map::Heightfield field{{-64, -64}, {32, 32}, 13, 9, {}, 0};
  for (int i = 0; i < 13 * 9; ++i) field.heights.push_back((i * 7919) % 640);
  return field;
}

ground::GradedTerrain graded_terrain(bool has_kerbs) {
  roads::Road road;
  road.id = {{OsmType::kWay, 99}, 0};
  road.axis = {{-40, 30}, {90, 60}, {300, 70}};
  road.surface = LandCoverClass::kResidentialRoad;
  road.section = {{{map::LaneKind::kSidewalk, map::LaneDirection::kBoth, 2, 0, true},
                   {map::LaneKind::kDriving, map::LaneDirection::kBoth, 6}},
                  5};
  road.profile = {{0, 8, 0}, {100, 3, 0}, {340, 6, 0}};
  return ground::grade_terrain(rough_terrain(),
                               {std::vector{road}, {}, {}, kTileOfTwoCells.widened(ground::kGrading_m), has_kerbs});
}

LandCoverPolygon land_cover_in(std::int64_t id, LandCoverClass surface, Ring ring) {
  return {{{OsmType::kWay, id}, 0}, surface, 5000, {std::move(ring)}};
}

std::vector<LandCoverPolygon> surfaces(bool has_strip) {
  std::vector<LandCoverPolygon> all = {
      land_cover_in(1, LandCoverClass::kMeadow, {{10, 10}, {120, 12}, {110, 100}, {12, 90}}),
      land_cover_in(2, LandCoverClass::kForest, {{140, -20}, {250, 20}, {200, 150}})};
  // in the western cell alone
  if (has_strip)
    all.push_back(land_cover_in(3, LandCoverClass::kResidentialRoad, {{-9, 20}, {60, 40}, {60, 46}, {-9, 26}}));
  return all;
}

void expect_equal(const ground::GroundMesh& one, const ground::GroundMesh& other) {
  EXPECT_EQ(one.mesh.positions, other.mesh.positions);
  EXPECT_EQ(one.mesh.normals, other.mesh.normals);
  EXPECT_EQ(one.mesh.triangles, other.mesh.triangles);
  EXPECT_EQ(one.face_cover, other.face_cover);
  EXPECT_EQ(one.error_m, other.error_m);
  EXPECT_EQ(one.border_error_m, other.border_error_m);
}

TEST(GroundOfALadder, IsThatOfItsLevels) {
  const ground::GradedTerrain fine = graded_terrain(true), coarse = graded_terrain(false);
  const std::vector<LandCoverPolygon> with = surfaces(true), without = surfaces(false);
  const std::vector<GroundLevel> levels = {{fine, with, 0.02}, {coarse, without, 0.5},  {fine, without, 0.1},
                                           {fine, with, 0.1},  {coarse, without, 12.5}, {coarse, with, 2.5}};
  std::vector<Report> reports(levels.size());
  const auto grounds = generate_cells(levels, kTileOfTwoCells, 2, reports);
  ASSERT_EQ(grounds.size(), levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    Report report;
    const auto alone =
        generate_cells(levels[i].graded, levels[i].surfaces, kTileOfTwoCells, levels[i].tolerance_m, 1, report);
    ASSERT_EQ(grounds[i].size(), alone.size());
    for (std::size_t c = 0; c < alone.size(); ++c) expect_equal(grounds[i][c], alone[c]);
    EXPECT_EQ(reports[i].diagnoses().size(), report.diagnoses().size());
  }
}

TEST(GroundOfALadder, KeepsTheReferencesThatCellsAreMeasuredAgainst) {
  const ground::GradedTerrain graded = graded_terrain(true);
  const std::vector<LandCoverPolygon> with = surfaces(true), without = surfaces(false);
  const std::vector<GroundLevel> levels = {{graded, with, 0.1}, {graded, without, 0.5}};
  std::vector<Report> reports(levels.size());
  std::vector<CellReferences> references(levels.size());
  generate_cells(levels, kTileOfTwoCells, 1, reports, references);
  const std::vector<Box2> cells = cells_of(kTileOfTwoCells);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    ASSERT_EQ(references[i].size(), cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const ground::Reference alone = ground::reference_of_cell(levels[i].surfaces, graded, cells[c]);
      for (const double share : {0.1, 0.3, 0.7}) {
        const Vec2 p = cells[c].min + (cells[c].max - cells[c].min) * share;
        EXPECT_EQ(heights_at(*references[i][c], place_at(*references[i][c], p)), heights_at(alone, place_at(alone, p)));
      }
    }
  }
  // the surfaces differ in the western cell alone
  EXPECT_NE(references[0].front(), references[1].front());
  EXPECT_EQ(references[0].back(), references[1].back());
}

// Faces refer to the surfaces of their own level.
TEST(GroundOfALadder, NamesTheSurfacesOfEachLevel) {
  const ground::GradedTerrain graded = graded_terrain(false);
  const std::vector<LandCoverPolygon> some = surfaces(false);
  const std::vector<LandCoverPolygon> turned(some.rbegin(), some.rend());
  const std::vector<GroundLevel> levels = {{graded, some, 0.5}, {graded, turned, 0.5}};
  std::vector<Report> reports(levels.size());
  const auto grounds = generate_cells(levels, kTileOfTwoCells, 1, reports);
  ASSERT_FALSE(grounds[0].empty());
  for (std::size_t c = 0; c < grounds[0].size(); ++c) {
    ASSERT_EQ(grounds[0][c].face_cover.size(), grounds[1][c].face_cover.size());
    for (std::size_t f = 0; f < grounds[0][c].face_cover.size(); ++f) {
      const std::uint32_t one = grounds[0][c].face_cover[f], other = grounds[1][c].face_cover[f];
      if (one == ground::kNoLandCover)
        EXPECT_EQ(other, ground::kNoLandCover);
      else
        EXPECT_EQ(some[one], turned[other]);
    }
  }
}

}  // namespace
}  // namespace citykiln::bake
