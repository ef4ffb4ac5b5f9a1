// citykiln bake SCENE.kiln … : fires a manifest, to one file or to the very folder that compile writes.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "compiler/bake/bake.h"
#include "compiler/commands/output_folder.h"
#include "compiler/commands/run_report.h"
#include "compiler/commands/verb.h"
#include "compiler/commands/write_tiles.h"
#include "compiler/spec.h"
#include "exporters/glb.h"
#include "exporters/manifest.h"

namespace citykiln::commands {
namespace {

struct Request {
  std::string manifest_path, out_path;
  std::optional<double> tolerance_m;  ///< One file at this tolerance; else a folder with levels.
  CompileSpec spec;                   ///< The settings that compile has too: only, emit, lods, instancing, threads.
};

/// The one tile that goes into one file.
Result<scene::Scene> read_one_tile(const Request& request) {
  Result<scene::Scene> scene = exporters::read_manifest(request.manifest_path, request.spec.only);
  if (!scene || scene->chunks.size() == 1) return scene;
  if (scene->chunks.empty()) return Error{request.manifest_path, "holds no tile"};
  return Error{request.manifest_path,
               fmt::format("holds {} tiles, {} to {}: name one with --tile X_Y, or give a folder and no --tolerance", scene->chunks.size(),
                           to_string(scene->chunks.front().tile), to_string(scene->chunks.back().tile))};
}

Result<Exit> bake_to_file(const Request& request, const Console& console) {
  const Result<scene::Scene> scene = read_one_tile(request);
  if (!scene) return scene.error();
  Report report;
  const bake::BakedTile tile = bake::bake(scene->header, scene->chunks.front(), *request.tolerance_m, request.spec.threads, report);
  const auto instancing =
      request.spec.outputs.instances_as_nodes ? exporters::Instancing::kNodes : exporters::Instancing::kExtension;
  const Result<Done> written = exporters::write_glb(tile, scene->header, instancing, request.out_path);
  if (!written) return written.error();
  console.say(fmt::format("{}: tile {}, {} triangles, error {:.4g} m", request.out_path, to_string(tile.tile), triangles_of(tile), tile.error_m));
  console.answer(fmt::format(R"({{"tile": "{}", "triangles": {}, "error_m": {}}})", to_string(tile.tile), triangles_of(tile), tile.error_m));
  return Exit::kDone;
}

Result<Exit> bake_to_folder(const Request& request, const Console& console) {
  const Result<scene::Scene> scene = exporters::read_manifest(request.manifest_path, request.spec.only);
  if (!scene) return scene.error();
  Result<OutputFolder> folder = OutputFolder::open(request.out_path);
  if (!folder) return folder.error();

  Report report;
  const Outputs& outputs = request.spec.outputs;
  const Result<Written> written = write_outputs(*scene, outputs, request.spec.threads, *folder, report, console.progress());
  if (!written) return written.error();
  const std::string json = report_json(scene->header, *scene, report, *written, outputs);
  if (const Result<Done> done = folder->commit(json); !done) return done.error();

  console.say(fmt::format("{}: {} tiles, {:.1f} MB", request.out_path, scene->chunks.size(), written->bytes() * 1e-6));
  console.answer(json);
  return Exit::kDone;
}

Result<Exit> run(const Request& request, const Console& console) {
  if (request.manifest_path.empty()) return Error{"", "no manifest is given"};
  if (request.out_path.empty()) return Error{"", "no output is given (-o FILE.glb with --tolerance, -o FOLDER without)"};
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
    if (name != "only" && name != "emit" && name != "lods" && name != "instancing" && name != "compress" && name != "world" &&
        name != "threads") {
      continue;
    }
    const std::string flags = name == "only" ? "--tile,--only" : "--" + std::string(name);
    verb.options.push_back({flags, std::string(setting.value), std::string(setting.help), setting.repeats,
                            [&request, &setting](const std::string& text) { return apply(setting, text, request.spec); }});
  }
}

}  // namespace

Verb bake_verb() {
  const auto request = std::make_shared<Request>();
  Verb verb{"bake", "fires a manifest: one tile to a file, or all to a folder, as compile does", {}, {}};
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
