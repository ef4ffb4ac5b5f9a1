// citykiln compile MAP … -o FOLDER: compiles a map to a manifest and bakes its tiles.
#include <memory>

#include "compiler/commands/compile_request.h"
#include "compiler/commands/compile_to_folder.h"
#include "compiler/commands/plan/compile_region.h"
#include "compiler/commands/verb.h"
#include "compiler/find_area.h"
#include "compiler/pipeline.h"

namespace citykiln::commands {
namespace {

/// True if `view` can show a run: it has its manifest, and lies on the ground of the Earth.
bool can_be_viewed(const CompileSpec& spec) { return spec.outputs.manifest && spec.world != World::kCylinder; }

}  // namespace

Verb compile_verb() {
  struct Request {
    CompileRequest compile;
    std::string plan, region;
  };
  const auto request = std::make_shared<Request>();
  Verb verb{"compile", "compiles a map to a manifest and bakes its tiles", options_of(request->compile), {}};
  verb.options.push_back({"--plan", "PLAN", "compiles a region of this plan (citykiln plan), with its settings", false,
                          store_text(request->plan)});
  verb.options.push_back({"--region", "X_Y", "the region of --plan", false, store_text(request->region)});
  verb.examples = {"citykiln compile monaco.osm.pbf --dem N43E007.hgt -o out/monaco",
                   "citykiln compile monaco.osm.pbf --bbox 7.415,43.73,7.43,43.745 --lods 0.1,0.5 -o out/centre",
                   "citykiln compile --spec examples/town/spec.json -o out/town",
                   "citykiln compile --plan PLAN --region 0_-1"};
  verb.run = [request](const Console& console) -> Result<Exit> {
    if (!request->plan.empty()) return compile_region(request->plan, request->region, request->compile, console);
    Result<CompileSpec> spec = spec_of(request->compile);
    if (!spec) return spec.error();
    if (const Result<Done> complete = check_complete(*spec); !complete) return complete.error();
    if (const Result<Done> area = resolve_area(*spec); !area) return area.error();
    const Result<Compiled> compiled = compile_to_folder(
        *spec, [&](const OnProgress& progress) { return compile(*spec, progress); }, console);
    if (!compiled) return compiled.error();
    if (can_be_viewed(*spec)) console.print_line(view_line(spec->outputs.folder));
    return compiled->exit;
  };
  return verb;
}

}  // namespace citykiln::commands
