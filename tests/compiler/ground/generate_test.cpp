#include "compiler/ground/generate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "compiler/contract/random_sequence.h"
#include "compiler/contract/tolerance.h"
#include "compiler/ground/landforms/landform_index.h"
#include "compiler/ground/plan.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::ground {
namespace {

using map::Heightfield;
using map::LandCoverClass;

constexpr Box2 kGeneratedCell{{0, 0}, {128, 128}};

// Powers of two put lines of the field on borders of cells, others do not.
constexpr Vec2 kSteps_m[] = {{16, 16}, {68, 92}, {64, 64}, {15, 11}, {9.5, 22}};

Heightfield rough_field(Vec2 step_m, double height_m) {
  const auto steps = [](double length_m, double step) { return static_cast<int>(std::ceil(length_m / step)); };
  const int west = steps(256, step_m.x), south = steps(256, step_m.y);
  Heightfield field{{-west * step_m.x, -south * step_m.y}, step_m, west + steps(512, step_m.x) + 1,
                    south + steps(512, step_m.y) + 1,      {},     0};
  const RandomSequence draw(1, StableId{2}, "heights");
  for (int i = 0; i < field.columns * field.rows; ++i)
    field.heights.push_back(
        static_cast<std::int32_t>(draw.unit(static_cast<std::uint32_t>(i)) * height_m / map::kHeightQuantum_m));
  return field;
}

// Crossing and overlapping triangles and quads of several classes.
std::vector<LandCoverPolygon> crossing_surfaces(std::uint64_t seed, int count) {
  constexpr LandCoverClass kClasses[] = {LandCoverClass::kMeadow, LandCoverClass::kForest, LandCoverClass::kLake,
                                         LandCoverClass::kResidentialRoad, LandCoverClass::kBuilding};
  std::vector<LandCoverPolygon> surfaces;
  const RandomSequence draw(seed, StableId{3}, "surfaces");
  for (int s = 0; s < count; ++s) {
    Ring ring;
    for (int i = 0; i < 3; ++i) {
      const auto index = static_cast<std::uint32_t>(s * 6 + i * 2);
      ring.push_back({std::floor(draw.between(-60, 316, index) * 1024) / 1024,
                      std::floor(draw.between(-60, 190, index + 1) * 1024) / 1024});
    }
    if (signed_area_m2(ring) < 0) std::reverse(ring.begin(), ring.end());
    surfaces.push_back(
        {{{OsmType::kWay, s + 1}, 0}, kClasses[s % 5], static_cast<std::uint32_t>(signed_area_m2(ring)), {ring}});
  }
  return surfaces;
}

double plan_area_m2(const GroundMesh& g) {
  double twice = 0;
  for (const Triangle& t : g.mesh.triangles) {
    const Vec2 a = in_plan(g.mesh.positions[t[0]]);
    const double one = cross(in_plan(g.mesh.positions[t[1]]) - a, in_plan(g.mesh.positions[t[2]]) - a);
    EXPECT_GT(one, 0);
    twice += one;
  }
  return twice / 2;
}

TEST(Ground, FacesTileTheCellExactly) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Report report;
    const GroundMesh g = generate_cell(crossing_surfaces(seed, 30), GradedTerrain(rough_field({16, 16}, 20)),
                                       kGeneratedCell, 0.5, report);
    EXPECT_EQ(plan_area_m2(g), 128.0 * 128.0) << "seed " << seed;
  }
}

TEST(Ground, EachInnerEdgeHasTwoFaces) {
  Report report;
  const GroundMesh g =
      generate_cell(crossing_surfaces(4, 30), GradedTerrain(rough_field({16, 16}, 20)), kGeneratedCell, 0.5, report);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> faces;
  for (const Triangle& t : g.mesh.triangles)
    for (int i = 0; i < 3; ++i) ++faces[std::minmax(t[i], t[(i + 1) % 3])];
  ASSERT_FALSE(faces.empty());
  for (const auto& [edge, count] : faces) {
    const Vec3 a = g.mesh.positions[edge.first], b = g.mesh.positions[edge.second];
    const bool on_border = (a.x == b.x && (a.x == 0 || a.x == 128)) || (a.y == b.y && (a.y == 0 || a.y == 128));
    EXPECT_EQ(count, on_border ? 1 : 2);
  }
}

