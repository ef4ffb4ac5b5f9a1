#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include "compiler/bake/view/view_levels.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/snap.h"
#include "compiler/pipeline.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"
#include "compiler/source/read_raster.h"
#include "tests/test_files.h"

namespace citykiln {
namespace {

Result<CompileResult> compiled_village() {
  CompileSpec spec;
  spec.map_path = real_data("andorra/cut-canillo-village.osm.pbf");
  Result<source::RasterSpec> raster = source::parse_raster_spec(real_data("andorra/N42E001.hgt").string());
  if (!raster) return raster.error();
  spec.rasters.push_back(std::move(*raster));
  return compile(spec, [](std::string_view, double) {});
}

// A cell for the eye, and what it is measured against.
struct Seen {
  bake::CellLevel level;
  ground::GroundMesh mesh;
  std::optional<ground::Reference> reference;  // none without grading
  std::vector<ground::FaceHeight> heights;     // one a surface
};

void see_zone(const scene::Scene& scene, const scene::Chunk& chunk, const bake::ViewZone& zone,
              std::vector<Seen>& all) {
  const ground::GradedTerrain graded = scene::graded_terrain_of(scene.header, chunk, zone.roads_m);
  const scene::LandCover cover = scene::land_cover_of(scene.header, chunk, zone.roads_m);
  std::vector<ground::FaceHeight> heights;
  for (const ground::LandCoverPolygon& surface : cover.surfaces) heights.push_back(ground::face_height_of(surface));
  Report ignored;
  std::vector<ground::GroundMesh> meshes = bake::generate_cells(graded, cover.surfaces, zone.cells, 0, ignored);
  for (std::size_t c = 0; c < meshes.size(); ++c) {
    Seen& seen = all.emplace_back(Seen{zone.cells[c], std::move(meshes[c]), {}, heights});
    if (ground::has_grading(graded, seen.level.cell))
      seen.reference = ground::reference_of_cell(cover.surfaces, graded, seen.level.cell);
  }
}

std::vector<Seen> seen_village(const scene::Scene& scene, const bake::ViewLevels& levels) {
  std::vector<Seen> all;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const bake::ViewZone& zone : bake::zones_of(levels, scene::box_of(scene.header, chunk.tile)))
      see_zone(scene, chunk, zone, all);
  return all;
}

// Fifty metres above the middle of the village.
bake::View view_of(const scene::Scene& scene) {
  const Vec2 middle = scene.header.extent.centre();
  double ground_m = 0;
  for (const scene::Chunk& chunk : scene.chunks)
    if (scene::box_of(scene.header, chunk.tile).contains(middle)) ground_m = map::height_m_at(chunk.heights, middle);
  return {at_height(middle, ground_m + 50), 869};
}

// A random place of a face, pixel by pixel off its layer.
double pixels_off(const Seen& seen, const bake::View& view, std::size_t face, Vec2 dice) {
  const Triangle& t = seen.mesh.mesh.triangles[face];
  const std::vector<Vec3>& at = seen.mesh.mesh.positions;
  const double u = std::sqrt(dice.x), v = dice.y;
  const Vec3 p = at[t[0]] * (1 - u) + at[t[1]] * (u * (1 - v)) + at[t[2]] * (u * v);
  const std::uint32_t surface = seen.mesh.face_cover[face];
  const ground::FaceHeight height = surface == ground::kNoLandCover ? ground::FaceHeight{} : seen.heights[surface];
  if (height.level_m) return 0;
  const double off_m = std::abs(p.z - ground::height_m_at(*seen.reference, in_plan(p), height.layer));
  const double away_m = length(p - view.eye);
  // as fine as it gets
  if (seen.level.tolerance_m == view.finest_m && off_m <= view.finest_m) return 0;
  return off_m / away_m * view.focal_px;
}

class ViewReal : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(real_data("andorra/cut-canillo-village.osm.pbf"))) GTEST_SKIP() << "absent";
    Result<CompileResult> compiled = compiled_village();
    ASSERT_TRUE(compiled);
    scene = std::move(compiled->scene);
    view = view_of(scene);
    seen = seen_village(scene, bake::levels_for(scene, view));
  }
  scene::Scene scene;
  bake::View view;
  std::vector<Seen> seen;
};

using Edge = std::pair<Vec3, Vec3>;

// The edges of upward faces that lie in the line x = at (y = at), lower end first.
std::vector<Edge> edges_on_line(const ground::GroundMesh& ground, double Vec3::*across, double at) {
  std::vector<Edge> edges;
  for (std::uint32_t f = 0; f < ground.first_vertical; ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = ground.mesh.positions[ground.mesh.triangles[f][i]],
                 b = ground.mesh.positions[ground.mesh.triangles[f][(i + 1) % 3]];
      // edges of some grid steps may run where a border was snapped to the cell's own
      const bool is_long = distance(in_plan(a), in_plan(b)) > 4 * kQuantum_m;
      if (a.*across == at && b.*across == at && is_long) edges.push_back(a < b ? Edge{a, b} : Edge{b, a});
    }
  std::ranges::sort(edges);
  return edges;
}

TEST_F(ViewReal, RandomPlacesAreWithinTheRequestedPixelError) {
  const RandomSequence draw(7, StableId{8}, "places");
  std::uint32_t dice = 0;
  std::map<double, int> places;
  for (const Seen& s : seen) {
    // where a further vertex could not mend it the cell says so
    if (!s.reference || length(Vec2{s.mesh.error_m, s.mesh.border_error_m}) > s.level.tolerance_m) continue;
    for (int i = 0; i < 300; ++i) {
      const auto face = static_cast<std::size_t>(draw.unit(dice++) * s.mesh.first_vertical);
      const Vec2 at{draw.unit(dice), draw.unit(dice + 1)};
      dice += 2;
      EXPECT_LE(pixels_off(s, view, face, at), view.pixel_error + 1e-6);
      ++places[s.level.tolerance_m];
    }
  }
  EXPECT_GE(places.size(), 5u) << "too few levels to tell";
}

bool see_roads_alike(const Seen& a, const Seen& b) {
  return has_detail(Detail::kRoadSurfaces, a.level.tolerance_m) ==
         has_detail(Detail::kRoadSurfaces, b.level.tolerance_m);
}

TEST_F(ViewReal, CellsOfAllLevelsShareTheirEdges) {
  int sides = 0, unequal = 0;
  const auto expect_equal = [&](const Seen& a, const Seen& b, double Vec3::*across, double at) {
    if (!see_roads_alike(a, b)) return;
    ++sides, unequal += a.level.tolerance_m != b.level.tolerance_m ? 1 : 0;
    EXPECT_EQ(edges_on_line(a.mesh, across, at), edges_on_line(b.mesh, across, at))
        << at << ": " << a.level.tolerance_m << " m beside " << b.level.tolerance_m;
  };
  for (const Seen& here : seen)
    for (const Seen& there : seen) {
      const Box2 &a = here.level.cell, &b = there.level.cell;
      if (a.max.x == b.min.x && a.min.y == b.min.y) expect_equal(here, there, &Vec3::x, a.max.x);
      if (a.max.y == b.min.y && a.min.x == b.min.x) expect_equal(here, there, &Vec3::y, a.max.y);
    }
  EXPECT_GE(unequal, 100) << "of " << sides;
}

}  // namespace
}  // namespace citykiln
