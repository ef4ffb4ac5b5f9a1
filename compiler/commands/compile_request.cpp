#include "compiler/commands/compile_request.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/commands/run_paths.h"

namespace citykiln::commands {
namespace {

Result<Done> give(CompileRequest& request, const Setting& setting, const std::string& text) {
  request.given.emplace_back(&setting, text);
  return Done{};
}

/// Takes a map among the files after --dem, since the map may be last on the command line.
Result<Done> give_map(CompileRequest& request, const std::string& text) {
  for (const auto& [setting, path] : request.given)
    if (setting->name == "map") return Error{"--dem", fmt::format("found a second map, {}, after {}", text, path)};
  return give(request, *std::ranges::find(settings(), "map", &Setting::name), text);
}

Option option_of(const Setting& setting, CompileRequest& request) {
  const bool is_dem = setting.name == "dem";
  std::string flags = "--" + std::string(setting.name);
  if (setting.name == "map") flags = "map";
  if (setting.name == "out") flags = "-o,--out";
  return {flags,
          std::string(setting.value),
          help_of(setting),
          setting.repeats,
          [&request, &setting, is_dem](const std::string& text) {
            return is_dem && is_map_name(text) ? give_map(request, text) : give(request, setting, text);
          },
          is_dem};
}

}  // namespace

std::vector<Option> options_of(CompileRequest& request) {
  std::vector<Option> options;
  for (const Setting& setting : settings()) options.push_back(option_of(setting, request));
  options.push_back({"--spec", "FILE",
                     "JSON file of settings, such as {\"tile\": 512}; settings on the command line override it", false,
                     store_text(request.spec_path)});
  return options;
}

Result<CompileSpec> spec_of(const CompileRequest& request) {
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
  return spec;
}

}  // namespace citykiln::commands
