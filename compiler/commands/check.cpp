// citykiln check OUT: measures again every promise that the outputs make. A promise that holds is "not falsified by n
// samples".
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/bake/bake.h"
#include "compiler/bake/fire_ground.h"
#include "compiler/commands/ground_index.h"
#include "compiler/commands/measure_clearances.h"
#include "compiler/commands/measure_following.h"
#include "compiler/commands/measure_footing.h"
#include "compiler/commands/measure_ground.h"
#include "compiler/commands/measure_lakes.h"
#include "compiler/commands/measure_lines.h"
#include "compiler/commands/measure_road_faces.h"
#include "compiler/commands/measure_trunks.h"
#include "compiler/commands/run_report.h"
#include "compiler/commands/verb.h"
#include "compiler/commands/write_tiles.h"
#include "compiler/geometry/snap.h"
#include "compiler/ground/expand.h"
#include "compiler/ground/follow_lines.h"
#include "compiler/scene/ground_carving.h"
#include "compiler/scene/ground_cover.h"
#include "exporters/file.h"
#include "exporters/glb.h"
#include "exporters/manifest.h"

namespace citykiln::commands {
namespace {

/// A million places a tile.
constexpr int kSamplesASide = 1024;

/// A step that nobody sees.
constexpr double kNoJump_m = 0.01;

/// One promise, how often it was put to the test, and where it broke.
struct Finding {
  std::string promise;
  std::uint64_t tests = 0;
  std::vector<std::string> breaches;

  void test(bool holds, const std::string& breach) {
    ++tests;
    if (!holds) breaches.push_back(breach);
  }

  void test_all(std::uint64_t count, bool hold, const std::string& breach) {
    tests += count;
    if (!hold) breaches.push_back(breach);
  }
};

struct Findings {
  Finding ledger{"in + split = out + merged + dropped in every account", 0, {}};
  Finding forms{"every .glb is what the manifest bakes, byte for byte", 0, {}};
  Finding area{"the plan area of the ground's faces is the plan area of the tile", 0, {}};
  Finding height{"the ground is nowhere farther from its heights than error_m", 0, {}};
  Finding seams{"neighbouring tiles have the same border edges", 0, {}};
  Finding jumps{"roads, bridges and tunnels meet at the same height, to 1 cm", 0, {}};
  Finding roads{"the ground is nowhere farther from a road's profile than error_m", 0, {}};
  Finding rivers{"no river rises", 0, {}};
  Finding lakes{"standing water is level", 0, {}};
  Finding footing{"under no corner of a building is a gap over 5 cm, or over error_m where that is more", 0, {}};
  Finding trunks{"no trunk stands in a road, a rail, a building or water", 0, {}};
  // stated, not judged
  Grades grades;
  Following following;
  Clearances clearances;

  std::vector<const Finding*> all() const {
    return {&ledger, &forms, &area, &height, &seams, &jumps, &roads, &rivers, &lakes, &footing, &trunks};
  }
};

/// What a run left, in memory but for the tiles.
struct Subject {
  std::string folder;
  RunRecord record;
  scene::Scene scene;
  Standing standing;
};

/// Names of recipes, added to others.
template <typename Recipe>
void add_ids(std::span<const Recipe> recipes, std::vector<OsmId>& ids) {
  for (const Recipe& recipe : recipes) ids.push_back(recipe.id.osm);
}

/// A fence may bear the id of the field it goes around: then its faces are taken for the field's, over which they
/// stand.
std::vector<OsmId> walls_of(const scene::Scene& scene) {
  std::vector<OsmId> walls, fields, only_walls;
  for (const scene::Chunk& chunk : scene.chunks) {
    add_ids(std::span(chunk.barriers), walls);
    add_ids(std::span(chunk.surfaces), fields);
  }
  std::ranges::sort(walls);
  std::ranges::sort(fields);
  std::ranges::set_difference(walls, fields, std::back_inserter(only_walls));
  return only_walls;
}

std::vector<OsmId> leaving_of(const scene::Scene& scene) {
  std::vector<OsmId> leaving = walls_of(scene);
  for (const scene::Chunk& chunk : scene.chunks) {
    add_ids(std::span(chunk.bridges), leaving);
    add_ids(std::span(chunk.tunnels), leaving);
  }
  std::ranges::sort(leaving);
  return leaving;
}

std::vector<OsmId> houses_of(const scene::Scene& scene) {
  std::vector<OsmId> houses;
  for (const scene::Chunk& chunk : scene.chunks) add_ids(std::span(chunk.buildings), houses);
  std::ranges::sort(houses);
  return houses;
}

/// Of houses that are mapped as a square or a pitch too.
std::vector<std::pair<OsmId, materials::Material>> fields_of(const scene::Scene& scene,
                                                             const std::vector<OsmId>& houses) {
  std::vector<std::pair<OsmId, materials::Material>> fields;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const ground::Surface& surface : chunk.surfaces)
      if (surface.surface != map::SurfaceClass::kBuilding && std::ranges::binary_search(houses, surface.id.osm))
        fields.emplace_back(surface.id.osm, map::values_of(surface.surface).material);
  std::ranges::sort(fields);
  return fields;
}

std::vector<OsmId> steps_of(const scene::Scene& scene) {
  std::vector<OsmId> steps;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const roads::Road& road : chunk.roads)
      if (road.surface == map::SurfaceClass::kSteps) steps.push_back(road.id.osm);
  std::ranges::sort(steps);
  return steps;
}

