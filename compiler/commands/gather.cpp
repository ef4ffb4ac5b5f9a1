// citykiln gather PLAN: makes one run of the outputs of all regions, in PLAN/out.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <set>

#include "compiler/commands/plan_file.h"
#include "compiler/commands/region_state.h"
#include "compiler/commands/verb.h"
#include "compiler/commands/write_outputs.h"
#include "compiler/verify/findings.h"
#include "compiler/verify/measure_heights.h"
#include "compiler/verify/run_report.h"
#include "exporters/file.h"
#include "exporters/file_list.h"
#include "exporters/kiln/manifest.h"
#include "exporters/output_folder.h"

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
  verify::WrittenFiles files;
  std::vector<verify::Finding> findings;
  std::vector<std::string> missing;          ///< One line for each region that is not whole, and why.
  std::map<std::string, PlacedFile> placed;  ///< By name.
};

/// Adds texts of rules or species that are not there yet.
template <typename Text>
void add_texts(const std::vector<Text>& more, std::vector<Text>& texts) {
  for (const Text& text : more)
    if (std::ranges::find(texts, text.name, &Text::name) == texts.end()) texts.push_back(text);
  std::ranges::sort(texts, {}, &Text::name);
}

/// Error: a region whose header differs from the others' in more than rules and species.
Result<Done> add_scene(const std::string& folder, const PlannedRegion& region, Gathered& all) {
  Result<scene::Scene> scene = exporters::read_manifest(folder + "/scene.kiln", {});
  if (!scene) return scene.error();
  if (scene->chunks.size() != region.tiles)
    return Error{folder, fmt::format("has {} of {} tiles", scene->chunks.size(), region.tiles)};
  scene::Header& header = scene->header;
  if (all.scene.chunks.empty()) {
    all.scene.header = header;
  } else {
    add_texts(header.rules, all.scene.header.rules), add_texts(header.species, all.scene.header.species);
    header.rules = all.scene.header.rules, header.species = all.scene.header.species;
    if (!(header == all.scene.header)) return Error{folder, "was compiled from another survey; compile it again"};
  }
  std::ranges::move(scene->chunks, std::back_inserter(all.scene.chunks));
  return Done{};
}

/// Files that regions have in common, such as clouds, count once. Error: a listed file that is missing or damaged.
Result<Done> add_files(const std::string& folder, Gathered& all) {
  const auto list = exporters::read_file_list(folder + "/" + exporters::kFileListName);
  if (!list) return list.error();
  if (!*list) return Error{folder, "holds no finished run"};
  static const std::set<std::string> kOwn = {"scene.kiln", "report.json", "findings.json", "timing.json",
                                             exporters::kKeysName};
  for (const exporters::ListedFile& file : **list) {
    if (!exporters::is_whole(folder, file)) return Error{folder + "/" + file.name, "is missing or damaged"};
    if (!kOwn.contains(file.name)) all.placed.emplace(file.name, PlacedFile{file, folder + "/" + file.name});
  }
  return Done{};
}

