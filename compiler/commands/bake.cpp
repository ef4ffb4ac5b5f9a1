// citykiln bake SCENE.kiln … : fires a manifest, to one file or to the very folder that compile writes.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "compiler/commands/join_tiles.h"
#include "compiler/commands/output_folder.h"
#include "compiler/commands/run_report.h"
#include "compiler/commands/verb.h"
#include "compiler/commands/write_tiles.h"
#include "compiler/pipeline.h"
#include "exporters/glb.h"
#include "exporters/manifest.h"

namespace citykiln::commands {
namespace {

struct Request {
  std::string manifest_path, out_path;
  std::optional<double> tolerance_m;  ///< One file at this tolerance; else a folder with levels.
  CompileSpec spec;                   ///< The settings that compile has too: only, emit, lods, instancing, threads.
};

/// All tiles of the scene, as one.
Result<bake::BakedTile> bake_whole(const scene::Scene& scene, double tolerance_m, int threads,
                                   const OnProgress& on_progress) {
  std::vector<bake::BakedTile> tiles;
  Report ignored;
  const Result<Done> fired = fire(scene, std::vector{tolerance_m}, threads, ignored, on_progress,
                                  [&](const bake::BakedTile& tile, std::size_t) -> Result<Done> {
                                    tiles.push_back(tile);
                                    return Done{};
                                  });
  if (!fired) return fired.error();
  return tiles.size() == 1 ? std::move(tiles.front()) : join_tiles(tiles);
}

Result<Exit> bake_to_file(const Request& request, const Console& console) {
  const Result<scene::Scene> scene = exporters::read_manifest(request.manifest_path, request.spec.only);
  if (!scene) return scene.error();
  if (scene->chunks.empty()) return Error{request.manifest_path, "holds no tile"};
  const Result<bake::BakedTile> tile =
      bake_whole(*scene, *request.tolerance_m, request.spec.threads, console.progress());
  if (!tile) return Error{request.out_path, tile.error().message};

  const auto instancing =
      request.spec.outputs.instances_as_nodes ? exporters::Instancing::kNodes : exporters::Instancing::kExtension;
  const Result<Done> written = exporters::write_glb(*tile, scene->header, instancing, request.out_path);
  if (!written) return written.error();
  console.say(fmt::format("{}: {} tiles, {} triangles, error {:.4g} m", request.out_path, scene->chunks.size(),
                          triangles_of(*tile), tile->error_m));
  console.answer(fmt::format(R"({{"tiles": {}, "triangles": {}, "error_m": {}}})", scene->chunks.size(),
                             triangles_of(*tile), tile->error_m));
  return Exit::kDone;
}

Result<Exit> bake_to_folder(const Request& request, const Console& console) {
  const Result<scene::Scene> scene = exporters::read_manifest(request.manifest_path, request.spec.only);
  if (!scene) return scene.error();
  Result<OutputFolder> folder = OutputFolder::open(request.out_path);
  if (!folder) return folder.error();

  Report report;
  const Outputs& outputs = request.spec.outputs;
  const Result<Written> written =
      write_outputs(*scene, outputs, request.spec.threads, *folder, report, console.progress());
  if (!written) return written.error();
  const std::string json =
      report_json(scene->header, *scene, report, *written, outputs, {measure_heights(*scene, request.spec.threads)});
  if (const Result<Done> done = folder->commit(json); !done) return done.error();

  console.say(fmt::format("{}: {} tiles, {:.1f} MB", request.out_path, scene->chunks.size(), written->bytes() * 1e-6));
  console.answer(json);
  return Exit::kDone;
}

Result<Exit> run(const Request& request, const Console& console) {
  if (request.manifest_path.empty()) return Error{"", "no manifest is given"};
  if (request.out_path.empty())
    return Error{"", "no output is given (-o FILE.glb with --tolerance, -o FOLDER without)"};
  return request.tolerance_m ? bake_to_file(request, console) : bake_to_folder(request, console);
}

Result<Done> take_tolerance(const std::string& text, std::optional<double>& tolerance_m) {
  const Result<double> number = parse_number(text);
  if (!number || *number <= 0) return Error{"--tolerance", fmt::format("expected metres above 0, found \"{}\"", text)};
  tolerance_m = *number;
  return Done{};
}

/// The settings that mean here what they mean to compile.
void add_settings(Verb& verb, Request& request) {
  for (const Setting& setting : settings()) {
    const std::string_view name = setting.name;
    if (name != "only" && name != "emit" && name != "lods" && name != "instancing" && name != "compress" &&
        name != "world" && name != "threads") {
      continue;
    }
    const std::string flags = name == "only" ? "--tile,--only" : "--" + std::string(name);
    verb.options.push_back(
        {flags, std::string(setting.value), std::string(setting.help), setting.repeats,
         [&request, &setting](const std::string& text) { return apply(setting, text, request.spec); }});
  }
}

}  // namespace

Verb bake_verb() {
  const auto request = std::make_shared<Request>();
  Verb verb{"bake", "fires a manifest: to one file, or to a folder as compile does", {}, {}};
  verb.options = {
      {"manifest", "SCENE.kiln", "the manifest", false, into(request->manifest_path)},
      {"--tolerance", "M", "largest deviation in metres of the one file", false,
       [request](const std::string& text) { return take_tolerance(text, request->tolerance_m); }},
      {"-o,--out", "FILE.glb|FOLDER", "where it goes", false, into(request->out_path)},
  };
  add_settings(verb, *request);
  verb.run = [request](const Console& console) { return run(*request, console); };
  return verb;
}

}  // namespace citykiln::commands