/// The levels of standing water by the name of its faces.
using Levels = std::multimap<OsmId, double>;

Levels levels_of(const scene::Chunk& chunk) {
  Levels levels;
  for (const ground::Surface& surface : chunk.surfaces)
    if (surface.level_m) levels.emplace(surface.id.osm, *surface.level_m);
  return levels;
}

Result<Subject> open_subject(const std::string& folder) {
  Result<RunRecord> record = read_report(folder);
  if (!record) return record.error();
  Result<scene::Scene> scene = exporters::read_manifest(folder + "/scene.kiln", {});
  if (!scene) return scene.error();
  Standing standing{leaving_of(*scene), houses_of(*scene)};
  standing.fields = fields_of(*scene, standing.houses);
  standing.steps = steps_of(*scene);
  return Subject{folder, std::move(*record), std::move(*scene), std::move(standing)};
}

const scene::Chunk* chunk_of(const scene::Scene& scene, scene::TileKey tile) {
  const auto found = std::ranges::find(scene.chunks, tile, &scene::Chunk::tile);
  return found == scene.chunks.end() ? nullptr : &*found;
}

/// The carved ground of a tile, and what is laid on it at a tolerance.
struct Carved {
  Box2 box;
  ground::Carving carving;
  scene::GroundCover cover;
};

Carved carved_ground(const Subject& subject, const scene::Chunk& chunk, double tolerance_m) {
  const scene::Header& header = subject.scene.header;
  return {scene::box_of(header, chunk.tile), scene::carving_of(header, chunk, tolerance_m),
          scene::cover_of(header, chunk, tolerance_m)};
}

/// The cells of one tile, put together again: their areas must add up.
double ground_area_m2(const Carved& carved, double tolerance_m) {
  double area = 0;
  Report ignored;
  for (const ground::GroundMesh& cell :
       bake::expand_cells(carved.carving, carved.cover.surfaces, carved.box, tolerance_m, 0, ignored)) {
    for (const Triangle& t : cell.mesh.triangles) {
      const auto corner = [&](std::size_t i) { return in_plan(cell.mesh.positions[t[i]]); };
      area += 0.5 * cross(corner(1) - corner(0), corner(2) - corner(0));
    }
  }
  return area;
}

/// How far from the nearest of some heights.
double off_by(std::span<const double> heights_m, double z_m) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const double height_m : heights_m) least_m = std::min(least_m, std::abs(z_m - height_m));
  return least_m;
}

/// The cells of a tile, each as exact as it gets.
struct ReferenceCells {
  Box2 box;
  std::vector<ground::Reference> cells;

  const ground::Reference& at(Vec2 p) const {
    const auto rows = static_cast<std::size_t>(box.height() / map::kCell_m);
    const auto column = static_cast<std::size_t>((p.x - box.min.x) / map::kCell_m);
    const auto row = static_cast<std::size_t>((p.y - box.min.y) / map::kCell_m);
    return cells[std::min(column * rows + row, cells.size() - 1)];
  }
};

