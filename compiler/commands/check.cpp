// citykiln check FOLDER: measures whether a run's outputs keep their guarantees. A guarantee that holds has not been
// falsified by n samples.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "compiler/commands/edits_template.h"
#include "compiler/commands/print_check_results.h"
#include "compiler/commands/run_paths.h"
#include "compiler/commands/verb.h"
#include "compiler/commands/view/worst_page.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/outputs/findings.h"
#include "compiler/verify/check_folder.h"
#include "compiler/verify/check_seams.h"
#include "compiler/verify/check_tile.h"
#include "compiler/verify/check_tileset.h"
#include "compiler/verify/check_usd.h"
#include "compiler/verify/heights/explain_earthworks.h"
#include "compiler/verify/heights/measure_earthworks.h"
#include "compiler/verify/measure_decks.h"
#include "compiler/verify/worst_places.h"
#include "exporters/file.h"
#include "exporters/kiln/manifest.h"
#include "exporters/output_folder.h"
#include "exporters/run_files.h"

namespace citykiln::commands {
namespace {

// The largest height difference that does not count, in metres.
constexpr double kNoJump_m = 0.01;

Result<verify::LoadedRun> open_run(const std::string& folder) {
  Result<outputs::RunRecord> record = outputs::read_report(folder);
  if (!record) return record.error();
  if (!record->has_manifest) return missing_manifest(folder);
  Result<scene::Scene> scene = exporters::read_manifest(folder + "/" + exporters::kManifestName, {});
  if (!scene) return scene.error();
  auto prototypes = std::make_shared<const bake::PrototypeCache>(scene->header);
  return verify::LoadedRun{
      .folder = folder, .record = std::move(*record), .scene = std::move(*scene), .prototypes = std::move(prototypes)};
}

// Measures cuts and fills; land that stands alone in the way of a line is a failure.
void check_land(const scene::Scene& scene, std::span<const outputs::Finding> findings, verify::CheckResults& results) {
  results.earthworks = verify::measure_earthworks(scene);
  results.deep_earthworks = verify::explain_earthworks(scene, results.earthworks, findings);
  results.land.tests += results.earthworks.size();
  for (const auto& [e, reason] : results.deep_earthworks)
    if (reason == verify::EarthworkReason::kStandsAlone)
      results.land.test_all(0, false,
                            {fmt::format("{} of {:.1f} m of {} {} at {:.0f}, {:.0f}", e.depth_m > 0 ? "cut" : "fill",
                                         std::abs(e.depth_m), e.line, to_string(e.id), e.at.x, e.at.y),
                             e.at,
                             {e.id},
                             std::abs(e.depth_m)});
}

// Adds a failure for each finding of a code.
void count_findings(std::span<const outputs::Finding> findings, Code code, const scene::Header& header,
                    verify::Check& check) {
  const map::Plane plane(header.origin);
  for (const outputs::Finding& finding : findings) {
    if (finding.diagnosis.code != code) continue;
    const OsmId id = finding.diagnosis.object;
    verify::Failure failure(fmt::format("finding {} of {}", name_of(code), to_string(id)));
    failure.ids = {id};
    if (finding.at) failure.at = plane.forward(*finding.at);
    check.test(false, failure);
  }
}

// Bridges that are areas, and parts of buildings. The manifest has neither areas without a deck nor outlines of parts:
// those are findings.
void check_mapped(const scene::Scene& scene, std::span<const outputs::Finding> findings,
                  verify::CheckResults& results) {
  const verify::BridgesOnAreas bridges = verify::measure_decks(scene);
  results.decks.test_all(bridges.tests, bridges.missing == 0,
                         {fmt::format("{} of {} bridges on areas, {} at {:.2f}, {:.2f}", bridges.missing, bridges.tests,
                                      to_string(bridges.element), bridges.at.x, bridges.at.y),
                          bridges.at,
                          {bridges.element},
                          static_cast<double>(bridges.missing)});
  count_findings(findings, Code::kBridgeAreaWithoutDeck, scene.header, results.decks);
  for (const scene::Chunk& chunk : scene.chunks) results.parts.tests += chunk.buildings.size();
  count_findings(findings, Code::kPartUnlikeOutline, scene.header, results.parts);
}

// Checks that need the manifest and the findings only.
void check_recipes(const scene::Scene& scene, std::span<const outputs::Finding> findings, int threads,
                   verify::CheckResults& results) {
  results.clearances = verify::with_findings(verify::measure_clearances(scene, threads), findings);
  check_land(scene, findings, results);
  check_mapped(scene, findings, results);
  const verify::Jumps jumps = verify::measure_jumps(scene);
  results.jumps.test_all(
      jumps.places, jumps.largest_m <= kNoJump_m,
      {fmt::format("{} m at {}, {}", jumps.largest_m, jumps.at.x, jumps.at.y), jumps.at, {}, jumps.largest_m});
  results.crossing_steps = verify::measure_crossing_steps(scene);
  for (const scene::Chunk& chunk : scene.chunks) {
    const verify::Rises rises = verify::measure_rises(chunk);
    results.rivers.test_all(
        rises.streams, rises.rising == 0,
        fmt::format("{}: {} watercourses, by up to {} m", to_string(chunk.tile), rises.rising, rises.largest_m));
    const verify::Grades grades = verify::measure_grades(scene.header, chunk);
    results.grades.length_m += grades.length_m, results.grades.over_m += grades.over_m;
  }
}

// Groups the files by tile, in the order of tiles, then levels.
std::vector<std::vector<outputs::WrittenTile>> by_tile(std::vector<outputs::WrittenTile> written) {
  const auto key = [](const outputs::WrittenTile& w) { return std::pair(w.tile, w.level); };
  std::ranges::stable_sort(written, {}, key);
  std::vector<std::vector<outputs::WrittenTile>> tiles;
  for (outputs::WrittenTile& each : written) {
    if (tiles.empty() || tiles.back().front().tile != each.tile) tiles.emplace_back();
    tiles.back().push_back(std::move(each));
  }
  return tiles;
}

Result<verify::CheckResults> check_tiles(const verify::LoadedRun& loaded, int threads, const OnProgress& on_progress,
                                         verify::CheckResults results) {
  const std::vector<std::vector<outputs::WrittenTile>> tiles = by_tile(loaded.record.tiles);
  std::vector<std::optional<Result<verify::CheckedTile>>> slots(tiles.size());
  verify::BordersByTile borders;
  Result<Done> done = Done{};
  const auto take = [&](std::size_t i) {
    on_progress("check tiles", static_cast<double>(i) / static_cast<double>(tiles.size()));
    const Result<verify::CheckedTile> checked = *std::exchange(slots[i], std::nullopt);
    if (!checked) done = checked.error();
    if (!checked) return false;
    add(results, checked->results);
    for (std::size_t level = 0; level < tiles[i].size(); ++level)
      borders[{tiles[i][level].level, tiles[i][level].tile}] = checked->borders[level];
    return true;
  };
  for_each_in_order(
      tiles.size(), threads, [&](std::size_t i) { slots[i] = verify::check_tile(loaded, tiles[i]); }, take);
  if (!done) return done.error();
  // where one tile has a road along its border, its neighbour may have land, which is left out
  if (shows(loaded.scene.header, scene::SceneLayer::kGround)) verify::check_seams(borders, results.seams);
  return results;
}

// The USD outputs, tile by tile.
Result<Done> check_usd(const verify::LoadedRun& loaded, int threads, verify::CheckResults& results) {
  if (loaded.record.usd.empty()) return Done{};
  const Result<verify::CheckResults> scene = verify::check_usd_scene(loaded);
  if (!scene) return scene.error();
  add(results, *scene);
  const std::vector<std::vector<outputs::WrittenTile>> tiles = by_tile(loaded.record.usd);
  const auto checked = for_each_slot<std::optional<Result<verify::CheckResults>>>(
      tiles.size(), threads, [&](std::size_t i) { return std::optional(verify::check_usd_tile(loaded, tiles[i])); });
  for (const auto& tile : checked) {
    if (!*tile) return tile->error();
    add(results, **tile);
  }
  return Done{};
}

Error failure(const std::string& folder, const verify::Check& check) {
  const std::size_t more = check.failures.size() - 1;
  return {folder, fmt::format("fails the check \"{}\": {}{}", check.claim, check.failures.front().text,
                              more > 0 ? fmt::format(" and {} more", more) : "")};
}

struct CheckRequest {
  std::string folder, page_folder;
  std::string template_path;  // of a file of edits; "": none
  std::size_t worst = 0;      // places of each kind on the page; 0: no page
  int threads = 0;
};

Result<std::vector<outputs::Finding>> read_findings(const std::string& folder) {
  const std::string path = folder + "/" + exporters::kFindingsName;
  const Result<std::vector<std::byte>> bytes = exporters::read_file(path);
  if (!bytes) return bytes.error();
  auto findings = outputs::parse_findings({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
  if (!findings) return Error{path, findings.error().message};
  return findings;
}

// The page of the worst places, if it is asked for.
Result<Done> write_page(const CheckRequest& request, const verify::LoadedRun& loaded,
                        std::span<const outputs::Finding> findings, const verify::CheckResults& results,
                        const Console& console, const OnProgress& on_progress) {
  if (request.worst == 0) return Done{};
  const std::vector<verify::PlacesOfKind> kinds = verify::worst_places(
      results, results.earthworks, findings, map::Plane(loaded.scene.header.origin), request.worst);
  const Result<Done> written = write_worst_page(loaded, kinds, request.page_folder, request.threads, on_progress);
  if (!written) return written;
  console.print_line(request.page_folder + "/index.html: the worst places");
  return Done{};
}

// The file of edits for what was found, if it is asked for.
Result<Done> write_template(const CheckRequest& request, const verify::LoadedRun& loaded,
                            std::span<const outputs::Finding> findings, const verify::CheckResults& results,
                            const Console& console) {
  if (request.template_path.empty()) return Done{};
  const map::Plane plane(loaded.scene.header.origin);
  const std::vector<verify::PlacesOfKind> kinds =
      verify::worst_places(results, results.earthworks, findings, plane, std::numeric_limits<std::size_t>::max());
  const std::string text = edits_template(kinds, findings, plane, loaded.folder);
  const Result<Done> written = exporters::write_file(request.template_path, exporters::bytes_of(text));
  if (!written) return written;
  console.print_line(request.template_path + ": edits that would be the likely mends, as comments");
  return Done{};
}

Result<Exit> run_check(const CheckRequest& request, const Console& console) {
  if (request.folder.empty())
    return Error{"", "no folder is given; expected the output folder of compile, such as out"};
  if ((request.worst > 0) != !request.page_folder.empty())
    return Error{"--worst", "needs -o FOLDER, which the page is written to, and the reverse"};
  if (const Result<Done> fits = check_run_path(request.folder); !fits) return fits.error();
  const std::string folder = folder_of(request.folder);
  std::error_code none;
  if (!std::filesystem::is_directory(folder, none)) return Error{folder, "expected the folder of a run, found a file"};
  if (!request.template_path.empty())
    if (const Result<Done> fits = check_output_file(request.template_path); !fits) return fits.error();
  if (request.worst > 0)
    if (const Result<Done> made = make_output_folder(request.page_folder); !made) return made.error();
  const OnProgress on_progress = console.progress();
  on_progress("check files", 0);
  const Result<verify::LoadedRun> loaded = open_run(folder);
  if (!loaded) return loaded.error();
  const Result<std::vector<outputs::Finding>> findings = read_findings(folder);
  if (!findings) return findings.error();
  verify::CheckResults recipes;
  if (const Result<Done> done = verify::check_folder(*loaded, request.threads, recipes); !done) return done.error();
  // broken files cannot be measured
  if (!recipes.files.failures.empty()) return failure(folder, recipes.files);
  recipes.ledger.tests = 1;
  for (const std::string& account : loaded->record.unbalanced) recipes.ledger.test_all(0, false, account);
  on_progress("check recipes", 0);
  check_recipes(loaded->scene, *findings, request.threads, recipes);
  Result<verify::CheckResults> results = check_tiles(*loaded, request.threads, on_progress, std::move(recipes));
  if (!results) return results.error();
  on_progress("check usd and tileset", 0);
  if (const Result<Done> done = check_usd(*loaded, request.threads, *results); !done) return done.error();
  verify::check_tileset(*loaded, request.threads, *results);
  print(*results, console);
  if (const Result<Done> done = write_page(request, *loaded, *findings, *results, console, on_progress); !done)
    return done.error();
  if (const Result<Done> done = write_template(request, *loaded, *findings, *results, console); !done)
    return done.error();
  for (const verify::Check* check : verify::all_of(*results)) {
    if (!check->failures.empty()) return failure(folder, *check);
  }
  return Exit::kDone;
}

}  // namespace

Verb check_verb() {
  const auto request = std::make_shared<CheckRequest>();
  Verb verb{"check", "measures whether the outputs of a run keep their guarantees", {}, {}};
  verb.options = {{"folder", "OUT", "output folder of compile, with its manifest; OUT/scene.kiln means the same", false,
                   store_text(request->folder)},
                  {"--worst", "N", "writes a page with pictures of the N worst places of each kind, to -o", false,
                   store_whole(request->worst, 1)},
                  {"-o,--out", "FOLDER", "folder for the page of --worst: FOLDER/index.html", false,
                   store_text(request->page_folder)},
                  {"--edits-template", "FILE",
                   "writes a file for --edits of compile: each finding with the edit that would be the likely mend, as "
                   "comments",
                   false, store_text(request->template_path)},
                  threads_option(request->threads)};
  verb.examples = {"citykiln check out/town", "citykiln check out/town --worst 20 -o out/town-worst",
                   "citykiln check out/town --edits-template town.edits"};
  verb.interrupted = "the run is as before";
  verb.run = [request](const Console& console) { return run_check(*request, console); };
  return verb;
}

}  // namespace citykiln::commands
