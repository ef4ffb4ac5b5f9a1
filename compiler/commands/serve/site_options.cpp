#include "compiler/commands/serve/site_options.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "compiler/commands/run_paths.h"
#include "compiler/commands/view/load_cells.h"
#include "compiler/settings.h"
#include "exporters/finish_commit.h"

namespace citykiln::commands {
namespace {

/// The settings of tiles that are baked on request.
constexpr std::array<std::string_view, 10> kSettings = {"lods",      "lights",       "compress", "geoid-height",
                                                        "materials", "surroundings", "layers",   "wood-density",
                                                        "lamps",     "lit-windows"};

}  // namespace

std::vector<Option> site_options(SiteChoices& choices) {
  std::vector<Option> options = {
      {"run", "SCENE.kiln|OUT", "a manifest, or the folder of a run; tiles that it lacks are baked when asked for",
       false, store_text(choices.path)},
      {"--cache", "SIZE", "memory for tiles that were baked, such as 2GB (default: 512MB)", false,
       store_bytes(choices.cache_bytes)}};
  for (const Setting& setting : settings()) {
    if (std::ranges::find(kSettings, setting.name) == kSettings.end()) continue;
    options.push_back({"--" + std::string(setting.name), std::string(setting.value),
                       "for tiles that are baked: as for compile", setting.repeats,
                       [&choices, &setting](const std::string& text) { return apply(setting, text, choices.spec); }});
  }
  options.push_back(threads_option(choices.spec.threads));
  return options;
}

Result<SiteRequest> site_request(const SiteChoices& choices, bool has_page) {
  if (choices.path.empty())
    return Error{"",
                 "nothing to show is given; expected a manifest such as out/town/scene.kiln, or the folder of a run"};
  if (const Result<Done> fits = check_run_path(choices.path); !fits) return fits.error();
  std::error_code none;
  SiteRequest request{.path = choices.path,
                      .outputs = choices.spec.outputs,
                      .shown = choices.spec.shown,
                      .has_page = has_page,
                      .cache_bytes = choices.cache_bytes,
                      .threads = choices.spec.threads};
  if (std::filesystem::is_directory(request.path, none)) {
    if (const Result<Done> done = exporters::finish_commit(request.path); !done) return done.error();
  } else if (!request.path.ends_with(".kiln")) {
    return Error{request.path, "expected a manifest (.kiln) or the folder of a run"};
  }
  return request;
}

}  // namespace citykiln::commands