/// Standing water lies at one of its levels, all else on any layer.
GroundSamples sampled(const Subject& subject, const ReferenceCells& references, const Levels& levels,
                      const bake::BakedTile& tile) {
  const auto off_m = [&](Vec2 p, double z_m, OsmId feature) {
    const auto [first, last] = levels.equal_range(feature);
    std::vector<double> heights_m;
    for (auto level = first; level != last; ++level) heights_m.push_back(level->second);
    if (first == last)
      for (std::size_t layer = 0; layer < static_cast<std::size_t>(ground::HeightLayer::kCount); ++layer)
        heights_m.push_back(ground::height_m_at(references.at(p), p, static_cast<ground::HeightLayer>(layer)));
    return off_by(heights_m, z_m);
  };
  return sample_ground(tile, subject.standing, off_m, references.box, kSamplesASide);
}

void check_ground(const Subject& subject, const scene::Chunk& chunk, const bake::BakedTile& tile,
                  const std::string& name, Findings& findings) {
  const Carved carved = carved_ground(subject, chunk, tile.tolerance_m);
  const double tile_m2 = carved.box.width() * carved.box.height();
  const double ground_m2 = ground_area_m2(carved, tile.tolerance_m);
  findings.area.test(std::abs(ground_m2 - tile_m2) <= 1e-9 * tile_m2,
                     fmt::format("{}: {} m² instead of {}", name, ground_m2, tile_m2));

  const ReferenceCells references{carved.box,
                                  bake::reference_cells(carved.carving, carved.cover.surfaces, carved.box, 0)};
  const auto reference_at = [&](Vec2 p) -> const ground::Reference& { return references.at(p); };
  findings.following = worse(findings.following, measure_following(carved.carving, carved.cover.surfaces, reference_at,
                                                                   carved.box, kSamplesASide / 2));
  const GroundSamples samples = sampled(subject, references, levels_of(chunk), tile);
  findings.height.tests += samples.count;
  // the baked ground is snapped to the grid, half a quantum to either side
  if (samples.error_m > tile.error_m + kQuantum_m) {
    findings.height.breaches.push_back(fmt::format("{}: {} m where {} m is stated, at {},{}", name, samples.error_m,
                                                   tile.error_m, samples.at.x, samples.at.y));
  }
  if (samples.uncovered > 0)
    findings.height.breaches.push_back(fmt::format("{}: {} places without ground", name, samples.uncovered));
}

RoadFaces road_faces_of(const scene::Chunk& chunk, const Box2& box, double tolerance_m, const GroundIndex& ground) {
  return measure_road_faces(chunk, box, tolerance_m < scene::kPlainRoads_m, [&](const roads::Road& road, Vec2 p) {
    const std::vector<GroundPlace> places = ground_at(ground, p);
    const bool is_its_own = !places.empty() && places.front().feature == road.id.osm;
    return is_its_own ? std::vector{places.front().z_m} : std::vector<double>{};
  });
}

/// What stands and lies on the ground of one file, by its own triangles.
void check_heights(const Subject& subject, const scene::Chunk& chunk, const bake::BakedTile& tile,
                   const std::string& name, Findings& findings) {
  const Box2 box = scene::box_of(subject.scene.header, chunk.tile);
  const GroundIndex ground = index_ground(tile, subject.standing);

  const RoadFaces roads = road_faces_of(chunk, box, tile.tolerance_m, ground);
  findings.roads.test_all(roads.places, roads.largest_gap_m <= tile.error_m + kQuantum_m,
                          fmt::format("{}: {} m at {}, {} of {}", name, roads.largest_gap_m, roads.at.x, roads.at.y,
                                      to_string(roads.worst)));
  const Lakes lakes = measure_lakes(chunk, ground);
  findings.lakes.test_all(lakes.waters, lakes.not_level == 0,
                          fmt::format("{}: {} by {} m", name, to_string(lakes.worst), lakes.largest_m));
  const double allowed_m = std::max(kNoGap_m, tile.error_m);
  const Footing footing = measure_footing(chunk, box, allowed_m, tile, ground);
  findings.footing.test_all(footing.corners, footing.floating == 0,
                            fmt::format("{}: {} buildings, {} by {} m", name, footing.floating,
                                        to_string(footing.worst), footing.largest_gap_m));
}