/// A finding belongs to the region of its tile; those without a tile are the same in all regions, or of a halo.
Result<Done> add_findings(const std::string& folder, const std::vector<scene::TileKey>& own, Gathered& all) {
  const Result<std::vector<std::byte>> bytes = exporters::read_file(folder + "/findings.json");
  if (!bytes) return bytes.error();
  Result<std::vector<verify::Finding>> findings =
      verify::parse_findings({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
  if (!findings) return findings.error();
  for (verify::Finding& finding : *findings)
    if (finding.tile && std::ranges::binary_search(own, *finding.tile)) all.findings.push_back(std::move(finding));
  return Done{};
}

Result<Done> add_region(const Plan& plan, const PlannedRegion& region, const std::string& plan_folder, Gathered& all) {
  const RegionState state = read_state(plan_folder, region.key);
  if (state.state == TaskState::kFailed) return Error{"", "failed: " + state.error};
  if (state.state != TaskState::kDone) return Error{"", std::string(name_of(state.state))};
  const std::string folder = outputs_path(plan_folder, region.key);
  const Result<verify::RunRecord> record = verify::read_report(folder);
  if (!record) return record.error();
  if (Result<Done> done = add_files(folder, all); !done) return done;
  if (Result<Done> done = add_scene(folder, region, all); !done) return done;
  if (Result<Done> done = add_findings(folder, regions::tiles_of(plan.grid, region.key), all); !done) return done;
  std::ranges::copy(record->tiles, std::back_inserter(all.files.tiles));
  return Done{};
}

Gathered gather_regions(const Plan& plan, const std::string& plan_folder, const OnProgress& on_progress) {
  Gathered all;
  for (std::size_t i = 0; i < plan.regions.size(); ++i) {
    on_progress("gather", static_cast<double>(i) / static_cast<double>(plan.regions.size()));
    const Result<Done> added = add_region(plan, plan.regions[i], plan_folder, all);
    if (!added)
      all.missing.push_back(fmt::format("region {}: {}", to_string(plan.regions[i].key), to_string(added.error())));
  }
  std::ranges::sort(all.scene.chunks, {}, &scene::Chunk::tile);
  std::ranges::sort(all.files.tiles, {}, [](const verify::WrittenTile& t) { return std::pair(t.tile, t.level); });
  return all;
}

/// The diagnoses of the findings, and a ledger of tiles.
Report report_of(const Plan& plan, const Gathered& all, std::size_t levels) {
  Report report;
  for (const verify::Finding& finding : all.findings) report.add(finding.diagnosis);
  Account& account = report.account("gather", "tile");
  for (const PlannedRegion& region : plan.regions) account.in += region.tiles;
  account.split = account.in * (levels - 1);
  account.out = all.files.tiles.size();
  return report;
}

Result<Done> write_out(const Plan& plan, Gathered& all, const CompileSpec& spec, const std::string& path) {
  Result<exporters::OutputFolder> folder = exporters::OutputFolder::open(path);
  if (!folder) return folder.error();
  const std::vector<std::byte> manifest = exporters::encode_manifest(all.scene, spec.threads);
  if (Result<Done> done = folder->write("scene.kiln", manifest); !done) return done;
  all.files.files.push_back({"scene.kiln", manifest.size()});
  std::set<std::string> tiles;
  for (const verify::WrittenTile& tile : all.files.tiles) tiles.insert(tile.file.name);
  for (const auto& [name, placed] : all.placed) {
    if (Result<Done> done = folder->adopt(placed.file, placed.path); !done) return done;
    if (!tiles.contains(name)) all.files.files.push_back({name, placed.file.bytes});
  }
  verify::HeightReport heights{verify::measure_heights(all.scene, spec.threads), {}};
  heights.recipes.clearances = verify::explained(std::move(heights.recipes.clearances), all.findings);
  const bool is_solved = spec.outputs.max_bytes || spec.outputs.max_triangles;
  const std::size_t levels = is_solved ? 1 : spec.outputs.ladder_m.size();
  const std::string report =
      verify::report_json(all.scene.header, all.scene, report_of(plan, all, levels), all.files, spec.outputs, heights);
  WrittenOutputs written{.files = all.files, .findings = all.findings, .solved = {}};
  return commit_outputs(written, report, all.scene.header, *folder);
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
  Gathered all = gather_regions(*plan, folder, console.progress());
  for (const std::string& line : all.missing) console.print_line("missing: " + line);
  if (!all.missing.empty())
    return Error{plan_folder, fmt::format("{} of {} regions are not whole, first {}", all.missing.size(),
                                          plan->regions.size(), all.missing.front())};
  if (const Result<Done> done = write_out(*plan, all, *spec, folder + "/out"); !done) return done.error();
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
    return gather(*plan, console);
  };
  return verb;
}

}  // namespace citykiln::commands
