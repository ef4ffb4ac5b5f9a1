// citykiln bake SCENE.kiln …: bakes a manifest into one .glb file, or into the same folder that compile writes.
#include "compiler/bake/bake.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "compiler/bake/far/bend.h"
#include "compiler/bake/tiles/join_tiles.h"
#include "compiler/bake_scene.h"
#include "compiler/commands/interrupt_notice.h"
#include "compiler/commands/run_paths.h"
#include "compiler/commands/verb.h"
#include "compiler/commands/view/ground_height.h"
#include "compiler/commands/view/view_options.h"
#include "compiler/outputs/run_report.h"
#include "compiler/outputs/tile_lights.h"
#include "compiler/outputs/write_outputs.h"
#include "compiler/settings.h"
#include "compiler/verify/heights/heights_json.h"
#include "exporters/file.h"
#include "exporters/gltf/write/encode_tile.h"
#include "exporters/kiln/manifest.h"
#include "exporters/output_folder.h"
#include "exporters/usd/usdz.h"
#include "preview/camera/camera.h"

namespace citykiln::commands {
namespace {

using OrderedJson = nlohmann::ordered_json;

struct BakeRequest {
  std::string manifest_path, out_path;
  std::optional<double> tolerance_m;  ///< For one file; with an eye the finest tolerance. Empty: a folder with levels.
  std::optional<GivenPoint> eye, eye_lonlat;  ///< The viewer of the one file.
  std::optional<double> fov_deg;
  PictureSize size;
  double pixel_error = 1;
  CompileSpec spec;  ///< The settings shared with compile: only, emit, lods, target, split, compress, threads.
};

/// Reads the manifest, of which tiles show what is requested.
Result<scene::Scene> read_shown_scene(const BakeRequest& request, std::span<const scene::TileKey> only) {
  Result<scene::Scene> scene = exporters::read_manifest(request.manifest_path, only);
  if (scene) scene->header.shown = scene::with_request(scene->header.shown, request.spec.shown);
  return scene;
}

/// All tiles of the scene joined to one.
Result<bake::BakedTile> bake_as_one_tile(const scene::Scene& scene, const BakeRequest& request,
                                         const OnProgress& on_progress) {
  std::vector<bake::BakedTile> tiles;
  Report ignored;
  const Result<Done> baked = bake_scene(
      scene, std::vector{*request.tolerance_m}, request.spec.threads, ignored, on_progress,
      [&](const bake::BakedTile& tile, std::size_t) -> Result<Done> {
        tiles.push_back(tile);
        return Done{};
      },
      outputs::most_instances_of(request.spec.outputs.target));
  if (!baked) return baked.error();
  Result<bake::BakedTile> joined = tiles.size() == 1 ? std::move(tiles.front()) : bake::join_tiles(tiles);
  if (!joined) return joined;
  return bake::in_world(std::move(*joined), scene.header);
}

bool is_asked_for(const BakeRequest& request, scene::TileKey tile) {
  const std::vector<scene::TileKey>& only = request.spec.only;
  return only.empty() || std::ranges::find(only, tile) != only.end();
}

/// Writes the one file and returns its error in metres.
Result<double> write_one_file(const BakeRequest& request, const scene::Scene& scene, const bake::BakedTile& tile) {
  const Outputs& outputs = request.spec.outputs;
  const scene::Header& header = scene.header;
  if (request.out_path.ends_with(".usdz")) {
    const Result<std::vector<std::byte>> usdz = exporters::encode_usdz(tile, header);
    if (!usdz) return Error{request.out_path, usdz.error().message};
    if (const Result<Done> done = exporters::write_file(request.out_path, *usdz); !done) return done.error();
    return tile.error_m;
  }
  std::vector<bake::PlacedLamp> lights;
  const auto by_tile = outputs::lights_of_tiles(scene, outputs.lights, request.spec.threads);
  for (std::size_t i = 0; i < by_tile.size(); ++i)
    if (is_asked_for(request, scene.chunks[i].tile)) lights.insert(lights.end(), by_tile[i].begin(), by_tile[i].end());
  exporters::GlbOptions options = outputs::glb_options_of(outputs);
  options.lights = lights;
  const exporters::EncodedTile encoded = exporters::encode_tile(tile, header, options, request.spec.threads);
  if (const Result<Done> done = exporters::write_file(request.out_path, encoded.glb); !done) return done.error();
  return encoded.error_m;
}

Result<Exit> bake_to_file(const BakeRequest& request, const Console& console) {
  const Result<scene::Scene> scene = read_shown_scene(request, request.spec.only);
  if (!scene) return scene.error();
  if (scene->chunks.empty()) return Error{request.manifest_path, "contains no tiles"};
  const Result<bake::BakedTile> tile = bake_as_one_tile(*scene, request, console.progress());
  if (!tile) return Error{request.out_path, tile.error().message};
  const Result<double> error_m = write_one_file(request, *scene, *tile);
  if (!error_m) return error_m.error();
  console.print_line(fmt::format("{}: {} tiles, {} triangles, error {:.4g} m", request.out_path, scene->chunks.size(),
                                 exporters::triangles_of(*tile), *error_m));
  const OrderedJson json = {
      {"tiles", scene->chunks.size()}, {"triangles", exporters::triangles_of(*tile)}, {"error_m", *error_m}};
  console.print_json(json.dump());
  return Exit::kDone;
}

Result<bake::View> view_of(const BakeRequest& request, const scene::Scene& scene, const Console& console) {
  const GroundHeight ground_m = [&](Vec2 place) { return ground_height_m(scene, place); };
  const Result<std::optional<Vec3>> eye = point_of(request.eye, request.eye_lonlat, scene.header, ground_m);
  if (!eye) return eye.error();
  note_if_below_ground(**eye, ground_m, console);
  bake::View view{
      **eye, bake::focal_length_px(request.size.height, request.fov_deg.value_or(preview::Camera{}.vertical_fov_deg))};
  view.pixel_error = request.pixel_error;
  view.finest_m = request.tolerance_m.value_or(view.finest_m);
  return view;
}

/// Bakes the requested tiles. Levels are chosen for the whole scene, so that separately baked tiles fit together.
Result<bake::BakedTile> bake_for_view(const BakeRequest& request, const scene::Scene& scene, const bake::View& view,
                                      const OnProgress& on_progress) {
  const bake::ViewLevels levels = bake::levels_for(scene, view);
  const auto prototypes = std::make_shared<const bake::PrototypeCache>(scene.header);
  std::vector<bake::BakedTile> parts;
  for (std::size_t i = 0; i < scene.chunks.size(); ++i) {
    on_progress("bake", static_cast<double>(i) / static_cast<double>(scene.chunks.size()));
    const scene::Chunk& chunk = scene.chunks[i];
    if (!is_asked_for(request, chunk.tile)) continue;
    std::ranges::move(bake::bake(scene.header, chunk, levels, request.spec.threads, prototypes,
                                 outputs::most_instances_of(request.spec.outputs.target)),
                      std::back_inserter(parts));
  }
  if (parts.empty()) return Error{"", "the scene has none of the requested tiles"};
  return bake::join_tiles(parts);
}

Result<Exit> bake_view_to_file(const BakeRequest& request, const Console& console) {
  const Result<scene::Scene> scene = read_shown_scene(request, {});
  if (!scene) return scene.error();
  if (scene::cylinder_of(scene->header))
    return Error{"--eye", "is for worlds in the plane, found one inside of a cylinder; give --tolerance M instead"};
  const Result<bake::View> view = view_of(request, *scene, console);
  if (!view) return view.error();
  const Result<bake::BakedTile> tile = bake_for_view(request, *scene, *view, console.progress());
  if (!tile) return Error{request.out_path, tile.error().message};
  const Result<double> error_m = write_one_file(request, *scene, *tile);
  if (!error_m) return error_m.error();
  console.print_line(fmt::format("{}: {} triangles, error {:.3g} pixels ({:.3g} requested; no finer than {:.4g} m)",
                                 request.out_path, exporters::triangles_of(*tile), tile->viewpoint->pixel_error,
                                 view->pixel_error, view->finest_m));
  const OrderedJson json = {{"triangles", exporters::triangles_of(*tile)},
                            {"error_m", *error_m},
                            {"focal_px", view->focal_px},
                            {"pixel_error", tile->viewpoint->pixel_error}};
  console.print_json(json.dump());
  return Exit::kDone;
}

/// Error: settings that the world of a manifest does not allow.
Result<Done> fits_manifest(const CompileSpec& spec, const scene::Header& header) {
  const auto cylinder = scene::cylinder_of(header);
  if (!cylinder) return Done{};
  if (spec.world != World::kByOutput)
    return Error{"--world",
                 fmt::format("the manifest is of a world inside of a cylinder with a radius of {} m; leave it out",
                             cylinder->radius_m)};
  CompileSpec inside = spec;
  inside.world = World::kCylinder, inside.cylinder = *cylinder;
  return check_world(inside);
}

Result<Exit> bake_to_folder(const BakeRequest& request, const Console& console) {
  const Result<scene::Scene> scene = read_shown_scene(request, request.spec.only);
  if (!scene) return scene.error();
  if (const Result<Done> fits = fits_manifest(request.spec, scene->header); !fits) return fits.error();
  Result<exporters::OutputFolder> folder = exporters::OutputFolder::open(request.out_path);
  if (!folder) return folder.error();

  const InterruptNotice notice(kRunAsBefore);
  Report report;
  const Outputs& outputs = request.spec.outputs;
  const Result<outputs::WrittenOutputs> written =
      outputs::write_outputs(*scene, outputs, request.spec.threads, *folder, report, console.progress());
  if (!written) return written.error();
  const std::string json =
      outputs::report_json(scene->header, *scene, report, written->files, outputs,
                           verify::heights_json({verify::measure_heights(*scene, request.spec.threads)}));
  if (const Result<Done> done = outputs::commit_outputs(*written, json, scene->header, *folder); !done)
    return done.error();

  console.print_line(
      fmt::format("{}: {} tiles, {:.1f} MB", request.out_path, scene->chunks.size(), written->files.bytes() * 1e-6));
  for (const std::string& note : outputs::notes_of(request.out_path, *written, folder->files()))
    console.print_line(note);
  console.print_json(json);
  return Exit::kDone;
}

/// Error: the output does not fit the options: one file is of one tolerance or one eye, a folder has all levels.
Result<Done> output_fits(const BakeRequest& request) {
  const bool is_one_file = request.tolerance_m || request.eye || request.eye_lonlat;
  if (request.out_path.empty())
    return Error{"",
                 "no output is given; add -o FILE.glb or FILE.usdz with --tolerance or --eye, or -o FOLDER without"};
  if (!is_one_file && (request.out_path.ends_with(".glb") || request.out_path.ends_with(".usdz")))
    return Error{request.out_path, "names one file, which needs a tolerance: add --tolerance M, such as 0.1, or --eye"};
  if (is_one_file && (request.out_path.ends_with(".usd") || request.out_path.ends_with(".usda") ||
                      request.out_path.ends_with(".usdc")))
    return Error{request.out_path, "leaves textures without a file; give FILE.usdz, or -o FOLDER with --emit usd"};
  std::error_code none;
  const bool is_folder = std::filesystem::is_directory(request.out_path, none);
  if (is_one_file && !is_folder)
    if (const auto fits = check_output_file(request.out_path, {".glb", ".usdz"}); !fits) return fits.error();
  if (is_one_file && is_folder)
    return Error{request.out_path, "is a folder; --tolerance and --eye write one file: give -o FILE.glb"};
  if (request.spec.world == World::kCylinder)
    return Error{"--world",
                 "a manifest knows its cylinder; compile the map with --world cylinder:R, and leave it out here"};
  if (const Result<Done> fits = check_world(request.spec); !fits) return fits.error();
  return check_target(request.spec.outputs);
}

Result<Exit> run_bake(const BakeRequest& asked, const Console& console) {
  if (asked.manifest_path.empty())
    return Error{"", "no manifest is given; expected a file such as out/scene.kiln, or the folder of a run"};
  if (const Result<Done> fits = output_fits(asked); !fits) return fits.error();
  if (const Result<Done> fits = check_run_path(asked.manifest_path); !fits) return fits.error();
  const Result<std::string> manifest_path = find_committed_manifest(asked.manifest_path);
  if (!manifest_path) return manifest_path.error();
  BakeRequest request = asked;
  request.manifest_path = *manifest_path;
  if (request.eye || request.eye_lonlat) return bake_view_to_file(request, console);
  return request.tolerance_m ? bake_to_file(request, console) : bake_to_folder(request, console);
}

/// The settings that have the same meaning as for compile.
void add_settings(Verb& verb, BakeRequest& request) {
  for (const Setting& setting : settings()) {
    const std::string_view name = setting.name;
    if (name != "only" && name != "emit" && name != "lods" && name != "target" && name != "split" &&
        name != "compress" && name != "lights" && name != "layout" && name != "max-bytes" && name != "max-triangles" &&
        name != "world" && name != "geoid-height" && name != "threads" && name != "surroundings" && name != "layers" &&
        name != "wood-density" && name != "lamps" && name != "lit-windows") {
      continue;
    }
    const std::string flags = name == "only" ? "--tile,--only" : "--" + std::string(name);
    verb.options.push_back(
        {flags, std::string(setting.value), help_of(setting), setting.repeats,
         [&request, &setting](const std::string& text) { return apply(setting, text, request.spec); }});
  }
}

}  // namespace

Verb bake_verb() {
  const auto request = std::make_shared<BakeRequest>();
  Verb verb{"bake", "bakes a manifest to one .glb or .usdz file, or to a folder as compile does", {}, {}};
  verb.options = {
      {"manifest", "SCENE.kiln|OUT", "manifest to bake, such as out/scene.kiln, or the folder of a run", false,
       store_text(request->manifest_path)},
      {"--tolerance", "M",
       "largest geometric error in metres of one .glb or .usdz file, such as 0.1; with --eye the smallest (default "
       "there: 0.02)",
       false, store_tolerance(request->tolerance_m)},
      {"-o,--out", "FILE.glb|FILE.usdz|FOLDER", "output: a file with --tolerance or --eye, else a folder", false,
       store_text(request->out_path)},
      {"--eye", "X,Y,Z",
       "one .glb file for a viewer at this place in plane metres, such as 0,-200,150, or 0,-200,+2 for 2 m above the "
       "ground; detail falls with distance",
       false, store_point(request->eye)},
      {"--eye-lonlat", "LON,LAT,HEIGHT", "the same in degrees and metres, such as 7.42,43.73,150", false,
       store_point(request->eye_lonlat)},
      {"--pixel-error", "PIXELS", "with --eye: largest error on the picture in pixels (default: 1)", false,
       store_number(request->pixel_error, {})},
      {"--size", "WxH", "with --eye: size of the picture in pixels (default: 1280x720)", false,
       store_size(request->size)},
      {"--fov", "DEG", "with --eye: vertical field of view in degrees (default: 45)", false,
       store_number(request->fov_deg, kFieldsOfView_deg)},
  };
  add_settings(verb, *request);
  verb.examples = {"citykiln bake out/town/scene.kiln --tile 0_0 --tolerance 0.1 -o tile.glb",
                   "citykiln bake out/town/scene.kiln --tile 0_0 --tolerance 0.5 -o tile.usdz",
                   "citykiln bake out/town/scene.kiln --eye 0,-200,+1.7 --size 1920x1080 -o view.glb",
                   "citykiln bake out/town/scene.kiln --lods 0.5,2.5 -o out/coarse"};
  verb.run = [request](const Console& console) { return run_bake(*request, console); };
  return verb;
}

}  // namespace citykiln::commands
