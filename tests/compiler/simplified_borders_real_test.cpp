#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "compiler/bake/ground/ground_cells.h"
#include "compiler/ground/cover/merge_slivers.h"
#include "compiler/pipeline.h"
#include "compiler/scene/land_cover.h"
#include "tests/compiler/ground/cover/border_claims.h"
#include "tests/test_files.h"

namespace citykiln {
namespace {

using ground::Border;

struct CellBorders {
  Box2 cell;
  std::vector<Border> borders;
};

// The borders of all cells of an extract, with all pieces of its roads.
std::vector<CellBorders> borders_of_cells(const char* extract) {
  CompileSpec spec;
  spec.map_path = real_data(extract);
  const auto compiled = compile(spec, [](std::string_view, double) {});
  EXPECT_TRUE(compiled);
  if (!compiled) return {};
  const scene::Scene& scene = compiled->scene;
  constexpr double kTolerance_m = 0.1;
  std::vector<CellBorders> all;
  for (const scene::Chunk& chunk : scene.chunks) {
    const scene::LandCover cover = scene::land_cover_of(scene.header, chunk, kTolerance_m);
    const Box2 tile = scene::box_of(scene.header, chunk.tile);
    for (const Box2& cell : bake::cells_of(tile)) all.push_back({cell, ground::borders_of(cover.surfaces, cell)});
  }
  return all;
}

struct Stopwatch {
  double seconds = 0;
  std::chrono::steady_clock::time_point started{};
  void start() { started = std::chrono::steady_clock::now(); }
  void stop() { seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count(); }
};

class SimplifiedBordersReal : public testing::TestWithParam<const char*> {};

TEST_P(SimplifiedBordersReal, KeepEveryGuarantee) {
  if (!std::filesystem::exists(real_data(GetParam()))) GTEST_SKIP() << "absent: " << GetParam();
  const std::vector<CellBorders> cells = borders_of_cells(GetParam());
  ASSERT_FALSE(cells.empty());
  for (const double tolerance_m : {0.25, 1.0, 8.0}) {
    std::size_t before = 0, after = 0;
    Stopwatch watch;
    for (const CellBorders& cell : cells) {
      watch.start();
      const auto now = ground::simplify_borders(cell.borders, tolerance_m, [](GridPoint) { return false; });
      watch.stop();
      ground::expect_simplified(cell.borders, now, tolerance_m, cell.cell);
      before += cell.borders.size(), after += now.borders.size();
    }
    EXPECT_LT(after, before);
    std::printf("%6.2f m: %zu cells, %zu borders to %zu in %.2f s\n", tolerance_m, cells.size(), before, after,
                watch.seconds);
  }
}

TEST_P(SimplifiedBordersReal, KeepEveryGuaranteeAfterMergingSlivers) {
  if (!std::filesystem::exists(real_data(GetParam()))) GTEST_SKIP() << "absent: " << GetParam();
  const std::vector<CellBorders> cells = borders_of_cells(GetParam());
  ASSERT_FALSE(cells.empty());
  for (const double tolerance_m : {0.25, 1.0, 8.0}) {
    std::size_t faces = 0, after = 0;
    double area_m2 = 0;
    Stopwatch watch;
    for (const CellBorders& cell : cells) {
      watch.start();
      const auto thick =
          ground::merge_slivers(cell.borders, tolerance_m, [](const ground::CoverFace&) { return true; });
      const auto now = ground::simplify_borders(thick.borders, tolerance_m, [](GridPoint) { return false; });
      watch.stop();
      EXPECT_LE(thick.error_m, tolerance_m);
      ground::expect_simplified(thick.borders, now, tolerance_m, cell.cell);
      faces += thick.faces, area_m2 += thick.area_m2, after += now.borders.size();
    }
    std::printf("%6.2f m: %zu faces of %.0f m2 yield, %zu borders are left, in %.2f s\n", tolerance_m, faces, area_m2,
                after, watch.seconds);
  }
}

INSTANTIATE_TEST_SUITE_P(Extracts, SimplifiedBordersReal,
                         testing::Values("berlin/berlin-neukolln.osm", "andorra/cut-andorra-la-vella.osm.pbf",
                                         "monaco/monaco-2023.osm.pbf"));

}  // namespace
}  // namespace citykiln