TEST(Ground, EachFaceHasTheSurfaceOnTop) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Report report;
    const auto surfaces = crossing_surfaces(seed, 20);
    const GroundMesh g = generate_cell(surfaces, GradedTerrain(rough_field({16, 16}, 20)), kGeneratedCell, 0.5, report);
    const LandCoverIndex map = index_land_cover(surfaces, kGeneratedCell);
    ASSERT_FALSE(g.mesh.triangles.empty());
    double wrong_m2 = 0;
    for (std::size_t f = 0; f < g.mesh.triangles.size(); ++f) {
      const Triangle& t = g.mesh.triangles[f];
      const Vec2 a = in_plan(g.mesh.positions[t[0]]), b = in_plan(g.mesh.positions[t[1]]),
                 c = in_plan(g.mesh.positions[t[2]]);
      const Vec2 centre = (a + b + c) * (1.0 / 3);
      if (land_cover_at(map, centre) != g.face_cover[f]) wrong_m2 += cross(b - a, c - a) / 2;
    }
    // rounding moves borders by at most a grid step: 1 mm along some 3 km of them
    EXPECT_LT(wrong_m2, 3) << "seed " << seed;
  }
}

TEST(Ground, StatedErrorIsNeverExceeded) {
  const std::pair<double, Vec2> cases[] = {{0.02, kSteps_m[0]}, {0.5, kSteps_m[3]}, {5.0, kSteps_m[4]}};
  for (const auto& [tolerance_m, step_m] : cases) {
    Report report;
    const Heightfield field = rough_field(step_m, 40);
    const GroundMesh g =
        generate_cell(crossing_surfaces(9, 20), GradedTerrain(Heightfield(field)), kGeneratedCell, tolerance_m, report);
    EXPECT_LE(g.error_m, tolerance_m);
    const RandomSequence draw(1, StableId{4}, "samples");
    double largest = 0;
    for (std::uint32_t i = 0; i < 200000; ++i) {
      const Triangle& t = g.mesh.triangles[i % g.mesh.triangles.size()];
      double u = draw.unit(2 * i), v = draw.unit(2 * i + 1);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec3 a = g.mesh.positions[t[0]];
      const Vec3 p = a + (g.mesh.positions[t[1]] - a) * u + (g.mesh.positions[t[2]] - a) * v;
      largest = std::max(largest, std::abs(p.z - map::height_m_at(field, in_plan(p))));
    }
    EXPECT_LE(largest, g.error_m + 1e-9);
    EXPECT_GE(largest, g.error_m * 0.3);
  }
}

std::vector<Vec3> on_line_x(const GroundMesh& g, double x) {
  std::vector<Vec3> points;
  for (const Vec3 p : g.mesh.positions)
    if (p.x == x) points.push_back(p);
  std::sort(points.begin(), points.end());
  return points;
}

// Slivers beside a border that is off by nearly the tolerance were once off by more.
TEST(Ground, KeepsItsToleranceBesideCellBordersToo) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Heightfield field{{0, 0}, {64, 64}, 17, 17, {}, 0};
    const RandomSequence draw(seed, StableId{4}, "mountains");
    for (std::uint32_t i = 0; i < 17 * 17; ++i) {
      const double slope_m = 40.0 * (i % 17) + 25.0 * (i / 17), metres = slope_m + draw.between(0, 30, i);
      field.heights.push_back(static_cast<std::int32_t>(metres / map::kHeightQuantum_m));
    }
    Report report;
    EXPECT_LE(generate_cell({}, GradedTerrain(Heightfield(field)), {{0, 0}, {1024, 1024}}, 5, report).error_m, 5)
        << "seed " << seed;
    EXPECT_TRUE(report.counts().empty());
  }
}

TEST(Ground, CellsGeneratedApartMeetVertexForVertex) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Report report;
    const auto surfaces = crossing_surfaces(seed, 40);
    const Heightfield field = rough_field(kSteps_m[seed % 5], 20);
    std::vector<LandCoverPolygon> trimmed;
    for (const LandCoverPolygon& s : surfaces) trimmed.push_back(trimmed_to(s, Box2{{128, 0}, {256, 128}}.widened(1)));
    const GroundMesh west = generate_cell(surfaces, GradedTerrain(Heightfield(field)), kGeneratedCell, 0.1, report);
    const GroundMesh east =
        generate_cell(trimmed, GradedTerrain(Heightfield(field)), {{128, 0}, {256, 128}}, 0.1, report);
    EXPECT_GE(on_line_x(west, 128).size(), 2u);
    EXPECT_EQ(on_line_x(west, 128), on_line_x(east, 128)) << "seed " << seed;
  }
}

