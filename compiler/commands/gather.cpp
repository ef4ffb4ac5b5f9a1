// citykiln gather PLAN: joins the outputs of all regions to one run, in PLAN/out.
//
// A region reports the elements that it owns (source/read_osm.cpp) and its own tiles. The survey reports facts that
// belong to no region, and the plan counts the elements of the extract. Thus each object is counted once, and the sums
// are those of a single run.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "compiler/commands/plan/gather_tileset.h"
#include "compiler/commands/plan/gather_usd.h"
#include "compiler/commands/plan/plan_file.h"
#include "compiler/commands/plan/region_state.h"
#include "compiler/commands/plan/zone_lists.h"
#include "compiler/commands/verb.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/outputs/findings.h"
#include "compiler/outputs/run_report.h"
#include "compiler/outputs/write_outputs.h"
#include "compiler/outputs/write_tiles3d.h"
#include "compiler/verify/check_seams.h"
#include "compiler/verify/heights/heights_json.h"
#include "exporters/file.h"
#include "exporters/file_list.h"
#include "exporters/gltf/glb.h"
#include "exporters/kiln/manifest.h"
#include "exporters/output_folder.h"
#include "exporters/run_files.h"
#include "exporters/usd/usd_names.h"

namespace citykiln::commands {
namespace {

namespace fs = std::filesystem;

/// A file of the run, and where a region has it.
struct PlacedFile {
  exporters::ListedFile file;
  std::string path;
};

/// The outputs of all regions.
struct Gathered {
  scene::Scene scene;
  outputs::WrittenFiles files;
  std::vector<outputs::Finding> findings;
  Report ledger;                             ///< The ledger, without diagnoses.
  std::vector<std::string> missing;          ///< One line per region that is not complete, with the reason.
  std::map<std::string, PlacedFile> placed;  ///< By name.
  std::vector<exporters::TilesetTile> tilesets;
  std::vector<exporters::UsdTile> usd_tiles;
};

/// Adds texts of rules or species that are not there yet.
template <typename Text>
void add_texts(const std::vector<Text>& more, std::vector<Text>& texts) {
  for (const Text& text : more)
    if (std::ranges::find(texts, text.name, &Text::name) == texts.end()) texts.push_back(text);
  std::ranges::sort(texts, {}, &Text::name);
}

/// Error: a region whose header differs from the others' in more than rules, species and things.
Result<Done> add_scene(const std::string& folder, const PlannedRegion& region, Gathered& all) {
  Result<scene::Scene> scene = exporters::read_manifest(folder + "/" + exporters::kManifestName, {});
  if (!scene) return scene.error();
  if (scene->chunks.size() != region.tiles)
    return Error{folder, fmt::format("has {} of {} tiles", scene->chunks.size(), region.tiles)};
  scene::Header& header = scene->header;
  if (all.scene.chunks.empty()) {
    all.scene.header = header;
  } else {
    scene::Header& whole = all.scene.header;
    add_texts(header.rules, whole.rules), add_texts(header.species, whole.species);
    add_texts(header.things, whole.things);
    header.rules = whole.rules, header.species = whole.species, header.things = whole.things;
    if (!(header == all.scene.header)) return Error{folder, "was compiled from another survey; compile it again"};
  }
  std::ranges::move(scene->chunks, std::back_inserter(all.scene.chunks));
  return Done{};
}

/// Returns the name that a file of a region has in the whole; empty if the whole writes its own. Several regions can
/// have contents of 3D Tiles with equal names, for parts of the same inner tile.
std::optional<std::string> name_in_whole(const std::string& name, const std::string& region) {
  static const std::set<std::string> kOwn = {exporters::kManifestName, exporters::kReportName,
                                             exporters::kFindingsName, exporters::kTimingName,
                                             exporters::kKeysName,     exporters::kUsdSceneName};
  static const std::string kTilesets = std::string(exporters::kTilesetFolder) + "/";
  if (kOwn.contains(name)) return std::nullopt;
  if (!name.starts_with(kTilesets)) return name;
  if (name.ends_with(".json")) return std::nullopt;
  return kTilesets + region + "/" + name.substr(kTilesets.size());
}

/// Files that regions have in common, such as clouds, count once. Error: a listed file that is missing or damaged.
Result<Done> add_files(const std::string& folder, const std::string& region, Gathered& all) {
  const auto list = exporters::read_file_list(folder + "/" + exporters::kFileListName);
  if (!list) return list.error();
  if (!*list) return Error{folder, "holds no finished run"};
  for (const exporters::ListedFile& file : **list) {
    if (!exporters::is_whole(folder, file)) return Error{folder + "/" + file.name, "is missing or damaged"};
    const std::optional<std::string> name = name_in_whole(file.name, region);
    if (!name) continue;
    PlacedFile placed{file, folder + "/" + file.name};
    placed.file.name = *name;
    all.placed.emplace(*name, std::move(placed));
  }
  return Done{};
}

Result<Done> add_findings(const std::string& path, Gathered& all) {
  const Result<std::vector<std::byte>> bytes = exporters::read_file(path);
  if (!bytes) return bytes.error();
  Result<std::vector<outputs::Finding>> findings =
      outputs::parse_findings({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
  if (!findings) return findings.error();
  std::ranges::move(*findings, std::back_inserter(all.findings));
  return Done{};
}

/// Adds the ledger of a region and its counts of assumptions, without the accounts of elements, which the plan counts:
/// regions do not have all elements.
void add_region_ledger(const Report& region, Gathered& all) {
  static const std::set<std::string> kOfPlan = {"source/node", "source/way", "source/relation", "edits/line"};
  Report own;
  for (const auto& [name, account] : region.ledger()) {
    const std::size_t slash = name.find('/');
    if (!kOfPlan.contains(name)) own.account(name.substr(0, slash), name.substr(slash + 1)) = account;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(Assumption::kCount); ++i)
    own.add_assumed(static_cast<Assumption>(i), region.assumed(static_cast<Assumption>(i)));
  all.ledger.append(own);
}

/// Reads the trees to which the roots of 3D Tiles and USD refer.
Result<Done> add_trees(const std::string& folder, const std::string& name, std::span<const scene::TileKey> own,
                       const Outputs& outputs, Gathered& all) {
  if (outputs.tiles3d) {
    Result<exporters::TilesetTile> tree = read_region_tileset(folder + "/" + exporters::kTilesetFolder, name + "/");
    if (!tree) return tree.error();
    all.tilesets.push_back(std::move(*tree));
  }
  if (outputs.usd) {
    Result<std::vector<exporters::UsdTile>> tiles = read_usd_tiles(folder + "/" + exporters::kUsdSceneName, own);
    if (!tiles) return tiles.error();
    std::ranges::move(*tiles, std::back_inserter(all.usd_tiles));
  }
  return Done{};
}

Result<Done> add_region(const Plan& plan, const PlannedRegion& region, const std::string& plan_folder,
                        const Outputs& outputs, Gathered& all) {
  const RegionState state = read_state(plan_folder, region.key);
  if (state.state == TaskState::kFailed) return Error{"", "failed: " + state.error};
  if (state.state != TaskState::kDone) return Error{"", std::string(name_of(state.state))};
  const std::string folder = outputs_path(plan_folder, region.key);
  const Result<outputs::RunRecord> record = outputs::read_report(folder);
  if (!record) return record.error();
  if (Result<Done> done = add_files(folder, to_string(region.key), all); !done) return done;
  if (Result<Done> done = add_scene(folder, region, all); !done) return done;
  if (Result<Done> done = add_findings(folder + "/" + exporters::kFindingsName, all); !done) return done;
  const std::vector<scene::TileKey> own = regions::tiles_of(plan.grid, region.key);
  if (Result<Done> done = add_trees(folder, to_string(region.key), own, outputs, all); !done) return done;
  add_region_ledger(record->ledger, all);
  std::ranges::copy(record->usd, std::back_inserter(all.files.usd));
  std::ranges::copy(record->tiles, std::back_inserter(all.files.tiles));
  return Done{};
}

Gathered gather_regions(const Plan& plan, const std::string& plan_folder, const Outputs& outputs,
                        const OnProgress& on_progress) {
  Gathered all;
  all.ledger = plan.elements;
  if (const Result<Done> added = add_findings(survey_findings_path(plan_folder), all); !added)
    all.missing.push_back("the survey: " + to_string(added.error()));
  for (std::size_t i = 0; i < plan.regions.size(); ++i) {
    on_progress("gather", static_cast<double>(i) / static_cast<double>(plan.regions.size()));
    const Result<Done> added = add_region(plan, plan.regions[i], plan_folder, outputs, all);
    if (!added)
      all.missing.push_back(fmt::format("region {}: {}", to_string(plan.regions[i].key), to_string(added.error())));
  }
  std::ranges::sort(all.scene.chunks, {}, &scene::Chunk::tile);
  const auto key = [](const outputs::WrittenTile& t) { return std::pair(t.tile, t.level); };
  std::ranges::sort(all.files.tiles, {}, key);
  std::ranges::sort(all.files.usd, {}, key);
  std::ranges::sort(all.usd_tiles, {}, &exporters::UsdTile::tile);
  return all;
}

Report report_of(const Gathered& all) {
  Report report = all.ledger;
  for (const outputs::Finding& finding : all.findings) report.add(finding.diagnosis);
  return report;
}

/// True if a neighbouring tile belongs to another region.
bool is_at_side(const regions::RegionGrid& grid, scene::TileKey tile) {
  const auto across = static_cast<std::int32_t>(grid.region_m / grid.tile_m);
  const auto is_outermost = [&](std::int32_t v) {
    const std::int32_t within = ((v % across) + across) % across;
    return within == 0 || within == across - 1;
  };
  return is_outermost(tile.x) || is_outermost(tile.y);
}

/// Compares the tiles at the sides of regions with their neighbours. Error: a tile that cannot be read, or one that
/// does not fit; the error names the first and the console all.
Result<Done> check_sides(const Plan& plan, const Gathered& all, const std::string& plan_folder, int threads,
                         const Console& console) {
  std::vector<const outputs::WrittenTile*> tiles;
  for (const outputs::WrittenTile& tile : all.files.tiles)
    if (is_at_side(plan.grid, tile.tile)) tiles.push_back(&tile);
  const auto read = for_each_slot<std::optional<Result<verify::Borders>>>(
      tiles.size(), threads, [&](std::size_t i) -> std::optional<Result<verify::Borders>> {
        const Result<bake::BakedTile> tile = exporters::read_glb(all.placed.at(tiles[i]->file.name).path);
        if (!tile) return Result<verify::Borders>(tile.error());
        return Result<verify::Borders>(verify::borders_of(*tile, scene::box_of(all.scene.header, tiles[i]->tile)));
      });
  verify::BordersByTile borders;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    if (!*read[i]) return read[i]->error();
    borders[{tiles[i]->level, tiles[i]->tile}] = **read[i];
  }
  verify::Check seams{"tiles of neighbouring regions have the same border edges", 0, {}};
  verify::check_seams(borders, seams);
  for (const verify::Failure& failure : seams.failures) console.print_line("seam: " + failure.text);
  if (!seams.failures.empty())
    return Error{plan_folder, fmt::format("{} of {} borders of tiles do not fit, first of {}", seams.failures.size(),
                                          seams.tests, seams.failures.front().text)};
  return Done{};
}

/// The roots of 3D Tiles and USD.
Result<Done> write_roots(Gathered& all, const Outputs& outputs, exporters::OutputFolder& folder) {
  const auto write = [&](const std::string& name, std::span<const std::byte> bytes) {
    all.files.files.push_back({name, bytes.size()});
    return folder.write(name, bytes);
  };
  if (!all.usd_tiles.empty()) {
    const std::vector<std::byte> scene = exporters::encode_scene(all.usd_tiles, all.scene.header);
    if (Result<Done> done = write(exporters::kUsdSceneName, scene); !done) return done;
  }
  if (all.tilesets.empty()) return Done{};
  const Result<map::Geoid> geoid = outputs::geoid_of(all.scene.header, outputs);
  if (!geoid) return geoid.error();
  const exporters::TilesetFacts facts = outputs::tileset_facts(all.scene.header, outputs, *geoid);
  for (const exporters::TilesetFile& file : exporters::encode_tileset(joined_trees(std::move(all.tilesets)), facts))
    if (Result<Done> done = write(file.name, exporters::bytes_of(file.json)); !done) return done;
  return Done{};
}

/// The land around the whole, as a single run writes it for .glb.
Result<Done> write_land_around(Gathered& all, const CompileSpec& spec, exporters::OutputFolder& folder) {
  if (!spec.outputs.glb || spec.outputs.surroundings == AroundWish::kNo) return Done{};
  const auto file = outputs::write_glb_surroundings(all.scene, spec.outputs, spec.threads, folder);
  if (!file) return file.error();
  if (*file) all.files.files.push_back(**file);
  return Done{};
}

/// Takes over the files of the regions.
Result<Done> adopt_placed(Gathered& all, exporters::OutputFolder& folder, const OnProgress& on_progress) {
  std::set<std::string> tiles;
  for (const outputs::WrittenTile& tile : all.files.tiles) tiles.insert(tile.file.name);
  for (const outputs::WrittenTile& tile : all.files.usd) tiles.insert(tile.file.name);
  std::size_t adopted = 0;
  for (const auto& [name, placed] : all.placed) {
    on_progress("take over files", static_cast<double>(adopted++) / static_cast<double>(all.placed.size()));
    if (Result<Done> done = folder.adopt(placed.file, placed.path); !done) return done;
    if (!tiles.contains(name)) all.files.files.push_back({name, placed.file.bytes});
  }
  return Done{};
}

Result<Done> write_out(Gathered& all, const CompileSpec& spec, const std::string& path, const OnProgress& on_progress) {
  Result<exporters::OutputFolder> folder = exporters::OutputFolder::open(path);
  if (!folder) return folder.error();
  const InterruptNotice notice(kRunAsBefore);
  on_progress("write the manifest", 0);
  const std::vector<std::byte> manifest = exporters::encode_manifest(all.scene, spec.threads);
  if (Result<Done> done = exporters::check_header(manifest, exporters::kManifestName); !done) return done;
  if (Result<Done> done = folder->write(exporters::kManifestName, manifest); !done) return done;
  all.files.files.push_back({exporters::kManifestName, manifest.size()});
  if (Result<Done> done = adopt_placed(all, *folder, on_progress); !done) return done;
  on_progress("write the whole", 0);
  if (Result<Done> done = write_roots(all, spec.outputs, *folder); !done) return done;
  if (Result<Done> done = write_land_around(all, spec, *folder); !done) return done;
  verify::HeightReport heights{verify::measure_heights(all.scene, spec.threads), {}};
  heights.recipes.clearances = verify::with_findings(std::move(heights.recipes.clearances), all.findings);
  const std::string report = outputs::report_json(all.scene.header, all.scene, report_of(all), all.files, spec.outputs,
                                                  verify::heights_json(heights));
  outputs::WrittenOutputs written{.files = all.files, .findings = all.findings, .solved = {}};
  return outputs::commit_outputs(written, report, all.scene.header, *folder);
}

Result<Exit> gather(const std::string& plan_folder, const Console& console) {
  const std::string folder = fs::absolute(plan_folder).lexically_normal().string();
  const Result<Plan> plan = read_plan(folder);
  if (!plan) return plan.error();
  std::error_code problem;
  fs::current_path(plan->working_folder, problem);
  const Result<CompileRequest> request = request_of(*plan);
  if (!request) return request.error();
  const Result<CompileSpec> spec = spec_of(*request);
  if (!spec) return spec.error();
  const OnProgress on_progress = console.progress();
  Gathered all = gather_regions(*plan, folder, spec->outputs, on_progress);
  for (const std::string& line : all.missing) console.print_line("missing: " + line);
  if (!all.missing.empty())
    return Error{plan_folder, fmt::format("{} of {} regions are not whole, first {}", all.missing.size(),
                                          plan->regions.size(), all.missing.front())};
  on_progress("check borders", 0);
  if (const Result<Done> done = check_sides(*plan, all, plan_folder, spec->threads, console); !done)
    return done.error();
  if (const Result<Done> done = write_out(all, *spec, folder + "/out", on_progress); !done) return done.error();
  console.print_line(fmt::format("{}/out: {} regions, {} tiles, {:.1f} MB", plan_folder, plan->regions.size(),
                                 all.scene.chunks.size(), all.files.bytes() * 1e-6));
  return Exit::kDone;
}

}  // namespace

Verb gather_verb() {
  const auto plan = std::make_shared<std::string>();
  Verb verb{"gather", "makes one run of the outputs of all regions of a plan, in PLAN/out", {}, {}};
  verb.options = {{"plan", "PLAN", "folder of a plan", false, store_text(*plan)}};
  verb.examples = {"citykiln gather out/plan"};
  verb.run = [plan](const Console& console) -> Result<Exit> {
    if (plan->empty()) return Error{"", "no plan is given; expected the folder of a plan"};
    // gather() moves to the folder where the plan was made
    std::error_code problem;
    const fs::path folder = fs::weakly_canonical(fs::absolute(*plan), problem);
    return for_each_zone(folder.string(), [&](const std::string& of_zone) { return gather(of_zone, console); });
  };
  return verb;
}

}  // namespace citykiln::commands
