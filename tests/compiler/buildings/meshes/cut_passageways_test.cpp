#include "compiler/buildings/meshes/cut_passageways.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/buildings/styles/rulebook.h"
#include "tests/compiler/buildings/made_footprint.h"

namespace citykiln::buildings {
namespace {

// 40 m by 12 m, from 0 to 15 m above the ground at 100 m.
Building block() {
  Building b;
  b.id = {{OsmType::kWay, 7}, 0};
  b.footprint = {{{0, 0}, {40, 0}, {40, 12}, {0, 12}}, {}};
  b.bottom_m = 97, b.floor_m = 100, b.top_m = 115;
  b.wall = materials::Material::kPlaster, b.roof = materials::Material::kFlatRoof;
  b.levels = 5;
  b.style = Style::kCourtyardBlock;
  b.facade_edges = {{true, 0, 0}, {false, 0, 0}, {true, 0, 0}, {false, 0, 0}};
  return b;
}

Passageway passage(Polyline axis, double width_m, double top_m) {
  return {{{OsmType::kWay, 9}, 0}, std::move(axis), width_m / 2, width_m / 2, top_m};
}

// The part of a polygon on the positive side of a linear function.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, auto value_at) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double va = value_at(a), vb = value_at(b);
    if (va >= 0) kept.push_back(a);
    if ((va > 0) != (vb > 0) && va != vb) kept.push_back(a + (b - a) * (va / (va - vb)));
  }
  return kept;
}

// True if a triangle meets the box of a width and height that is moved along a segment. 2 mm of rounding are allowed.
bool meets(std::vector<Vec3> triangle, Vec2 from, Vec2 to, double width_m, double from_z_m, double to_z_m) {
  constexpr double kRounding_m = 0.002;
  const Vec2 along = unit(to - from), left = left_of(along);
  const double length_m = distance(from, to);
  triangle = clipped(triangle, [&](Vec3 p) { return dot(along, in_plan(p) - from) - kRounding_m; });
  triangle = clipped(triangle, [&](Vec3 p) { return length_m - dot(along, in_plan(p) - from) - kRounding_m; });
  triangle = clipped(triangle, [&](Vec3 p) { return width_m / 2 - dot(left, in_plan(p) - from) - kRounding_m; });
  triangle = clipped(triangle, [&](Vec3 p) { return width_m / 2 + dot(left, in_plan(p) - from) - kRounding_m; });
  triangle = clipped(triangle, [&](Vec3 p) { return p.z - from_z_m - kRounding_m; });
  triangle = clipped(triangle, [&](Vec3 p) { return to_z_m - p.z - kRounding_m; });
  return !triangle.empty();
}

template <typename Visit>
void each_triangle(const GeneratedBuilding& generated, Visit visit) {
  const auto walk = [&](const materials::MaterialMesh& mesh) {
    for (const Triangle& t : mesh.mesh.triangles)
      visit({mesh.mesh.positions[t[0]], mesh.mesh.positions[t[1]], mesh.mesh.positions[t[2]]});
  };
  for (const auto& mesh : generated.meshes) walk(mesh);
  for (const TexturedFace& face : generated.textured_faces) walk(face.mesh);
}

int count_in_box(const GeneratedBuilding& generated, Vec2 from, Vec2 to, double width_m, double from_z_m,
                 double to_z_m) {
  int count = 0;
  each_triangle(generated, [&](const std::vector<Vec3>& triangle) {
    count += meets(triangle, from, to, width_m, from_z_m, to_z_m);
  });
  return count;
}

const std::vector<double> kLevels_m = {0.02, 0.1, 0.5, 2.5};

std::vector<GeneratedBuilding> at_all_levels(const Building& building, const Rulebook& rules) {
  std::vector<Report> reports(kLevels_m.size());
  return generate(building, rules, {1}, kLevels_m, reports);
}

void expect_open(const Building& building, Vec2 from, Vec2 to, double width_m, double height_m) {
  for (const Rulebook& rules : {Rulebook{}, parse_rulebook(shipped_rules())}) {
    const auto levels = at_all_levels(building, rules);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      EXPECT_FALSE(levels[i].meshes.empty());
      EXPECT_EQ(count_in_box(levels[i], from, to, width_m, 100, 100 + height_m), 0) << kLevels_m[i];
    }
  }
}

TEST(CutPassageways, ABoxMovedAlongTheWayMeetsNoTriangleAtAnyLevel) {
  Building building = block();
  building.passageways = {passage({{20, -1}, {20, 13}}, 4.125, 104)};
  expect_open(building, {20, -1}, {20, 13}, 4, 3.5);
}