// A kerb that crosses x = 128 so steeply that snapping bends it along that line, from its crossing to a garden's corner
// some grid steps to the north.
std::vector<LandCoverPolygon> kerb_along_a_border(std::int64_t steps, double lean_m, bool is_in_the_west) {
  const auto surface = [](std::int64_t id, LandCoverClass of, std::uint32_t area_m2, Ring ring) {
    return LandCoverPolygon{{{OsmType::kWay, id}, 0}, of, area_m2, {std::move(ring)}};
  };
  const Vec2 south{128 - lean_m, 32}, north{128 + lean_m, 96};
  const Ring lane =
      is_in_the_west ? Ring{{122, 32}, south, north, {122, 96}} : Ring{south, {134, 32}, {134, 96}, north};
  const double corner_m = 64 + static_cast<double>(steps) * kQuantum_m;
  return {surface(1, LandCoverClass::kResidentialRoad, kStripArea_m2, lane),
          surface(2, LandCoverClass::kPavement, kStripArea_m2, {{118, 20}, {138, 20}, {138, 108}, {118, 108}}),
          surface(3, LandCoverClass::kGarden, 900, {{128, corner_m}, {160, 112}, {96, 112}})};
}

GradedTerrain terrain_with_kerbs(std::span<const LandCoverPolygon> surfaces, const Box2& box, double rough_m = 16,
                                 std::span<const roads::Road> bores = {}) {
  roads::Road road = roads::made_road(1, {{128, -40}, {128, 168}}, 12, LandCoverClass::kResidentialRoad, 4, 4);
  road.profile = {{0, 20, 0}, {208, 24, 0}};
  return grade_terrain(rough_field({64, 64}, rough_m),
                       {std::vector{road}, {}, surfaces, box.widened(kGrading_m), true, {}, bores});
}

using MetEdge = std::pair<Vec3, Vec3>;

// How often the edges on the line x = 128 occur, without vertical ones.
std::map<MetEdge, int> met_on_line(std::span<const GroundMesh> cells) {
  std::map<MetEdge, int> met;
  for (const GroundMesh& cell : cells)
    for (const Triangle& t : cell.mesh.triangles)
      for (int i = 0; i < 3; ++i) {
        const Vec3 a = cell.mesh.positions[t[i]], b = cell.mesh.positions[t[(i + 1) % 3]];
        if (a.x == 128 && b.x == 128 && a.y != b.y) ++met[std::minmax(a, b)];
      }
  return met;
}

TEST(Ground, CellsGeneratedApartAreClosedWhereAKerbRunsAlongTheirBorder) {
  constexpr Box2 kEast{{128, 0}, {256, 128}};
  int steps_of_a_cell = 0;
  for (int round = 0; round < 64; ++round) {
    const auto surfaces = kerb_along_a_border(1 + round % 8, round % 16 < 8 ? 0.5 : 2, round % 32 < 16);
    const double tolerance_m = round < 32 ? 0.1 : 2.5;
    const auto cell = [&](const Box2& box) {
      Report report;
      return generate_cell(surfaces, terrain_with_kerbs(surfaces, box), box, tolerance_m, report);
    };
    const std::vector cells = {cell(kGeneratedCell), cell(kEast)};
    for (const auto& [edge, count] : met_on_line(cells)) {
      EXPECT_EQ(count % 2, 0) << "round " << round << " at " << edge.first.y << ", " << edge.first.z;
      steps_of_a_cell += count > 2;
    }
    for (const auto& [edge, count] : met_on_line(std::span(cells).first(1))) steps_of_a_cell += count > 1;
  }
  EXPECT_GT(steps_of_a_cell, 10);
}

