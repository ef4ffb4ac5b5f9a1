#include "compiler/commands/plan/task_lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "exporters/run_files.h"

namespace citykiln::commands {
namespace {

std::string build_ninja(const Plan& plan, const std::string& program) {
  const std::string quoted = ninja_command(shell_quoted(program));
  std::string text = fmt::format(
      "# Written by citykiln plan; run `ninja -C` with this folder.\n"
      "ninja_required_version = 1.5\n\n"
      "rule region\n  command = {0} compile --plan . --region $region --threads 1 --quiet\n"
      "  description = region $region\n  restat = 1\n\n"
      "rule gather\n  command = {0} gather .\n  description = gather\n\n",
      quoted);
  std::string states;
  for (const PlannedRegion& region : plan.regions) {
    const std::string name = to_string(region.key);
    text +=
        fmt::format("build state/{0}.json: region cut/{0}.osm.pbf | plan.json survey/{0}.kiln\n  region = {0}\n", name);
    states += fmt::format(" $\n  state/{}.json", name);
  }
  text += fmt::format("\nbuild out/{0}: gather{1}\ndefault out/{0}\n", exporters::kReportName, states);
  return text;
}

/// The factor by which a task may exceed its expected memory. None of 59 took more (expected_cost.cpp).
constexpr double kMemorySafety = 2;

/// Groups regions by the memory that they may need, in GB.
std::map<int, std::vector<const PlannedRegion*>> memory_classes(const Plan& plan) {
  std::map<int, std::vector<const PlannedRegion*>> classes;
  for (const PlannedRegion& region : plan.regions) {
    int gb = 1;
    while (gb * 1e9 < static_cast<double>(region.expected.memory_bytes) * kMemorySafety) gb *= 2;
    classes[gb].push_back(&region);
  }
  return classes;
}

std::string minutes_of(std::span<const PlannedRegion* const> regions) {
  double longest_s = 0;
  for (const PlannedRegion* region : regions) longest_s = std::max(longest_s, region->expected.seconds);
  return fmt::format("{}", static_cast<int>(std::ceil(longest_s * 4 / 60)) + 10);
}

/// The number of times that a killed task is repeated. A task that needs more memory than it has would be killed
/// forever.
constexpr int kMostRestarts = 3;

constexpr std::string_view kSubmitBegin =
    "#!/bin/sh\n"
    "# Written by citykiln plan: submits the tasks of this folder to Slurm. Options for all jobs, such as a "
    "partition,\n"
    "# are taken from the command line: ./submit.sh --partition=long\n"
    "set -eu\n"
    "cd \"$(dirname \"$0\")\"\n"
    "mkdir -p log\n"
    "jobs=\n"
    "# submit MEGABYTES MINUTES LIST FIRST COUNT OPTIONS…\n"
    "submit() {\n"
    "  memory=$1 minutes=$2 list=$3 first=$4 count=$5\n"
    "  shift 5\n"
    "  job=$(sbatch --parsable --requeue --open-mode=append --cpus-per-task=1 --mem=\"${memory}M\" --time=\"$minutes\" "
    "\\\n"
    "    --array=\"0-$((count - 1))\" --job-name=citykiln --output=log/%A_%a.txt \"$@\" task.sh \"$list\" \"$first\")\n"
    "  jobs=\"$jobs:${job%%;*}\"\n"
    "}\n";

std::string task_sh(const std::string& program) {
  return fmt::format(
      "#!/bin/sh\n"
      "# Written by citykiln plan: one task of a job array. task.sh LIST FIRST compiles the region in line FIRST plus\n"
      "# the task's number of LIST.\n"
      "region=$(sed -n \"$((SLURM_ARRAY_TASK_ID + $2))p\" \"$1\")\n"
      "status=0\n"
      "{} compile --plan . --region \"$region\" --threads 1 || status=$?\n"
      "# a killed task goes on with the tiles that it had written\n"
      "if [ \"$status\" -eq 137 ] && [ \"${{SLURM_RESTART_COUNT:-0}}\" -lt {} ]; then\n"
      "  scontrol requeue \"${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID\" || true\n"
      "fi\n"
      "exit \"$status\"\n",
      shell_quoted(program), kMostRestarts);
}

void add_slurm(const Plan& plan, const std::string& program, std::map<std::string, std::string>& files) {
  std::string submit(kSubmitBegin);
  for (const auto& [gb, regions] : memory_classes(plan)) {
    const std::string list = fmt::format("regions_{}GB.txt", gb);
    for (const PlannedRegion* region : regions) files[list] += to_string(region->key) + "\n";
    for (std::size_t first = 0; first < regions.size(); first += kLargestArray)
      submit += fmt::format("submit {} {} {} {} {} \"$@\"\n", gb * 1000, minutes_of(regions), list, first + 1,
                            std::min(kLargestArray, regions.size() - first));
  }
  submit += fmt::format(
      "sbatch --parsable --requeue --dependency=\"afterany$jobs\" --job-name=citykiln-gather --output=log/gather.txt "
      "\"$@\" "
      "gather.sh\n");
  files["submit.sh"] = submit;
  files["task.sh"] = task_sh(program);
  files["gather.sh"] = fmt::format("#!/bin/sh\nexec {} gather .\n", shell_quoted(program));
}

}  // namespace

std::string shell_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string ninja_command(const std::string& command) {
  std::string escaped;
  for (const char c : command) escaped += c == '$' ? std::string("$$") : std::string(1, c == '\n' ? ' ' : c);
  return escaped;
}

std::map<std::string, std::string> task_lists(const Plan& plan, const std::string& program) {
  std::map<std::string, std::string> files{{"build.ninja", build_ninja(plan, program)}};
  add_slurm(plan, program, files);
  return files;
}

}  // namespace citykiln::commands