TEST(CutPassageways, WithoutOneTheBoxMeetsTheWalls) {
  for (const GeneratedBuilding& level : at_all_levels(block(), {}))
    EXPECT_GT(count_in_box(level, {20, -1}, {20, 13}, 4, 100, 103.5), 0);
}

TEST(CutPassageways, AnObliqueOneIsOpen) {
  Building building = block();
  building.passageways = {passage({{6, -4}, {26, 16}}, 4.125, 104)};
  expect_open(building, {8, -2}, {24, 14}, 4, 3.5);
}

TEST(CutPassageways, ABentOneIsOpen) {
  Building building = block();
  building.passageways = {passage({{10, -2}, {14, 6}, {30, 14}}, 3.125, 104)};
  expect_open(building, {10, -2}, {14, 6}, 3, 3.5);
  expect_open(building, {14, 6}, {30, 14}, 3, 3.5);
}

TEST(CutPassageways, TwoThatCrossAreOpenUpToTheirOwnCeilings) {
  Building building = block();
  building.passageways = {passage({{20, -1}, {20, 13}}, 4.125, 104), passage({{-1, 6}, {41, 6}}, 2.125, 102.5)};
  expect_open(building, {20, -1}, {20, 13}, 4, 3.5);
  expect_open(building, {-1, 6}, {41, 6}, 2, 2);
}

TEST(CutPassageways, AnArcadeHasPillarsBesideTheWayAndNoOuterWall) {
  Building building = block();
  building.passageways = {passage({{-1, 1.5}, {41, 1.5}}, 2.125, 103.5)};
  building.passageways[0].right_m = 2, building.passageways[0].pillars_right_m = 1.25;
  expect_open(building, {-1, 1.5}, {41, 1.5}, 2, 2);
  const int at_wall = count_in_box(at_all_levels(building, {})[0], {0.5, 0}, {39.5, 0}, 0.01, 101, 102);
  EXPECT_EQ(at_wall, 0);
  const int at_pillars = count_in_box(at_all_levels(building, {})[0], {-1, 0.25}, {41, 0.25}, 0.3, 101, 102);
  EXPECT_EQ(at_pillars, 10 * 4);
}

// The short last piece of the way bends to its open side, so a pillar beside it would stand on the long piece.
TEST(CutPassageways, APillarInsideABendOfTheWayIsLeftOut) {
  Building building = block();
  building.passageways = {passage({{-1, 3}, {20, 3}, {20, 1}}, 2.125, 103.5)};
  building.passageways[0].right_m = 4, building.passageways[0].pillars_right_m = 1.3125;
  expect_open(building, {-1, 3}, {20, 3}, 2, 2);
  expect_open(building, {20, 3}, {20, 1}, 2, 2);
}

TEST(CutPassageways, APillarInAWayThatCrossesTheArcadeIsLeftOut) {
  Building building = block();
  building.passageways = {passage({{-1, 1.5}, {41, 1.5}}, 2.125, 103.5), passage({{18, -1}, {18, 13}}, 4.125, 104)};
  building.passageways[0].right_m = 2, building.passageways[0].pillars_right_m = 1.25;
  expect_open(building, {18, -1}, {18, 13}, 4, 3.5);
}

TEST(CutPassageways, JambsAndCeilingCloseTheOpening) {
  Building building = block();
  building.passageways = {passage({{20, -1}, {20, 13}}, 4, 104)};
  double jambs_m2 = 0, ceiling_m2 = 0;
  each_triangle(at_all_levels(building, {})[0], [&](const std::vector<Vec3>& t) {
    const Vec3 twice = cross(t[1] - t[0], t[2] - t[0]);
    const auto is_all = [&](auto holds) { return std::ranges::all_of(t, holds); };
    if (is_all([](Vec3 p) { return p.z == 104; }) && twice.z < 0) ceiling_m2 -= twice.z / 2;
    if (is_all([](Vec3 p) { return p.x == 18; })) jambs_m2 += twice.x / 2;  // faces east
    if (is_all([](Vec3 p) { return p.x == 22; })) jambs_m2 -= twice.x / 2;  // faces west
  });
  EXPECT_NEAR(ceiling_m2, 4 * 12, 0.01);
  EXPECT_NEAR(jambs_m2, 2 * 12 * 7, 0.01);
}

TEST(CutPassageways, ABuildingWithoutOneStaysAsItIs) {
  const auto cut = [](const Building& building) {
    GeneratedBuilding generated = at_all_levels(building, {})[0];
    cut_passageways(building, {}, generated);
    return generated;
  };
  EXPECT_EQ(cut(block()).meshes.size(), at_all_levels(block(), {})[0].meshes.size());
}

}  // namespace
}  // namespace citykiln::buildings