// The mouth of a tunnel crosses the border where a kerb runs along it for some grid steps.
TEST(Ground, CellsGeneratedApartAreClosedInAMouthThatCrossesTheirBorder) {
  roads::Road bore = roads::made_road(2, {{128, 64}, {168, 64}}, 8, LandCoverClass::kResidentialRoad, 4, 4);
  bore.profile = {{0, 22, 0}, {40, 22, 0}};
  int steps = 0;
  for (int round = 0; round < 32; ++round) {
    const auto surfaces = kerb_along_a_border(1 + round % 8, round % 16 < 8 ? 0.5 : 2, round >= 16);
    const auto cell = [&](const Box2& box) {
      Report report;
      return generate_cell(surfaces, terrain_with_kerbs(surfaces, box, 16, std::span(&bore, 1)), box, 0.1, report);
    };
    const std::vector cells = {cell(kGeneratedCell), cell({{128, 0}, {256, 128}})};
    for (const auto& [edge, count] : met_on_line(cells))
      EXPECT_EQ(count % 2, 0) << "round " << round << " at " << edge.first.y << ", " << edge.first.z;
    // an edge with two faces of one cell has a vertical one
    for (const std::size_t one : {0, 1})
      for (const auto& [edge, count] : met_on_line(std::span(cells).subspan(one, 1)))
        steps += std::abs(edge.first.y - 64) < 0.1 && edge.second.y - edge.first.y < 0.01 && count > 1;
  }
  EXPECT_GT(steps, 10);
}

// On level terrain, without a line of its grid through the corner.
TEST(Ground, CellsGeneratedApartAreClosedWhereAKerbRunsAlongTheirBorderPastACorner) {
  const std::vector<LandCoverPolygon> surfaces = {{{{OsmType::kWay, 1}, 0},
                                                   LandCoverClass::kResidentialRoad,
                                                   kStripArea_m2,
                                                   {{{122, -20}, {128, -20}, {128, 20}, {122, 20}}}},
                                                  {{{OsmType::kWay, 2}, 0},
                                                   LandCoverClass::kPavement,
                                                   kStripArea_m2,
                                                   {{{118, -30}, {138, -30}, {138, 30}, {118, 30}}}}};
  for (const double tolerance_m : {0.1, 2.5}) {
    const auto cell = [&](const Box2& box) {
      Report report;
      return generate_cell(surfaces, terrain_with_kerbs(surfaces, box, 0), box, tolerance_m, report);
    };
    const std::vector cells = {cell(kGeneratedCell), cell({{128, 0}, {256, 128}})};
    int steps = 0;  // both sides of the step and the diagonal of its face
    for (const auto& [edge, count] : met_on_line(cells)) {
      EXPECT_EQ(count % 2, 0) << "at " << edge.first.y << ", " << edge.first.z;
      steps += edge.first.y == 0 && edge.second.y > 0;
    }
    EXPECT_EQ(steps, 3);
  }
}

// On the side between both cells the finer tolerance holds, and the coarser cell keeps its own.
TEST(Ground, CellsOfUnequalTolerancesMeetVertexForVertex) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Report report;
    const auto surfaces = crossing_surfaces(seed, 40);
    const Heightfield field = rough_field(kSteps_m[seed % 5], 20);
    const SideTolerances sides{0.1, 1.6, 1.6, 1.6};
    const Box2 beside{{128, 0}, {256, 128}};
    const GroundMesh west = generate_cell(surfaces, GradedTerrain(Heightfield(field)), kGeneratedCell, 0.1, report);
    const GradedTerrain graded{Heightfield(field)};
    GradedNormals normals(graded);
    const GroundMesh east = generate_cell(prepare_cell(surfaces, graded, beside), normals, 1.6, sides, report);
    const GroundMesh coarse = generate_cell(surfaces, GradedTerrain(Heightfield(field)), beside, 1.6, report);
    EXPECT_GE(on_line_x(west, 128).size(), 2u);
    EXPECT_EQ(on_line_x(west, 128), on_line_x(east, 128)) << "seed " << seed;
    EXPECT_EQ(on_line_x(coarse, 256), on_line_x(east, 256)) << "seed " << seed;
    EXPECT_LE(length(Vec2{east.error_m, east.border_error_m}), 1.6) << "seed " << seed;
    // where there is more in the cell than on its sides
    if (field.longer_sample_step_m() < 32) {
      EXPECT_LT(east.mesh.triangles.size(), west.mesh.triangles.size());
    }
  }
}

