#include "compiler/verify/check_tile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "compiler/bake/bake.h"
#include "compiler/bake/ground_cells.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/geometry/snap.h"
#include "compiler/ground/generate.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"
#include "compiler/verify/ground_index.h"
#include "compiler/verify/measure_footing.h"
#include "compiler/verify/measure_lakes.h"
#include "compiler/verify/measure_road_faces.h"
#include "compiler/verify/measure_trunks.h"
#include "exporters/file.h"
#include "exporters/gltf/encode_tile.h"

namespace citykiln::verify {
namespace {

// A million places a tile.
constexpr int kSamplesASide = 1024;

// Every tile is one thread's.
constexpr int kOneThread = 1;

// What the ground of some levels is to be: how it is carved, what covers it, and each cell as exact as it gets. Cells
// refer to the graded terrain: it stays where it is.
struct Truth {
  Box2 box;
  bool is_plain;  // without Detail::kRoadSurfaces
  ground::GradedTerrain graded;
  std::vector<ground::LandCoverPolygon> surfaces;
  std::vector<ground::Reference> cells;

  const ground::Reference& at(Vec2 p) const {
    const auto rows = static_cast<std::size_t>(box.height() / map::kCell_m);
    const auto column = static_cast<std::size_t>((p.x - box.min.x) / map::kCell_m);
    const auto row = static_cast<std::size_t>((p.y - box.min.y) / map::kCell_m);
    return cells[std::min(column * rows + row, cells.size() - 1)];
  }
};

// The levels of standing water by the name of its faces.
using WaterLevels = std::multimap<OsmId, double>;

WaterLevels water_levels_of(const scene::Chunk& chunk) {
  WaterLevels levels;
  for (const ground::LandCoverPolygon& surface : chunk.surfaces)
    if (surface.level_m) levels.emplace(surface.id.osm, *surface.level_m);
  return levels;
}

// What all levels of a tile are held against.
struct TileUnderCheck {
  const Subject& subject;
  const scene::Chunk& chunk;
  Box2 box;
  WaterLevels waters;
  std::unique_ptr<Truth> truth;  // of the level before
  CheckedTile checked;

