#include "compiler/commands/compile_to_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "compiler/commands/interrupt_notice.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/outputs/run_report.h"
#include "compiler/outputs/texture_choice.h"
#include "compiler/outputs/write_outputs.h"
#include "compiler/verify/heights/heights_json.h"
#include "exporters/output_folder.h"
#include "exporters/run_files.h"

namespace citykiln::commands {
namespace {

// True for findings that are about the text of a tag or a rule, which says what to mend.
bool quotes_tags(Code code) {
  return code == Code::kBadTagValue || code == Code::kRuleErrors || code == Code::kThingRuleErrors;
}

// The tags of a finding, the most frequent first: ": roof:shape=glat (2), surface=ps"; "" for findings without tags.
std::string quoted_tags(const Report& report, Code code) {
  constexpr std::size_t kMostQuoted = 12;
  std::map<std::string, std::uint64_t> counts;
  for (const Diagnosis& diagnosis : report.diagnoses())
    if (diagnosis.code == code && !diagnosis.tag.empty()) ++counts[diagnosis.tag];
  std::vector<std::pair<std::string, std::uint64_t>> tags(counts.begin(), counts.end());
  std::ranges::stable_sort(tags, std::greater{}, &std::pair<std::string, std::uint64_t>::second);
  std::string text;
  for (const auto& [tag, count] : std::span(tags).first(std::min(tags.size(), kMostQuoted)))
    text += fmt::format("{}{}{}", text.empty() ? ": " : ", ", tag, count > 1 ? fmt::format(" ({})", count) : "");
  // a value may hold line breaks or codes of terminals
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  if (tags.size() > kMostQuoted)
    text += fmt::format(" and {} more in {}", tags.size() - kMostQuoted, exporters::kReportName);
  return text;
}

// Prints what is missing, then what was changed, the most frequent first; notes are one line.
void print_diagnoses(const Report& report, const Console& console) {
  std::vector<std::tuple<Severity, std::uint64_t, Code>> rows;
  std::uint64_t notes = 0;
  for (const auto& [code, count] : report.counts()) {
    if (severity_of(code) == Severity::kNote)
      notes += count;
    else
      rows.emplace_back(severity_of(code), count, code);
  }
  std::ranges::sort(rows, std::greater{});
  for (const auto& [severity, count, code] : rows)
    console.print_line(fmt::format("  {:>8} {:<8} {}: {}{}", count, name_of(severity), name_of(code), text_of(code),
                                   quotes_tags(code) ? quoted_tags(report, code) : ""));
  if (notes > 0)
    console.print_line(fmt::format("  {:>8} notes, in {} and report.json", notes, exporters::kFindingsName));
}

void print_compile_summary(const CompileSpec& spec, const CompileResult& compiled,
                           const outputs::WrittenOutputs& written, const std::vector<StageCost>& costs,
                           const exporters::FileList& files, const Console& console) {
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
  for (const std::string& note : outputs::notes_of(folder, written, files)) console.print_line(note);
  print_diagnoses(compiled.report, console);
}

}  // namespace

Result<Compiled> compile_to_folder(const CompileSpec& spec, const CompileMap& compile_map, const Console& console,
                                   exporters::TakesOver takes_over) {
  Result<exporters::OutputFolder> folder = exporters::OutputFolder::open(spec.outputs.folder, takes_over);
  if (!folder) return folder.error();
  // before a map is compiled in vain
  if (const auto sets = outputs::sets_of(spec.outputs); !sets) return sets.error();
  const InterruptNotice notice(kRunAsBefore);

  const OnProgress on_progress = console.progress();
  Result<CompileResult> compiled = compile_map(on_progress);
  if (!compiled) return compiled.error();
  const scene::Header& header = compiled->scene.header;

  // decided before baking, because objects that coarse levels leave out are not defects of the data
  const Exit exit = outputs::is_violated(spec.strict, compiled->report) ? Exit::kStrictViolation : Exit::kDone;
  std::vector<outputs::Finding> findings =
      outputs::findings_of(compiled->report, compiled->places, compiled->layer_tags, header);

  StageTimer timer(on_progress);
  timer.enter("bake and write");
  Result<outputs::WrittenOutputs> written = outputs::WrittenOutputs{};
  verify::HeightReport heights{{}, compiled->profiles};
  run_concurrently(
      spec.threads,
      [&] {
        written =
            outputs::write_outputs(compiled->scene, spec.outputs, spec.threads, *folder, compiled->report, on_progress);
      },
      [&] { heights.recipes = verify::measure_heights(compiled->scene, spec.threads); });
  if (!written) return written.error();
  heights.recipes.clearances = verify::with_findings(std::move(heights.recipes.clearances), findings);
  written->findings.insert(written->findings.begin(), findings.begin(), findings.end());
  std::vector<StageCost> costs = compiled->costs;
  for (StageCost& cost : timer.finish()) costs.push_back(std::move(cost));

  const std::string report = outputs::report_json(header, compiled->scene, compiled->report, written->files,
                                                  spec.outputs, verify::heights_json(heights));
  const std::string timing = outputs::timing_json(costs, spec.threads);
  if (const Result<Done> done = folder->write_varying(exporters::kTimingName, exporters::bytes_of(timing)); !done)
    return done.error();
  if (const Result<Done> done = outputs::commit_outputs(*written, report, header, *folder); !done) return done.error();

  print_compile_summary(spec, *compiled, *written, costs, folder->files(), console);
  console.print_json(report);
  return Compiled{exit, std::move(costs), written->files.bytes()};
}

std::string view_line(const std::string& folder) {
  return fmt::format("  citykiln view {}   shows it in a browser", folder);
}

}  // namespace citykiln::commands
