#include "compiler/commands/plan/compile_region.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "compiler/commands/compile_to_folder.h"
#include "compiler/commands/plan/region_state.h"
#include "compiler/commands/plan/survey_file.h"
#include "compiler/outputs/bake_keys.h"
#include "compiler/pipeline.h"
#include "exporters/content_hash.h"
#include "exporters/file.h"
#include "exporters/file_list.h"
#include "exporters/finish_commit.h"
#include "exporters/run_files.h"

namespace citykiln::commands {
namespace {

namespace fs = std::filesystem;

/// The settings of the plan for one region, with the threads asked for.
Result<CompileSpec> spec_for(const Plan& plan, const PlannedRegion& region, const std::string& plan_folder,
                             const CompileRequest& own) {
  Result<CompileRequest> request = request_of(plan);
  if (!request) return request.error();
  for (const auto& [setting, text] : own.given) {
    if (setting->name != "threads")
      return Error{"--" + std::string(setting->name), "is a setting of the plan; give it to citykiln plan"};
    request->given.emplace_back(setting, text);
  }
  Result<CompileSpec> spec = spec_of(*request);
  if (!spec) return spec;
  spec->only = regions::tiles_of(plan.grid, region.key);
  spec->outputs.folder = outputs_path(plan_folder, region.key);
  // gather writes the land around the whole
  spec->outputs.surroundings = AroundWish::kNo;
  return spec;
}

/// Returns a hash of all inputs of a region's outputs: settings, data, survey and program.
Result<std::string> region_key(const Plan& plan, const PlannedRegion& region, const std::string& plan_folder,
                               std::uint64_t survey_hash) {
  const Result<std::vector<std::byte>> data = exporters::read_file(cut_path(plan_folder, region.key));
  if (!data) return data.error();
  std::string settings;
  for (const auto& [name, value] : plan.settings)
    if (name != "threads" && name != "out") settings += fmt::format("{}={}\n", name, value);
  if (!plan.spec_path.empty()) {
    const Result<std::vector<std::byte>> spec = exporters::read_file(plan.spec_path);
    if (!spec) return spec.error();
    settings += exporters::hash_text(exporters::content_hash(*spec));
  }
  return exporters::hash_text(
      exporters::content_hash(fmt::format("{} {} {} {} {} {}", settings, plan.grid.region_m, plan.grid.halo_m,
                                          exporters::content_hash(*data), survey_hash, outputs::program_hash())));
}

/// Error: the file of edits is another than when the map was cut.
Result<Done> has_edits_of(const CompileSpec& spec, const scene::Header& header) {
  if (!spec.edits) return Done{};
  const std::string text = edits::source_text(*spec.edits);
  if (std::ranges::find(header.sources, text) != header.sources.end()) return Done{};
  return Error{spec.edits->name, "has changed since the plan was made; make the plan again"};
}

/// True if the files of a finished run exist, with their sizes.
bool has_outputs(const std::string& folder) {
  if (const Result<Done> done = exporters::finish_commit(folder); !done) return false;
  const auto list = exporters::read_file_list(folder + "/" + exporters::kFileListName);
  if (!list || !*list) return false;
  return std::ranges::all_of(**list, [&](const exporters::ListedFile& file) {
    std::error_code problem;
    const std::uintmax_t size = fs::file_size(folder + "/" + file.name, problem);
    return !problem && (file.hash.empty() || size == file.bytes);
  });
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

Result<Exit> compile_unless_done(const Plan& plan, const PlannedRegion& region, const std::string& plan_folder,
                                 const CompileRequest& own, RegionState& state, const Console& console) {
  const auto begin = std::chrono::steady_clock::now();
  const Result<CompileSpec> spec = spec_for(plan, region, plan_folder, own);
  if (!spec) return spec.error();
  const Result<RegionSurvey> surveyed = read_survey(plan_folder, plan, region.key);
  if (!surveyed) return surveyed.error();
  if (const Result<Done> same = has_edits_of(*spec, surveyed->survey.header); !same) return same.error();
  const Result<std::string> key = region_key(plan, region, plan_folder, surveyed->hash);
  if (!key) return key.error();
  lock_until_exit(plan_folder, region.key);
  state = read_state(plan_folder, region.key);
  if (state.state == TaskState::kDone && state.key == *key && has_outputs(spec->outputs.folder)) {
    console.print_line(
        fmt::format("region {}: done already with the same inputs by this program", to_string(region.key)));
    return Exit::kDone;
  }
  state = RegionState{};
  state.state = TaskState::kRunning, state.key = *key;
  if (const Result<Done> done = write_state(plan_folder, region.key, state); !done) return done.error();
  const map::Plane plane(surveyed->survey.header.origin);
  const auto compile_map = [&](const OnProgress& on_progress) {
    return citykiln::compile_region(*spec, cut_path(plan_folder, region.key), surveyed->survey,
                                    owned_places(plan, plane, region.key), on_progress);
  };
  // after an edit of the map, most tiles are those of the run before
  const Result<Compiled> compiled = compile_to_folder(*spec, compile_map, console, exporters::TakesOver::kFinished);
  if (!compiled) return compiled.error();
  state.state = TaskState::kDone, state.seconds = seconds_since(begin), state.output_bytes = compiled->bytes;
  for (const StageCost& cost : compiled->costs) state.memory_bytes = std::max(state.memory_bytes, cost.peak_bytes);
  if (const Result<Done> done = write_state(plan_folder, region.key, state); !done) return done.error();
  return compiled->exit;
}

}  // namespace

Result<Exit> compile_region(const std::string& plan_folder, const std::string& region, const CompileRequest& own,
                            const Console& console) {
  const std::string folder = fs::absolute(plan_folder).lexically_normal().string();
  const Result<Plan> plan = read_plan(folder);
  if (!plan) return plan.error();
  const Result<PlannedRegion> planned = region_named(*plan, region);
  if (!planned) return planned.error();
  std::error_code problem;
  fs::current_path(plan->working_folder, problem);
  RegionState state;
  const Result<Exit> exit = compile_unless_done(*plan, *planned, folder, own, state, console);
  if (exit) return exit;
  state.state = TaskState::kFailed, state.error = to_string(exit.error());
  static_cast<void>(write_state(folder, planned->key, state));
  return exit;
}

}  // namespace citykiln::commands