/// What the manifest alone says.
void check_recipes(const scene::Scene& scene, Findings& findings) {
  findings.clearances = measure_clearances(scene, 0);
  const Jumps jumps = measure_jumps(scene);
  findings.jumps.test_all(jumps.places, jumps.largest_m <= kNoJump_m,
                          fmt::format("{} m at {}, {}", jumps.largest_m, jumps.at.x, jumps.at.y));
  for (const scene::Chunk& chunk : scene.chunks) {
    const Rises rises = measure_rises(chunk);
    findings.rivers.test_all(
        rises.streams, rises.rising == 0,
        fmt::format("{}: {} streams, by {} m", to_string(chunk.tile), rises.rising, rises.largest_m));
    const Grades grades = measure_grades(scene.header, chunk);
    findings.grades.length_m += grades.length_m, findings.grades.over_m += grades.over_m;
  }
}

void check_trunks(const Subject& subject, const scene::Chunk& chunk, const bake::BakedTile& tile,
                  const std::string& name, Findings& findings) {
  const std::vector<ground::Surface> surfaces = scene::surfaces_of(chunk);
  const Box2 box = scene::box_of(subject.scene.header, chunk.tile);
  const Trunks trunks = measure_trunks(tile, ground::map_surfaces(surfaces, box.widened(scene::kHalo_m)));
  findings.trunks.test_all(trunks.trees, trunks.misplaced == 0,
                           fmt::format("{}: {} of {} trunks, {} at {:.2f}, {:.2f}", name, trunks.misplaced,
                                       trunks.trees, to_string(trunks.worst), trunks.at.x, trunks.at.y));
}

/// One file against the manifest and against itself.
Result<bake::BakedTile> check_tile(const Subject& subject, const WrittenTile& written, Findings& findings) {
  const std::string path = subject.folder + "/" + written.file.name;
  const Result<std::vector<std::byte>> bytes = exporters::read_file(path);
  if (!bytes) return bytes.error();
  Result<bake::BakedTile> tile = exporters::decode_glb(*bytes, path);
  if (!tile) return tile.error();
  const scene::Chunk* chunk = chunk_of(subject.scene, written.tile);
  if (chunk == nullptr) return Error{path, "is a tile that the manifest does not have"};

  Report ignored;
  const bake::BakedTile baked = bake::bake(subject.scene.header, *chunk, written.tolerance_m, 0, ignored);
  const RunRecord& record = subject.record;
  const EncodedTile encoded = encode_tile(baked, subject.scene.header, record.instances_as_nodes, record.compress, 0);
  findings.forms.test(encoded.glb == *bytes, written.file.name);
  check_ground(subject, *chunk, *tile, written.file.name, findings);
  check_heights(subject, *chunk, *tile, written.file.name, findings);
  check_trunks(subject, *chunk, *tile, written.file.name, findings);
  return tile;
}

/// The edges at each side of a tile at one level, waiting for the neighbour's.
struct Borders {
  std::vector<BorderEdge> west, east, south, north;
};

Borders borders_of(const bake::BakedTile& tile, const Standing& standing, const Box2& box) {
  return {border_edges_along_x(tile, standing, box.min.x), border_edges_along_x(tile, standing, box.max.x),
          border_edges_along_y(tile, standing, box.min.y), border_edges_along_y(tile, standing, box.max.y)};
}

using BordersByTile = std::map<std::pair<std::size_t, scene::TileKey>, Borders>;

void check_seams(const BordersByTile& borders, Findings& findings) {
  for (const auto& [key, own] : borders) {
    const auto [level, tile] = key;
    if (const auto east = borders.find({level, {tile.x + 1, tile.y}}); east != borders.end()) {
      findings.seams.test(own.east == east->second.west,
                          fmt::format("{} and its eastern neighbour, level {}", to_string(tile), level));
    }
    if (const auto north = borders.find({level, {tile.x, tile.y + 1}}); north != borders.end()) {
      findings.seams.test(own.north == north->second.south,
                          fmt::format("{} and its northern neighbour, level {}", to_string(tile), level));
    }
  }
}