// A road higher than the ground anywhere, without influence on the cell to the west.
GradedTerrain graded_in_the_east(const Heightfield& field) {
  roads::Road road;
  road.id = {{OsmType::kWay, 99}, 0};
  road.axis = {{230, -40}, {235, 60}, {228, 170}};
  road.surface = LandCoverClass::kResidentialRoad;
  road.section.lanes = {{}};
  road.profile = {{0, 30, 0}, {100, 35, 0}, {212, 25, 0}};
  return grade_terrain(Heightfield(field), {std::vector{road}, {}, {}, Box2{{0, 0}, {256, 128}}.widened(kGrading_m)});
}

// One cell is measured against a triangulation, the other against the terrain.
TEST(Ground, CellsWithAndWithoutGradingMeetVertexForVertex) {
  constexpr Box2 kEast{{128, 0}, {256, 128}};
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Report report;
    const Heightfield field = rough_field(kSteps_m[seed % 5], 20);
    const GradedTerrain graded = graded_in_the_east(field);
    ASSERT_FALSE(has_grading(graded, kGeneratedCell));
    ASSERT_TRUE(has_grading(graded, kEast));
    const auto surfaces = crossing_surfaces(seed, static_cast<int>(seed % 4) * 4);
    for (const double tolerance_m : {0.02, 0.5, 12.5}) {
      const GroundMesh west = generate_cell(surfaces, graded, kGeneratedCell, tolerance_m, report);
      const GroundMesh east = generate_cell(surfaces, graded, kEast, tolerance_m, report);
      EXPECT_GE(on_line_x(west, 128).size(), 2u);
      EXPECT_EQ(on_line_x(west, 128), on_line_x(east, 128)) << "seed " << seed << ", " << tolerance_m << " m";
    }
  }
}

// The mesh is the field's own triangles, without points between samples.
TEST(Ground, AtFullDetailACellWithoutGradingIsTheTerrain) {
  for (const Vec2 step_m : {Vec2{16, 16}, {8, 32}, {32, 16}}) {
    Report report;
    const GroundMesh g = generate_cell({}, GradedTerrain(rough_field(step_m, 40)), kGeneratedCell, 0.02, report);
    EXPECT_LE(g.error_m, 0.02);
    EXPECT_EQ(static_cast<double>(g.mesh.triangles.size()), 2 * (128 / step_m.x) * (128 / step_m.y));
  }
}

// The sea and a lake 1.9 m above it leave a strip of land between them that is a grid step wide: it rises where there
// is no room for a vertex, and keeps the tolerance with edges of the reference (mesh/reference_edges.h) alone.
TEST(Ground, ADamOneGridStepWideKeepsItsTolerance) {
  std::vector<LandCoverPolygon> waters = {
      {{{OsmType::kWay, 1}, 0}, LandCoverClass::kSea, 17224, {{{16, 128}, {0, 127.9921875}, {-16, 128}}}},
      {{{OsmType::kWay, 2}, 0}, LandCoverClass::kLake, 307, {{{8, 128 - kQuantum_m}, {48, 128}, {0, 144}}}}};
  waters[0].level_m = 0, waters[1].level_m = 1.875;
  const std::vector<std::int32_t> heights = {152, 119, 132, 121, 233, 79,  239, 47,
                                             139, 25,  208, 213, 226, 112, 75,  189};
  constexpr Box2 kNorth{{0, 96}, {32, 128}};
  const GradedTerrain graded =
      grade_terrain({{-128, -128}, {128, 128}, 4, 4, heights, 0}, {{}, {}, waters, kNorth.widened(kGrading_m)});
  Report report;
  const GroundMesh g = generate_cell(waters, graded, kNorth, 0.02, report);
  EXPECT_LE(length(Vec2{g.error_m, g.border_error_m}), 0.02);
}

// A wall from west to east near y = 0 that rises by up to 12 m within 0.375 m.
Landform wall_beside_the_border(const RandomSequence& draw, std::uint32_t index) {
  const auto between = [&](std::uint32_t i, double low, double high) {
    return std::floor(draw.between(low, high, index * 8 + i) / kQuantum_m) * kQuantum_m;
  };
  Landform wall;
  wall.id = {{OsmType::kWay, index}, 0}, wall.kind = LandformKind::kStep;
  wall.axis = {{between(0, 0, 128), between(1, -0.5, 0.5)}, {between(2, 0, 128), between(3, -0.5, 0.5)}};
  wall.left_m = wall.right_m = 0.1875;
  const double middle_m = between(4, 95, 105), tilt = between(5, 4, 32);
  wall.profile = {{0, middle_m, tilt}, {distance(wall.axis[0], wall.axis[1]), middle_m, tilt}};
  return wall;
}

