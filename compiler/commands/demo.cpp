// citykiln demo: compiles the example town that is shipped with the program, and shows it in a browser.
#include <fmt/format.h>

#include <memory>

#include "compiler/commands/compile_to_folder.h"
#include "compiler/commands/demo/shipped_town.h"
#include "compiler/commands/serve/run_server.h"
#include "compiler/commands/serve/site_options.h"
#include "compiler/commands/verb.h"
#include "compiler/pipeline.h"

namespace citykiln::commands {
namespace {

struct DemoRequest {
  std::string folder = "citykiln-demo";
  ServerRequest server;
  int threads = 0;
  bool only_compiles = false;
};

/// The settings of the demo: the manifest alone, since `view` bakes the tiles that it shows.
Result<CompileSpec> demo_spec(const DemoRequest& request, const std::string& town) {
  Result<CompileSpec> spec = read_town(town);
  if (!spec) return spec;
  spec->outputs.folder = request.folder;
  spec->outputs.glb = false;
  spec->threads = request.threads;
  if (const Result<Done> complete = check_complete(*spec); !complete) return complete.error();
  return spec;
}

/// Compiles the town, unless the folder holds it already.
Result<Done> make_run(const CompileSpec& spec, const std::string& town, const Console& console) {
  const Result<bool> is_fresh = has_fresh_run(spec, town);
  if (!is_fresh) return is_fresh.error();
  if (*is_fresh) {
    console.print_line(fmt::format("{}: holds the example town already", spec.outputs.folder));
    return Done{};
  }
  console.print_line(fmt::format("compiling the example town, {}", spec.map_path));
  const Result<Compiled> compiled = compile_to_folder(
      spec, [&](const OnProgress& progress) { return compile(spec, progress); }, console);
  return compiled ? Result<Done>(Done{}) : compiled.error();
}

Result<Exit> run_demo(const DemoRequest& request, const Console& console) {
  const Result<std::string> town = shipped_town();
  if (!town) return town.error();
  const Result<CompileSpec> spec = demo_spec(request, *town);
  if (!spec) return spec.error();
  if (!request.only_compiles)
    if (const Result<Done> free = check_port(request.server); !free) return free.error();
  if (const Result<Done> made = make_run(*spec, *town, console); !made) return made.error();
  if (request.only_compiles) {
    console.print_line(view_line(request.folder));
    return Exit::kDone;
  }
  SiteChoices choices{.path = request.folder, .spec = {}};
  choices.spec.threads = request.threads;
  const Result<SiteRequest> site = site_request(choices, true);
  return site ? serve_site(*site, request.server, console) : site.error();
}

}  // namespace

Verb demo_verb() {
  const auto request = std::make_shared<DemoRequest>();
  Verb verb{"demo", "compiles the example town that is shipped with the program, and shows it in a browser", {}, {}};
  verb.options = {{"-o,--out", "FOLDER", "folder for the run (default: citykiln-demo, in the working folder)", false,
                   store_text(request->folder)},
                  {"--no-view", "", "ends when the town is compiled", false,
                   [request](const std::string& text) -> Result<Done> {
                     request->only_compiles = text == "true";
                     return Done{};
                   }},
                  {"--port", "N", "port of the server, 0 to 65535 (default: 0, any free one)", false,
                   store_port(request->server.port)},
                  threads_option(request->threads)};
  verb.examples = {"citykiln demo", "citykiln demo -o out/town --no-view"};
  verb.run = [request](const Console& console) { return run_demo(*request, console); };
  return verb;
}

}  // namespace citykiln::commands
