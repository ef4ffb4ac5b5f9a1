// citykiln compile MAP … -o FOLDER: compiles a map to a manifest and bakes its tiles.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "compiler/commands/interrupt_notice.h"
#include "compiler/commands/verb.h"
#include "compiler/commands/write_outputs.h"
#include "compiler/contract/for_each_slot.h"
#include "compiler/pipeline.h"
#include "compiler/verify/run_report.h"
#include "exporters/output_folder.h"

namespace citykiln::commands {
namespace {

/// The command line: a file of settings, and settings that override the file.
struct Request {
  std::string spec_path;
  std::vector<std::pair<const Setting*, std::string>> given;
};

Result<CompileSpec> spec_of(const Request& request) {
  CompileSpec spec;
  if (!request.spec_path.empty()) {
    Result<CompileSpec> read = read_spec(request.spec_path);
    if (!read) return read;
    spec = std::move(*read);
  }
  for (const auto& [setting, text] : request.given) {
    const Result<Done> done = apply(*setting, text, spec);
    if (!done) return Error{"--" + std::string(setting->name), to_string(done.error())};
  }
  if (const Result<Done> complete = is_complete(spec); !complete) return complete.error();
  return spec;
}

void print_summary(const CompileSpec& spec, const CompileResult& compiled, const WrittenOutputs& written,
                   const std::vector<StageCost>& costs, const exporters::FileList& files, const Console& console) {
  double seconds = 0;
  std::uint64_t peak_bytes = 0;
  for (const StageCost& cost : costs) {
    seconds += cost.seconds;
    peak_bytes = std::max(peak_bytes, cost.peak_bytes);
  }
  const std::string& folder = spec.outputs.folder;
  console.print_line(fmt::format("{}: {} tiles, {} files, {:.1f} MB, in {:.1f} s and {:.0f} MB of memory", folder,
                                 compiled.scene.chunks.size(), files.size() + 1, written.files.bytes() * 1e-6, seconds,
                                 peak_bytes * 1e-6));
  print_notes(folder, written, files, console);
  for (const auto& [code, count] : compiled.report.counts()) {
    console.print_line(
        fmt::format("  {:>8} {:<8} {}: {}", count, name_of(severity_of(code)), name_of(code), text_of(code)));
  }
}

Result<Exit> compile_to_folder(const CompileSpec& spec, const Console& console) {
  Result<exporters::OutputFolder> folder = exporters::OutputFolder::open(spec.outputs.folder);
  if (!folder) return folder.error();
  const InterruptNotice notice;

  const OnProgress on_progress = console.progress();
  Result<CompileResult> compiled = compile(spec, on_progress);
  if (!compiled) return compiled.error();
  const scene::Header& header = compiled->scene.header;

  // decided before baking, because objects left out at coarse levels are no defects of the data
  const Exit exit = verify::is_violated(spec.strict, compiled->report) ? Exit::kStrictViolation : Exit::kDone;
  std::vector<verify::Finding> findings = verify::findings_of(compiled->report, compiled->places, header);

  StageTimer timer(on_progress);
  timer.enter("bake and write");
  Result<WrittenOutputs> written = WrittenOutputs{};
  verify::HeightReport heights{{}, compiled->profiles};
  run_concurrently(
      spec.threads,
      [&] {
        written = write_outputs(compiled->scene, spec.outputs, spec.threads, *folder, compiled->report, on_progress);
      },
      [&] { heights.recipes = verify::measure_heights(compiled->scene, spec.threads); });
  if (!written) return written.error();
  written->findings.insert(written->findings.begin(), findings.begin(), findings.end());
  std::vector<StageCost> costs = compiled->costs;
  for (StageCost& cost : timer.finish()) costs.push_back(std::move(cost));

  const std::string report =
      verify::report_json(header, compiled->scene, compiled->report, written->files, spec.outputs, heights);
  const std::string timing = verify::timing_json(costs, spec.threads);
  if (const Result<Done> done = folder->write_varying("timing.json", exporters::bytes_of(timing)); !done)
    return done.error();
  if (const Result<Done> done = commit_outputs(*written, report, header, *folder); !done) return done.error();

  print_summary(spec, *compiled, *written, costs, folder->files(), console);
  console.print_json(report);
  return exit;
}

bool is_map_file(std::string_view path) {
  constexpr std::string_view kSuffixes[] = {".osm", ".osm.gz", ".osm.bz2", ".osm.pbf", ".pbf"};
  return std::ranges::any_of(kSuffixes, [&](std::string_view suffix) { return path.ends_with(suffix); });
}

Result<Done> give(Request& request, const Setting& setting, const std::string& text) {
  request.given.emplace_back(&setting, text);
  return Done{};
}

/// A map among the files after --dem: the map may stand last on the command line.
Result<Done> give_map(Request& request, const std::string& text) {
  for (const auto& [setting, path] : request.given)
    if (setting->name == "map") return Error{"--dem", fmt::format("found a second map, {}, after {}", text, path)};
  return give(request, *std::ranges::find(settings(), "map", &Setting::name), text);
}

Option option_of(const Setting& setting, Request& request) {
  const bool is_dem = setting.name == "dem";
  std::string flags = "--" + std::string(setting.name);
  if (setting.name == "map") flags = "map";
  if (setting.name == "out") flags = "-o,--out";
  return {flags,
          std::string(setting.value),
          std::string(setting.help),
          setting.repeats,
          [&request, &setting, is_dem](const std::string& text) {
            return is_dem && is_map_file(text) ? give_map(request, text) : give(request, setting, text);
          },
          is_dem};
}

}  // namespace

Verb compile_verb() {
  const auto request = std::make_shared<Request>();
  Verb verb{"compile", "compiles a map to a manifest and bakes its tiles", {}, {}};
  for (const Setting& setting : settings()) verb.options.push_back(option_of(setting, *request));
  verb.options.push_back({"--spec", "FILE",
                          "JSON file of settings, such as {\"tile\": 512}; settings on the command line override it",
                          false, store_text(request->spec_path)});
  verb.examples = {"citykiln compile monaco.osm.pbf --dem N43E007.hgt -o out/monaco",
                   "citykiln compile monaco.osm.pbf --bbox 7.415,43.73,7.43,43.745 --lods 0.1,0.5 -o out/centre",
                   "citykiln compile --spec examples/town/spec.json -o out/town"};
  verb.run = [request](const Console& console) -> Result<Exit> {
    const Result<CompileSpec> spec = spec_of(*request);
    if (!spec) return spec.error();
    return compile_to_folder(*spec, console);
  };
  return verb;
}

}  // namespace citykiln::commands
