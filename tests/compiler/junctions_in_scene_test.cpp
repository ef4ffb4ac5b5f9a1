#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "compiler/bake/ground/ground_cells.h"
#include "compiler/pipeline.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"
#include "tests/compiler/roads/junctions/junction_claims.h"
#include "tests/test_files.h"

namespace citykiln {
namespace {

Result<CompileResult> compiled(const std::filesystem::path& map, int threads) {
  CompileSpec spec;
  spec.map_path = map.string();
  spec.threads = threads;
  return compile(spec, [](std::string_view, double) {});
}

std::vector<std::string> small_cases() {
  std::vector<std::string> names;
  if (!std::filesystem::exists(real_data("junctions"))) return {"junctions/absent.osm"};
  for (const auto& entry : std::filesystem::directory_iterator(real_data("junctions")))
    if (entry.path().extension() == ".osm") names.push_back("junctions/" + entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
  std::string name = std::filesystem::path(info.param).stem().stem().string();
  std::ranges::replace_if(
      name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

class JunctionsInSceneReal : public testing::TestWithParam<std::string> {};

TEST_P(JunctionsInSceneReal, AreTheSameWhenCompiledAgain) {
  if (!std::filesystem::exists(real_data(GetParam()))) GTEST_SKIP() << "absent: " << GetParam();
  const auto once = compiled(real_data(GetParam()), 1), again = compiled(real_data(GetParam()), 2);
  ASSERT_TRUE(once && again);
  EXPECT_TRUE(once->scene == again->scene);
}

// All triangles that are one surface class's, of all cells of all tiles.
std::map<map::LandCoverClass, std::vector<Ring>> ground_by_class(const scene::Scene& scene) {
  // so fine that roads come in pieces
  constexpr double kTolerance_m = 0.1;
  std::map<map::LandCoverClass, std::vector<Ring>> faces;
  Report ignored;
  for (const scene::Chunk& chunk : scene.chunks) {
    const scene::LandCover cover = scene::land_cover_of(scene.header, chunk, kTolerance_m);
    const Box2 tile = scene::box_of(scene.header, chunk.tile);
    const ground::GradedTerrain graded = scene::graded_terrain_of(scene.header, chunk, kTolerance_m);
    for (const ground::GroundMesh& cell : bake::generate_cells(graded, cover.surfaces, tile, kTolerance_m, 0, ignored))
      for (std::size_t f = 0; f < cell.first_vertical; ++f) {
        if (cell.face_cover[f] == ground::kNoLandCover) continue;
        Ring ring;
        for (const std::uint32_t v : cell.mesh.triangles[f]) ring.push_back(in_plan(cell.mesh.positions[v]));
        faces[cover.surfaces[cell.face_cover[f]].surface].push_back(std::move(ring));
      }
  }
  return faces;
}

roads::Shape united(std::span<const Ring> rings) {
  std::vector<GEOSGeometry*> shapes;
  for (const Ring& ring : rings) shapes.push_back(roads::shape({ring, {}}).release());
  const roads::Shape all(
      GEOSGeom_createCollection(GEOS_MULTIPOLYGON, shapes.data(), static_cast<unsigned>(shapes.size())));
  return roads::Shape(GEOSUnaryUnion(all.get()));
}

bool is_of_street(map::LandCoverClass surface) {
  const map::LandCoverGroup group = map::values_of(surface).group;
  return group == map::LandCoverGroup::kRoad || group == map::LandCoverGroup::kPath ||
         surface == map::LandCoverClass::kPavement;
}

TEST_P(JunctionsInSceneReal, RoadSurfacesOfTheGroundShareNoArea) {
  if (!std::filesystem::exists(real_data(GetParam()))) GTEST_SKIP() << "absent: " << GetParam();
  const roads::Geos geos;
  const auto compiled_case = compiled(real_data(GetParam()), 0);
  ASSERT_TRUE(compiled_case);
  double sum = 0;
  std::vector<Ring> all;
  for (const auto& [surface, rings] : ground_by_class(compiled_case->scene)) {
    if (!is_of_street(surface)) continue;
    double faces = 0;
    for (const Ring& ring : rings) faces += signed_area_m2(ring);
    EXPECT_NEAR(area_of(united(rings)), faces, 0.01) << map::values_of(surface).name;
    sum += faces;
    all.insert(all.end(), rings.begin(), rings.end());
  }
  EXPECT_GT(sum, 0);
  EXPECT_NEAR(area_of(united(all)), sum, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Cases, JunctionsInSceneReal, testing::ValuesIn(small_cases()), name_of);

class JunctionsOfTilesReal : public testing::TestWithParam<std::string> {};

// Well inside, where a tile's roads are all that matters: idempotence, and that nothing farther is asked for.
TEST_P(JunctionsOfTilesReal, AreDerivedFromTheTilesRoads) {
  if (!std::filesystem::exists(real_data(GetParam()))) GTEST_SKIP() << "absent: " << GetParam();
  const auto whole = compiled(real_data(GetParam()), 0);
  ASSERT_TRUE(whole);
  std::size_t compared = 0;
  for (const scene::Chunk& chunk : whole->scene.chunks) {
    const Box2 inside = scene::box_of(whole->scene.header, chunk.tile).widened(-8 * roads::kJunctionRadius_m);
    const auto within = [&](std::vector<roads::Junction> junctions) {
      std::erase_if(junctions, [&](const roads::Junction& j) { return !inside.contains(j.nodes.front()); });
      return junctions;
    };
    Report ignored;
    const auto planned = within(chunk.junctions), again = within(roads::plan_junctions(chunk.roads, ignored));
    EXPECT_TRUE(planned == again) << chunk.tile.x << ' ' << chunk.tile.y;
    compared += planned.size();
  }
  EXPECT_GT(compared, 100u);
}

INSTANTIATE_TEST_SUITE_P(Extracts, JunctionsOfTilesReal,
                         testing::Values("helsinki/Helsinki.osm.pbf", "monaco/monaco-2023.osm.pbf",
                                         "chicago-loop/chicago_loop.osm.pbf"),
                         name_of);

}  // namespace
}  // namespace citykiln
