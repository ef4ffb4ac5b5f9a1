#include "compiler/verify/check_tile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/bake/bake.h"
#include "compiler/bake/baked_tile.h"
#include "compiler/bake/far/bend.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/geometry/snap.h"
#include "compiler/ground/mesh/reference.h"
#include "compiler/map/plane/cylinder.h"
#include "compiler/outputs/tile_lights.h"
#include "compiler/scene/land_cover.h"
#include "compiler/scene/shown_chunk.h"
#include "compiler/source/voids/codes_to_voids.h"
#include "compiler/verify/assumed/measure_assumed.h"
#include "compiler/verify/ground/ground_index.h"
#include "compiler/verify/ground/measure_hidden.h"
#include "compiler/verify/heights/measure_footing.h"
#include "compiler/verify/heights/measure_lakes.h"
#include "compiler/verify/heights/measure_road_faces.h"
#include "compiler/verify/heights/water_levels.h"
#include "compiler/verify/measure_ways.h"
#include "compiler/verify/prepare_tile.h"
#include "compiler/verify/standing/measure_blank_walls.h"
#include "compiler/verify/standing/measure_standing.h"
#include "compiler/verify/standing/measure_things.h"
#include "compiler/verify/standing/measure_trunks.h"
#include "compiler/verify/standing/measure_wires.h"
#include "compiler/wires/plan.h"
#include "exporters/file.h"
#include "exporters/gltf/write/encode_tile.h"

namespace citykiln::verify {
namespace {

constexpr double kLacking = std::numeric_limits<double>::infinity();

struct Compared {
  const map::Cylinder& cylinder;
  Vec3 plane_origin, bent_origin;

  double off_m(std::span<const bake::Float3> plane, std::span<const bake::Float3> bent) const {
    if (bent.size() < plane.size()) return kLacking;
    double farthest_m = 0;
    for (std::size_t i = 0; i < plane.size(); ++i) {
      const Vec3 own = plane_origin + bake::widened(plane[i]);
      const Vec3 back = map::flattened(cylinder, bent_origin + bake::widened(bent[i]), own.y);
      farthest_m = std::max(farthest_m, length(back - own));
    }
    return farthest_m;
  }
};

// Returns the largest distance between a vertex of the plane's tile and that of the bent one, mapped back to the plane
// by map::flattened(), which shares no code with the bending. Instances count by their place. Infinite if the bent
// tile lacks a primitive, a vertex or an instance. Vertices that bending adds come last and are not compared. O(n).
double off_cylinder_m(const map::Cylinder& cylinder, const bake::BakedTile& plane, const bake::BakedTile& bent) {
  if (bent.primitives.size() != plane.primitives.size() || bent.instanced.size() != plane.instanced.size())
    return kLacking;
  const Compared compared{cylinder, plane.origin, bent.origin};
  double farthest_m = 0;
  for (std::size_t i = 0; i < plane.primitives.size(); ++i)
    farthest_m = std::max(farthest_m, compared.off_m(plane.primitives[i].positions, bent.primitives[i].positions));
  for (std::size_t i = 0; i < plane.instanced.size(); ++i)
    farthest_m = std::max(farthest_m, compared.off_m(plane.instanced[i].translations, bent.instanced[i].translations));
  return farthest_m;
}

// A quarter of the largest number of samples of a file, since the graded terrain is the most expensive height. It is
// equal for all tiles, so that the share of places over the limit is a share of area.
constexpr int kReferenceSamplesASide = kMostSamplesASide / 2;

// A tolerance at which each road is one surface.
constexpr double kCoarsest_m = 100;

// Tiles are checked in parallel, each on one thread.
constexpr int kOneThread = 1;

// A tile, and the data that are kept from one level to the next.
struct TileUnderCheck {
  const LoadedRun& loaded;
  const scene::Chunk& chunk;
  Box2 box;
  WaterLevels waters;
  std::vector<ground::LandCoverPolygon> surfaces;  // for trunks, at all levels
  ground::LandCoverIndex cover;                    // of `surfaces`
  scene::LandCover with_plots;                     // and plots, on which cars stand
  ground::LandCoverIndex car_cover;
  bake::ExpectedGround expected;  // that of the previous level, then of this one
  CheckedTile checked;
  std::vector<bake::PlacedLamp> lights;  // of all levels
  std::vector<WayBox> way_boxes{};       // for openings, at all levels