// Three walls along the cell's border that cross it and each other. The seeds are those of 400 that were off by up to
// 0.19 m while the border was split at half the tolerance.
TEST(Ground, KeepsItsToleranceWhereWallsCrossTheCellsBorder) {
  for (const std::uint64_t seed : {163, 184, 251, 267}) {
    Heightfield field{{-128, -128}, {32, 32}, 13, 9, {}, 0};
    const RandomSequence draw(seed, StableId{5}, "walls");
    for (std::uint32_t i = 0; i < 13 * 9; ++i)
      field.heights.push_back(static_cast<std::int32_t>(draw.between(95, 105, 1000 + i) / map::kHeightQuantum_m));
    std::vector<Landform> walls;
    for (std::uint32_t i = 1; i <= 3; ++i) walls.push_back(wall_beside_the_border(draw, i));
    GradedTerrain graded(std::move(field));
    graded.landforms = index_landforms(walls);
    Report report;
    const GroundMesh g = generate_cell({}, graded, kGeneratedCell, 0.05, report);
    EXPECT_LE(length(Vec2{g.error_m, g.border_error_m}), 0.05) << "seed " << seed;
    EXPECT_TRUE(report.counts().empty()) << "seed " << seed;
  }
}

TEST(Ground, TerrainLinesLeaveNoVertexOnTheBorderThatHeightsDoNotAskFor) {
  Report report;
  EXPECT_EQ(
      generate_cell({}, GradedTerrain(rough_field({16, 16}, 20)), kGeneratedCell, 41, report).mesh.triangles.size(),
      2u);
  const Heightfield field = rough_field({16, 16}, 0.25);
  const GroundMesh g = generate_cell({}, graded_in_the_east(field), {{128, 0}, {256, 128}}, 30, report);
  EXPECT_EQ(on_line_x(g, 128).size(), 2u);
}

// A pond with a notch in its shore about a sample of the terrain, and a brook four metres lower beside it. Where the
// shore is simplified the pond covers land within the brook's influence.
TEST(Ground, PondsAreLevelBesideABrookHoweverTheirShoresAreSimplified) {
  constexpr double kLevel_m = 10;
  LandCoverPolygon pond{{{OsmType::kWay, 1}, 0}, LandCoverClass::kLake, 800, {}};
  pond.rings = {{{50, 63.25}, {58, 63.25}, {64, 64.25}, {70, 63.25}, {78, 63.25}, {78, 90}, {50, 90}}};
  pond.level_m = kLevel_m;
  roads::Strip brook{{{OsmType::kWay, 2}, 0}, {{0, 60}, {128, 60}}, LandCoverClass::kRiver, 1, 1};
  brook.profile = {{0, 6, 0}, {128, 6, 0}};
  Heightfield field{{-64, -64}, {64, 64}, 5, 5, std::vector<std::int32_t>(25, 640), 0};
  field.heights[6] += 8;
  const std::vector<LandCoverPolygon> surfaces = {pond};
  const GradedTerrain graded =
      grade_terrain(std::move(field), {{}, std::vector{brook}, surfaces, kGeneratedCell.widened(kGrading_m)});
  for (const double tolerance_m : {0.1, 2.5}) {
    Report report;
    const GroundMesh g = generate_cell(surfaces, graded, kGeneratedCell, tolerance_m, report);
    EXPECT_GT(std::ranges::count(g.face_cover, 0u), 0);
    for (std::size_t f = 0; f < g.first_vertical; ++f) {
      if (g.face_cover[f] != 0) continue;
      for (const std::uint32_t v : g.mesh.triangles[f]) EXPECT_EQ(g.mesh.positions[v].z, kLevel_m) << tolerance_m;
    }
  }
}

TEST(Ground, FlatAndEmptyIsTwoTriangles) {
  Report report;
  const Heightfield flat{{-64, -64}, {64, 64}, 5, 5, std::vector<std::int32_t>(25, 640), 0};
  const GroundMesh g = generate_cell({}, GradedTerrain(Heightfield(flat)), kGeneratedCell, 0.02, report);
  EXPECT_EQ(g.mesh.triangles.size(), 2u);
  EXPECT_LE(g.error_m, kQuantum_m / 2);
}

}  // namespace
}  // namespace citykiln::ground