  Findings& findings() { return checked.findings; }
};

bool is_plain(double tolerance_m) { return !has_detail(Detail::kRoadSurfaces, tolerance_m); }

// That of the level before where it is the same.
const Truth& truth_at(TileUnderCheck& tile, double tolerance_m) {
  const scene::Header& header = tile.subject.scene.header;
  std::vector<ground::LandCoverPolygon> surfaces = scene::land_cover_of(header, tile.chunk, tolerance_m).surfaces;
  const Truth* before = tile.truth.get();
  if (before && before->is_plain == is_plain(tolerance_m) && before->surfaces == surfaces) return *before;
  tile.truth = std::make_unique<Truth>(Truth{tile.box,
                                             is_plain(tolerance_m),
                                             scene::graded_terrain_of(header, tile.chunk, tolerance_m),
                                             std::move(surfaces),
                                             {}});
  tile.truth->cells = bake::reference_cells(tile.truth->graded, tile.truth->surfaces, tile.box, kOneThread);
  const Truth& truth = *tile.truth;
  const auto at = [&](Vec2 p) -> const ground::Reference& { return truth.at(p); };
  tile.findings().following = worse(tile.findings().following,
                                    measure_following(truth.graded, truth.surfaces, at, tile.box, kSamplesASide / 2));
  return truth;
}

// The cells of one tile, put together again: their areas must add up.
void check_area(TileUnderCheck& tile, std::span<const ground::GroundMesh> cells, const std::string& name) {
  double ground_m2 = 0;
  for (const ground::GroundMesh& cell : cells) {
    for (const Triangle& t : cell.mesh.triangles) {
      const auto corner = [&](std::size_t i) { return in_plan(cell.mesh.positions[t[i]]); };
      ground_m2 += 0.5 * cross(corner(1) - corner(0), corner(2) - corner(0));
    }
  }
  const double tile_m2 = tile.box.width() * tile.box.height();
  tile.findings().area.test(std::abs(ground_m2 - tile_m2) <= 1e-9 * tile_m2,
                            fmt::format("{}: {} m² instead of {}", name, ground_m2, tile_m2));
}

// Standing water lies at one of its levels, all else on any layer.
double off_m(const TileUnderCheck& tile, const Truth& truth, Vec2 p, double z_m, OsmId feature) {
  double least_m = std::numeric_limits<double>::infinity();
  const auto keep = [&](double height_m) { least_m = std::min(least_m, std::abs(z_m - height_m)); };
  const auto [first, last] = tile.waters.equal_range(feature);
  for (auto level = first; level != last; ++level) keep(level->second);
  if (first != last) return least_m;
  for (std::size_t layer = 0; layer < static_cast<std::size_t>(ground::HeightLayer::kCount); ++layer)
    keep(ground::height_m_at(truth.at(p), p, static_cast<ground::HeightLayer>(layer)));
  return least_m;
}

void check_ground(TileUnderCheck& tile, const bake::BakedTile& level, const std::string& name) {
  const Truth& truth = truth_at(tile, level.tolerance_m);
  const GroundSamples samples = sample_ground(
      level, tile.subject.standing,
      [&](Vec2 p, double z_m, OsmId feature) { return off_m(tile, truth, p, z_m, feature); }, tile.box, kSamplesASide);
  // the baked ground is snapped to the grid, half a quantum to either side
  tile.findings().height.test_all(samples.count, samples.error_m <= level.error_m + kQuantum_m,
                                  fmt::format("{}: {} m where {} m is stated, at {},{}", name, samples.error_m,
                                              level.error_m, samples.at.x, samples.at.y));
  tile.findings().height.test_all(
      0, samples.uncovered == 0,
      fmt::format("{}: {} places without ground, at {},{}", name, samples.uncovered, samples.hole.x, samples.hole.y));
}

RoadFaces road_faces_of(const scene::Chunk& chunk, const Box2& box, double tolerance_m, const GroundIndex& ground) {
  return measure_road_faces(chunk, box, !is_plain(tolerance_m), [&](const roads::Road& road, Vec2 p) {
    const std::vector<GroundPlace> places = ground_at(ground, p);
    const bool is_its_own = !places.empty() && places.front().feature == road.id.osm;
    return is_its_own ? std::vector{places.front().z_m} : std::vector<double>{};
  });
}

// What stands and lies on the ground of one file, by its own triangles.
void check_heights(TileUnderCheck& tile, const bake::BakedTile& level, const std::string& name) {
  const GroundIndex ground = index_ground(level, tile.subject.standing);
  const RoadFaces roads = road_faces_of(tile.chunk, tile.box, level.tolerance_m, ground);
  tile.findings().roads.test_all(roads.places, roads.largest_gap_m <= level.error_m + kQuantum_m,
                                 fmt::format("{}: {} m at {}, {} of {}", name, roads.largest_gap_m, roads.at.x,
                                             roads.at.y, to_string(roads.worst)));
  const Lakes lakes = measure_lakes(tile.chunk, ground);
  tile.findings().lakes.test_all(lakes.waters, lakes.not_level == 0,
                                 fmt::format("{}: {} by {} m", name, to_string(lakes.worst), lakes.largest_m));
  const double allowed_m = std::max(kNoGap_m, level.error_m);
  const Footing footing = measure_footing(tile.chunk, tile.box, allowed_m, level, ground);
  tile.findings().footing.test_all(footing.corners, footing.floating == 0,
                                   fmt::format("{}: {} buildings, {} by {} m", name, footing.floating,
                                               to_string(footing.worst), footing.largest_gap_m));
}

void check_trunks(TileUnderCheck& tile, const bake::BakedTile& level, const std::string& name) {
  const std::vector<ground::LandCoverPolygon> surfaces = scene::coarse_land_cover(tile.chunk);
  const Trunks trunks = measure_trunks(level, ground::index_land_cover(surfaces, tile.box.widened(scene::kHalo_m)));
  tile.findings().trunks.test_all(trunks.trees, trunks.misplaced == 0,
                                  fmt::format("{}: {} of {} trunks, {} at {:.2f}, {:.2f}", name, trunks.misplaced,
                                              trunks.trees, to_string(trunks.worst), trunks.at.x, trunks.at.y));
}

// Whether a file's bytes are what the recipes bake.
bool is_baked(const Subject& subject, bake::PreparedTile& prepared, std::size_t level,
              std::span<const std::byte> bytes) {
  Report ignored;
  const RunRecord& record = subject.record;
  const bake::BakedTile baked = bake::bake_prepared(prepared, level, kOneThread, ignored);
  const exporters::EncodedTile encoded =
      exporters::encode_tile(baked, subject.scene.header, instancing_of(record.instances_as_nodes),
                             compression_of(record.compress), kOneThread);
  return std::ranges::equal(encoded.glb, bytes);
}

Result<Done> check_level(TileUnderCheck& tile, bake::PreparedTile& prepared, std::size_t level,
                         const WrittenFile& file) {
  const Subject& subject = tile.subject;
  const std::string path = subject.folder + "/" + file.name;
  const Result<std::vector<std::byte>> bytes = exporters::read_file(path);
  if (!bytes) return bytes.error();
  const Result<bake::BakedTile> written = exporters::decode_glb(*bytes, path);
  if (!written) return written.error();
  check_area(tile, bake::ground_of(prepared, level), file.name);
  tile.findings().forms.test(is_baked(subject, prepared, level, *bytes), file.name);
  check_ground(tile, *written, file.name);
  check_heights(tile, *written, file.name);
  check_trunks(tile, *written, file.name);
  const auto edges_at_x = [&](double x) { return border_edges_along_x(*written, subject.standing, x); };
  const auto edges_at_y = [&](double y) { return border_edges_along_y(*written, subject.standing, y); };
  tile.checked.borders.push_back(
      {edges_at_x(tile.box.min.x), edges_at_x(tile.box.max.x), edges_at_y(tile.box.min.y), edges_at_y(tile.box.max.y)});
  return Done{};
}

}  // namespace

Result<CheckedTile> check_tile(const Subject& subject, std::span<const WrittenTile> levels) {
  const scene::Scene& scene = subject.scene;
  const auto chunk = std::ranges::find(scene.chunks, levels.front().tile, &scene::Chunk::tile);
  if (chunk == scene.chunks.end())
    return Error{subject.folder + "/" + levels.front().file.name, "is a tile that the manifest does not have"};
  std::vector<double> ladder_m;
  for (const WrittenTile& level : levels) ladder_m.push_back(level.tolerance_m);
  const auto prepared = bake::prepare(scene.header, *chunk, ladder_m, kOneThread, subject.prototypes);
  TileUnderCheck tile{subject, *chunk, scene::box_of(scene.header, chunk->tile), water_levels_of(*chunk), nullptr, {}};
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (const Result<Done> done = check_level(tile, *prepared, i, levels[i].file); !done) return done.error();
  return std::move(tile.checked);
}

}  // namespace citykiln::verify