  CheckResults& results() { return checked.results; }
};

// The number of faces of the references. Where a reference is the terrain, its grid squares count.
std::size_t faces_of(const bake::CellReferences& references) {
  std::size_t faces = 0;
  for (const auto& reference : references) {
    const map::Heightfield* terrain = reference->terrain;
    faces += reference->triangulation.faces().size();
    if (terrain != nullptr)
      faces += static_cast<std::size_t>(2 * reference->cell.width() * reference->cell.height() /
                                        (terrain->step_m.x * terrain->step_m.y));
  }
  return faces;
}

// Returns the reference of the cell at a place in the tile.
const ground::Reference& reference_at(const TileUnderCheck& tile, Vec2 p) {
  const auto rows = static_cast<std::size_t>(tile.box.height() / map::kCell_m);
  const auto column = static_cast<std::size_t>((p.x - tile.box.min.x) / map::kCell_m);
  const auto row = static_cast<std::size_t>((p.y - tile.box.min.y) / map::kCell_m);
  const bake::CellReferences& cells = tile.expected.references;
  return *cells[std::min(column * rows + row, cells.size() - 1)];
}

// Takes the expected ground of a level, and measures its references unless the previous level has the same.
void expect_ground(TileUnderCheck& tile, bake::ExpectedGround&& expected) {
  const bool is_measured =
      tile.expected.graded == expected.graded && tile.expected.cover->surfaces == expected.cover->surfaces;
  tile.expected = std::move(expected);
  if (is_measured) return;
  const auto at = [&](Vec2 p) -> const ground::Reference& { return reference_at(tile, p); };
  tile.results().reference_errors = combined(
      tile.results().reference_errors, measure_reference_errors(*tile.expected.graded, tile.expected.cover->surfaces,
                                                                at, tile.box, kReferenceSamplesASide));
}

// Compares the plan area of all ground cells with the area of the tile.
void check_area(TileUnderCheck& tile, std::span<const ground::GroundMesh> cells, const std::string& name) {
  double ground_m2 = 0;
  for (const ground::GroundMesh& cell : cells) {
    for (const Triangle& t : cell.mesh.triangles) {
      const auto corner = [&](std::size_t i) { return in_plan(cell.mesh.positions[t[i]]); };
      ground_m2 += 0.5 * cross(corner(1) - corner(0), corner(2) - corner(0));
    }
  }
  const double tile_m2 = tile.box.width() * tile.box.height();
  tile.results().area.test(std::abs(ground_m2 - tile_m2) <= 1e-9 * tile_m2,
                           fmt::format("{}: {} m² instead of {}", name, ground_m2, tile_m2));
}

// The deviation from the nearest layer of the graded terrain.
double off_layers_m(const TileUnderCheck& tile, Vec2 p, double z_m) {
  const ground::Reference& reference = reference_at(tile, p);
  double least_m = std::numeric_limits<double>::infinity();
  for (const double height_m : ground::heights_at(reference, ground::place_at(reference, p)))
    least_m = std::min(least_m, std::abs(z_m - height_m));
  return least_m;
}

// The deviation from the nearest level of a standing water, or from the nearest layer of the graded terrain for other
// features. For a water with running parts, both count outside its level parts, since shores are simplified.
double deviation_m(const TileUnderCheck& tile, Vec2 p, double z_m, OsmId feature) {
  const auto water = tile.waters.find(feature);
  if (water == tile.waters.end()) return off_layers_m(tile, p, z_m);
  const double off_m = off_level_m(water->second, z_m);
  return stands_at(water->second, p) ? off_m : std::min(off_m, off_layers_m(tile, p, z_m));
}

// True for places inside of the clip and not near its border, which a level moves by up to its error.
ExpectsGround expected_places(const TileUnderCheck& tile, double error_m) {
  const scene::Clip& clip = tile.loaded.scene.header.clip;
  if (clip.empty()) return {};
  constexpr double kDiagonal = 0.7071;
  const double far_m = error_m + kQuantum_m, near_m = kDiagonal * far_m;
  return [=, test = scene::ClipTest(clip, tile.box.widened(far_m + 1))](Vec2 p) {
    constexpr double kSigns[] = {-1, 0, 1};
    for (const double x : kSigns)
      for (const double y : kSigns)
        if (const double by_m = x != 0 && y != 0 ? near_m : far_m; !test.is_inside(p + Vec2{x, y} * by_m)) return false;
    return true;
  };
}

// Samples the ground of one file.
void check_ground(TileUnderCheck& tile, const bake::BakedTile& level, const GroundIndex& ground,
                  const std::string& name) {
  const GroundSamples samples = sample_ground(
      level, [&](Vec2 p, double z_m, OsmId feature) { return deviation_m(tile, p, z_m, feature); }, tile.box,
      samples_a_side(ground.faces.size() + faces_of(tile.expected.references)), expected_places(tile, level.error_m));
  // baked ground is snapped to the grid, by up to half a quantum
  tile.results().height.test_all(samples.count, samples.error_m <= level.error_m + kQuantum_m,
                                 {fmt::format("{}: {} m where {} m is stated, at {},{}", name, samples.error_m,
                                              level.error_m, samples.at.x, samples.at.y),
                                  samples.at,
                                  {},
                                  samples.error_m,
                                  name});
  if (!shows(tile.loaded.scene.header, scene::SceneLayer::kGround)) return;
  tile.results().height.test_all(
      0, samples.uncovered == 0,
      {fmt::format("{}: {} places without ground, at {},{}", name, samples.uncovered, samples.hole.x, samples.hole.y),
       samples.hole,
       {},
       static_cast<double>(samples.uncovered),
       name});
}

RoadFaces baked_road_faces(const scene::Chunk& chunk, const Box2& box, double tolerance_m, const GroundIndex& ground) {
  const bool has_kerbs = has_detail(Detail::kRoadSurfaces, tolerance_m);
  return measure_road_faces(chunk, box, has_kerbs, [&](const roads::Road& road, Vec2 p) {
    const std::vector<GroundHit> places = ground_at(ground, p);
    const bool is_its_own = !places.empty() && places.front().feature == road.id.osm;
    return is_its_own ? std::vector{places.front().z_m} : std::vector<double>{};
  });
}

// Measures roads, waters and buildings by the triangles of one file.
void check_heights(TileUnderCheck& tile, const bake::BakedTile& level, const GroundIndex& ground,
                   const std::string& name) {
  const RoadFaces roads = baked_road_faces(tile.chunk, tile.box, level.tolerance_m, ground);
  tile.results().roads.test_all(roads.places, roads.largest_gap_m <= level.error_m + kQuantum_m,
                                {fmt::format("{}: {} m at {}, {} of {}", name, roads.largest_gap_m, roads.at.x,
                                             roads.at.y, to_string(roads.worst)),
                                 roads.at,
                                 {roads.worst},
                                 roads.largest_gap_m,
                                 name});
  const Lakes lakes = measure_lakes(tile.chunk, ground);
  tile.results().lakes.test_all(
      lakes.waters, lakes.not_level == 0,
      {fmt::format("{}: {} by {} m at {}, {}", name, to_string(lakes.worst), lakes.largest_m, lakes.at.x, lakes.at.y),
       lakes.at,
       {lakes.worst},
       lakes.largest_m,
       name});
  const double allowed_m = std::max(kAllowedGap_m, level.error_m);
  const Footing footing = measure_footing(tile.chunk, tile.box, allowed_m, level, ground);
  tile.results().footing.tests += footing.corners;
  for (const GapBelow& gap : footing.floating)
    tile.results().footing.test_all(
        0, false,
        {fmt::format("{}: {} by {} m at {}, {}", name, to_string(gap.building), gap.gap_m, gap.corner.x, gap.corner.y),
         gap.corner,
         {gap.building},
         gap.gap_m,
         name});
}

void check_trunks(TileUnderCheck& tile, const bake::BakedTile& level, const std::string& name) {
  const Trunks trunks = measure_trunks(level, tile.cover, plants::SpeciesTable(tile.loaded.scene.header.species));
  tile.results().trunks.test_all(trunks.tested, trunks.conflicts == 0,
                                 {fmt::format("{}: {} of {} trunks, {} at {:.2f}, {:.2f}", name, trunks.conflicts,
                                              trunks.tested, to_string(trunks.element), trunks.at.x, trunks.at.y),
                                  trunks.at,
                                  {trunks.element},
                                  static_cast<double>(trunks.conflicts),
                                  name});
}

void check_things(TileUnderCheck& tile, const bake::BakedTile& level, const std::string& name) {
  const StandingThings found = measure_things(level, tile.chunk, tile.cover);
  tile.results().things.test_all(found.tested, found.conflicts == 0,
                                 {fmt::format("{}: {} of {} things, {} at {:.2f}, {:.2f}", name, found.conflicts,
                                              found.tested, to_string(found.element), found.at.x, found.at.y),
                                  found.at,
                                  {found.element},
                                  static_cast<double>(found.conflicts),
                                  name});
}

void add_hidden(const HiddenThings& found, const char* what, const std::string& name, Check& check) {
  check.test_all(found.tests, found.hidden == 0,
                 {fmt::format("{}: {} of {} {}, {} below {} at {:.2f}, {:.2f}", name, found.hidden, found.tests, what,
                              to_string(found.element), to_string(found.on_top), found.at.x, found.at.y),
                  found.at,
                  {found.element, found.on_top},
                  static_cast<double>(found.hidden),
                  name});
}

// The recipes of the ground and of what lies on it.
void check_land(TileUnderCheck& tile, const std::string& name) {
  const std::vector<std::int32_t>& heights = tile.chunk.heights.heights;
  if (!heights.empty()) {
    const auto [low, high] = std::ranges::minmax(heights);
    const double low_m = low * map::kHeightQuantum_m, high_m = high * map::kHeightQuantum_m;
    tile.results().on_earth.test_all(heights.size(), low_m >= source::kLowestLand_m && high_m <= source::kHighestLand_m,
                                     fmt::format("{}: {:.1f} to {:.1f} m", name, low_m, high_m));
  }
  add_hidden(measure_hidden_areas(tile.cover, tile.box), "areas", name, tile.results().areas);
  add_hidden(measure_hidden_tracks(tile.chunk, tile.cover, tile.box), "places of tracks", name, tile.results().tracks);
}

// The ground of a coarse tile may lie as far above the road as the tile's error says.
void check_wires(TileUnderCheck& tile, const bake::BakedTile& level, const GroundIndex& ground,
                 const std::string& name) {
  const double least_m = wires::kLeastOverRoad_m - level.error_m;
  const WiresOverRoads found = measure_wires(tile.chunk, tile.box, tile.cover, ground, least_m);
  tile.results().wires.test_all(
      found.spans, found.low == 0,
      {fmt::format("{}: {} of {} spans over roads, {} by {:.2f} m at {:.2f}, {:.2f}", name, found.low, found.spans,
                   to_string(found.lowest), found.lowest_m, found.at.x, found.at.y),
       found.at,
       {found.lowest},
       least_m - found.lowest_m,
       name});
}

void add_assumed(const AssumedTests& found, const char* what, const std::string& name, Check& check) {
  check.test_all(found.tested, found.conflicts == 0,
                 {fmt::format("{}: {} of {} {}, {} on {} at {:.2f}, {:.2f}", name, found.conflicts, found.tested, what,
                              to_string(found.element), to_string(found.obstacle), found.at.x, found.at.y),
                  found.at,
                  {found.element, found.obstacle},
                  static_cast<double>(found.conflicts),
                  name});
}

// Measures what is assumed, by the recipes and the finest level.
void check_assumed(TileUnderCheck& tile, const bake::BakedTile& level, const std::string& name) {
  add_assumed(measure_assumed_pavements(tile.chunk, tile.box), "places of pavements", name,
              tile.results().assumed_pavements);
  add_assumed(measure_assumed_lamps(level, tile.chunk, tile.cover), "lamps", name, tile.results().assumed_lamps);
  add_assumed(measure_parked_cars(level, tile.chunk, tile.car_cover), "cars", name, tile.results().parked_cars);
  add_assumed(measure_street_cars(level, tile.chunk, tile.car_cover), "cars", name, tile.results().street_cars);
  add_assumed(measure_street_furniture(level, tile.chunk, tile.cover), "pieces of street furniture", name,
              tile.results().street_furniture);
  add_assumed(measure_people(level, tile.cover), "people", name, tile.results().people);
  add_assumed(measure_assumed_railings(tile.chunk, tile.cover, tile.box), "places of railings", name,
              tile.results().assumed_railings);
  add_assumed(measure_assumed_masts(tile.chunk, tile.cover, tile.box), "feet of masts", name,
              tile.results().assumed_masts);
  add_assumed(measure_assumed_yards(tile.chunk, tile.cover, tile.box), "places and trees of yards", name,
              tile.results().assumed_yards);
  add_assumed(measure_assumed_hedges(tile.chunk, tile.cover, tile.box), "places of hedges", name,
              tile.results().assumed_hedges);
  add_assumed(measure_assumed_houses(tile.chunk, tile.cover, tile.box), "places of houses", name,
              tile.results().assumed_houses);
  add_assumed(measure_assumed_fronts(tile.chunk), "fronts", name, tile.results().assumed_fronts);
}

// Measures buildings by the triangles of the finest level: coarser ones have the same recipes.
void check_buildings(TileUnderCheck& tile, const bake::BakedTile& level, const GroundIndex& ground,
                     const std::string& name) {
  const FloorMeasure standing = measure_standing(tile.chunk, ground, level.error_m);
  tile.results().standing.tests += standing.buildings;
  for (const OffGround& off : standing.off)
    tile.results().standing.test_all(
        0, false,
        {fmt::format("{}: {} by {:.2f} m at {}, {}", name, to_string(off.building), off.off_m, off.at.x, off.at.y),
         off.at,
         {off.building},
         std::abs(off.off_m),
         name});
  tile.results().blank_walls = measure_blank_walls(tile.chunk, level, ground);
  tile.way_boxes = way_boxes_of(tile.chunk, [&](Vec2 p) { return ground::land_m(*tile.expected.graded, p); });
  tile.results().openings.tests +=
      static_cast<std::uint64_t>(std::ranges::count_if(tile.way_boxes, &WayBox::is_in_opening));
}

// Measures ways that run into walls at one level.
void check_ways(TileUnderCheck& tile, const bake::BakedTile& level, const std::string& name) {
  if (level.tolerance_m > kOpenUpTo_m) return;
  CheckResults& results = tile.results();
  for (const WayIntoWall& way : measure_ways(tile.way_boxes, level))
    if (way.is_in_opening)
      results.openings.test_all(0, false,
                                {fmt::format("{}: {} into {} by {:.3f} m² at {:.2f}, {:.2f}", name, to_string(way.way),
                                             to_string(way.building), way.area_m2, way.at.x, way.at.y),
                                 way.at,
                                 {way.way, way.building},
                                 way.area_m2,
                                 name});
    else
      results.ways_into_walls.push_back(way);
}

// True if baked recipes give exactly the bytes of the file.
bool is_baked(const TileUnderCheck& tile, bake::BakedTile&& baked, std::span<const std::byte> bytes) {
  const outputs::RunRecord& record = tile.loaded.record;
  const scene::Header& header = tile.loaded.scene.header;
  const exporters::GlbOptions options{
      .target = record.target, .split = record.split, .compression = record.compress, .lights = tile.lights};
  const exporters::EncodedTile encoded =
      exporters::encode_tile(bake::in_world(std::move(baked), header), header, options, kOneThread, record.layout);
  return std::ranges::equal(encoded.glb, bytes);
}

// Checks that the vertices of a file, mapped back by other functions than those that bent them, are those of the baked
// tile; halved edges add vertices on its edges. Packed files have another order of vertices, and their bytes suffice.
void check_bend(TileUnderCheck& tile, const map::Cylinder& cylinder, const bake::BakedTile& baked,
                const bake::BakedTile& written, const std::string& name) {
  if (tile.loaded.record.compress != Compression::kNone) return;
  const double off_m = off_cylinder_m(cylinder, baked, written);
  // rounding to the grid or to single precision, and the stretch of heights below a half of the radius
  constexpr double kRounded_m = 4 * kQuantum_m;
  tile.results().bend.test(off_m <= kRounded_m, fmt::format("{}: a vertex is {} m off", name, off_m));
}

Result<Done> check_glb_level(TileUnderCheck& tile, bake::PreparedTile& prepared, std::size_t level,
                             const outputs::WrittenFile& file) {
  const LoadedRun& loaded = tile.loaded;
  const std::string path = loaded.folder + "/" + file.name;
  const Result<std::vector<std::byte>> bytes = exporters::read_file(path);
  if (!bytes) return bytes.error();
  Result<bake::BakedTile> written = exporters::read_glb(path);
  if (!written) return written.error();
  expect_ground(tile, bake::expected_ground_of(prepared, level));
  check_area(tile, bake::ground_of(prepared, level), file.name);
  Report ignored;
  bake::BakedTile baked = bake::bake_prepared(prepared, level, kOneThread, ignored);
  if (const auto cylinder = scene::cylinder_of(loaded.scene.header)) {
    // measured in the plane: the file's tile is the image of the baked one, which the bytes and its vertices show
    check_bend(tile, *cylinder, baked, *written, file.name);
    *written = baked;
  }
  tile.results().glb_bytes.test(is_baked(tile, std::move(baked), *bytes), file.name);
  const GroundIndex ground = index_ground(*written);
  check_ground(tile, *written, ground, file.name);
  check_heights(tile, *written, ground, file.name);
  check_trunks(tile, *written, file.name);
  check_things(tile, *written, file.name);
  if (level == 0) check_buildings(tile, *written, ground, file.name), check_assumed(tile, *written, file.name);
  if (level == 0) check_land(tile, file.name), check_wires(tile, *written, ground, file.name);
  check_ways(tile, *written, file.name);
  tile.checked.borders.push_back(borders_of(*written, tile.box));
  return Done{};
}

}  // namespace

Result<CheckedTile> check_tile(const LoadedRun& loaded, std::span<const outputs::WrittenTile> levels) {
  const Result<RecipesOfTile> recipes = prepare_tile(loaded, levels);
  if (!recipes) return recipes.error();
  const std::shared_ptr<const scene::Chunk> shown = scene::shared_shown_chunk(loaded.scene.header, recipes->chunk);
  const scene::Chunk& chunk = *shown;
  TileUnderCheck tile{loaded,
                      chunk,
                      scene::box_of(loaded.scene.header, chunk.tile),
                      water_levels_of(chunk),
                      scene::coarse_land_cover(chunk),
                      {},
                      scene::land_cover_of(loaded.scene.header, chunk, kCoarsest_m),
                      {},
                      {},
                      {},
                      outputs::lights_of(loaded.scene.header, chunk, loaded.record.lights)};
  tile.cover = ground::index_land_cover(tile.surfaces, tile.box.widened(scene::kHalo_m));
  tile.car_cover = ground::index_land_cover(tile.with_plots.surfaces, tile.box.widened(scene::kHalo_m));
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (const Result<Done> done = check_glb_level(tile, *recipes->prepared, i, levels[i].file); !done)
      return done.error();
  tile.results().ways_into_walls = combined(std::move(tile.results().ways_into_walls));
  return std::move(tile.checked);
}

}  // namespace citykiln::verify