Result<Findings> check_all(const Subject& subject, const OnProgress& on_progress) {
  Findings findings;
  findings.ledger.tests = 1;
  findings.ledger.breaches = subject.record.unbalanced;
  check_recipes(subject.scene, findings);

  BordersByTile borders;
  for (std::size_t i = 0; i < subject.record.tiles.size(); ++i) {
    on_progress("check", static_cast<double>(i) / static_cast<double>(subject.record.tiles.size()));
    const WrittenTile& written = subject.record.tiles[i];
    const Result<bake::BakedTile> tile = check_tile(subject, written, findings);
    if (!tile) return tile.error();
    borders[{written.level, written.tile}] =
        borders_of(*tile, subject.standing, scene::box_of(subject.scene.header, written.tile));
  }
  check_seams(borders, findings);
  return findings;
}

nlohmann::ordered_json stated(const Grades& grades, const Console& console) {
  console.say(fmt::format("stated {:.1f} km of {:.1f} km of graded roads are over their class's limit",
                          grades.over_m / 1000, grades.length_m / 1000));
  return {{"stated", "length of graded roads over their class's limit"},
          {"length_m", grades.length_m},
          {"over_m", grades.over_m}};
}

nlohmann::ordered_json stated(const Clearances& clearances, const Console& console) {
  const Clearances& c = clearances;
  console.say(fmt::format(
      "stated {} of {} crossings lack clearance, {} over 1 m, {} over 3 m; most, {:.2f} m, {} over {} at {}, {}",
      c.lacking, c.crossings, c.lacking_over_1_m, c.lacking_over_3_m, c.largest_lack_m, to_string(c.upper),
      to_string(c.lower), c.at.x, c.at.y));
  return {{"stated", "crossings that lack clearance"},
          {"crossings", c.crossings},
          {"lacking", c.lacking},
          {"lacking_over_1_m", c.lacking_over_1_m},
          {"lacking_over_3_m", c.lacking_over_3_m},
          {"largest_lack_m", c.largest_lack_m},
          {"upper", to_string(c.upper)},
          {"lower", to_string(c.lower)},
          {"at", {c.at.x, c.at.y}}};
}

void tell(const Findings& findings, const Console& console) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Finding* finding : findings.all()) {
    json.push_back({{"promise", finding->promise}, {"tests", finding->tests}, {"breaches", finding->breaches}});
    const bool holds = finding->breaches.empty();
    console.say(
        fmt::format("{} {}: {}", holds ? "holds " : "BROKEN", finding->promise,
                    holds ? fmt::format("not falsified by {} tests", finding->tests) : finding->breaches.front()));
  }
  json.push_back(stated(findings.grades, console));
  json.push_back(stated(findings.clearances, console));
  const Following& following = findings.following;
  json.push_back({{"stated", "places where the triangulated ground strays from the carved heights"},
                  {"places", following.places},
                  {"over", following.over},
                  {"largest_m", following.largest_m}});
  console.say(fmt::format(
      "stated {:.2f} % of {} places stray from the carved heights by over {} m, the worst by {:.2f} m at {:.2f}, "
      "{:.2f}",
      100.0 * static_cast<double>(following.over) / static_cast<double>(std::max<std::uint64_t>(following.places, 1)),
      following.places, 2 * ground::kFollow_m, following.largest_m, following.at.x, following.at.y));
  console.answer(json.dump(1));
}

Result<Exit> run(const std::string& folder, const Console& console) {
  if (folder.empty()) return Error{"", "no folder of a run is given"};
  const Result<Subject> subject = open_subject(folder);
  if (!subject) return subject.error();
  const Result<Findings> findings = check_all(*subject, console.progress());
  if (!findings) return findings.error();
  tell(*findings, console);
  for (const Finding* finding : findings->all()) {
    if (!finding->breaches.empty())
      return Error{folder, fmt::format("breaks a promise: {} ({})", finding->promise, finding->breaches.front())};
  }
  return Exit::kDone;
}

}  // namespace

Verb check_verb() {
  const auto folder = std::make_shared<std::string>();
  Verb verb{"check", "measures again every promise that a run's outputs make", {}, {}};
  verb.options = {{"folder", "OUT", "the folder of a run, with its manifest", false, into(*folder)}};
  verb.run = [folder](const Console& console) { return run(*folder, console); };
  return verb;
}

}  // namespace citykiln::commands
