// citykiln preview … -o picture.png: renders a picture of a manifest, a run's folder or .glb files.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "compiler/commands/run_paths.h"
#include "compiler/commands/stop_on_interrupt.h"
#include "compiler/commands/verb.h"
#include "compiler/commands/view/camera_options.h"
#include "compiler/commands/view/frame_names.h"
#include "compiler/commands/view/load_cells.h"
#include "compiler/commands/view/load_tiles.h"
#include "compiler/commands/view/preview_scene.h"
#include "compiler/commands/view/view_options.h"
#include "compiler/contract/texts/parse.h"
#include "compiler/outputs/texture_choice.h"
#include "compiler/parse_shown.h"
#include "compiler/parse_values.h"
#include "preview/camera/camera_rays.h"
#include "preview/camera/cell_view.h"
#include "preview/camera/view_probe.h"
#include "preview/picture/denoise.h"
#include "preview/picture/exposure.h"
#include "preview/picture/read_environment.h"
#include "preview/render.h"
#include "preview/window/interactive.h"

namespace citykiln::commands {
namespace {

using OrderedJson = nlohmann::ordered_json;

// --exposure: a factor, stops, or automatic.
struct Exposure {
  double factor = 1;
  bool is_auto = false, is_given = false;

  /// Returns the factor of a picture.
  double of(const preview::Image& image, const sky::Sky& sky) const {
    const bool is_metered = !is_given || is_auto;
    return factor * (is_metered ? preview::metered_exposure(image) : preview::adapted_exposure(sky));
  }
};

struct PreviewRequest {
  LoadRequest load;
  CellRequest cells;
  CameraRequest camera;
  std::string picture_path, environment_path, materials_folder;
  double environment_turn_deg = 0;
  PictureSize size;
  Exposure exposure;
  std::optional<double> fog_share;
  bool keeps_noise = false, keeps_frames = false, is_interactive = false;
  preview::CloudMethod cloud_method = preview::CloudMethod::kApproximate;
  preview::Options options;
};

/// The environment map that replaces the sky, if one is given.
Result<std::optional<preview::EnvironmentMap>> environment_of(const PreviewRequest& request, const Console& console) {
  if (request.environment_path.empty()) return std::optional<preview::EnvironmentMap>();
  Result<preview::ReadEnvironment> read =
      preview::read_environment(request.environment_path, request.environment_turn_deg);
  if (!read) return read.error();
  if (read->mended > 0)
    console.print_line(fmt::format("note: {} has {} pixels that are negative or not finite; they count as black",
                                   request.environment_path, read->mended));
  return std::optional(std::move(read->map));
}

std::vector<preview::Metadata> metadata_of(const preview::Image& image, const preview::Camera& camera,
                                           const sky::Sky& sky, double exposure) {
  const auto text = [](Vec3 p) { return fmt::format("{:.3f},{:.3f},{:.3f}", p.x, p.y, p.z); };
  const preview::RenderStatistics& made = image.statistics;
  return {{"Eye", text(camera.eye)},
          {"Look", text(camera.look_at)},
          {"VerticalFieldOfView", fmt::format("{}", camera.vertical_fov_deg)},
          {"LensDiameter", fmt::format("{}", camera.lens_radius_m * 2)},
          {"Time", sky::text_of(sky.time)},
          {"Exposure", fmt::format("{}", exposure)},
          {"ExposureValue", fmt::format("{:.1f}", preview::exposure_value(exposure))},
          {"Samples", made.least_samples == made.most_samples
                          ? fmt::format("{}", made.most_samples)
                          : fmt::format("{} to {}", made.least_samples, made.most_samples)}};
}

// Eyes that have a surface this near in all directions of the picture are inside something.
constexpr double kBlind_m = 0.3;

// The data that all frames share.
struct Stage {
  const PreviewRequest& request;
  const PreviewScene& scene;
  const preview::Lights& lights;
  const Console& console;
  preview::Options options;
};

// The surfaces that rays meet, and the lights among them.
struct LitWorld {
  preview::World world;
  preview::LocalLights local;

  /// @param cameras  In the scene's world.
  LitWorld(const Stage& stage, std::span<const preview::Camera> cameras)
      : world(world_of(stage.scene, {cameras, stage.options.width, stage.options.height}, stage.request.cells)),
        local(world, stage.lights.lamps(), stage.options.threads, stage.scene.panes) {}
};

void print_picture_summary(const Stage& stage, const std::string& path, const preview::Image& image,
                           const preview::World& world) {
  const preview::RenderStatistics& made = image.statistics;
  const std::string paths = made.least_samples == made.most_samples
                                ? fmt::format("{} paths each", made.most_samples)
                                : fmt::format("{} to {} paths each", made.least_samples, made.most_samples);
  stage.console.print_line(fmt::format("{}: {} x {} pixels, {}, {} tiles{}", path, image.width, image.height, paths,
                                       stage.scene.tiles(),
                                       made.is_complete ? "" : "; interrupted before all paths were traced"));
  if (const auto counters = world.counters())
    stage.console.print_line(text_of(*counters, budget_bytes_of(stage.request.cells)));
}

void print_json(const Stage& stage, const preview::Image& image, const preview::Camera& camera,
                const preview::World& world) {
  const preview::RenderStatistics& made = image.statistics;
  const auto counters = world.counters();
  OrderedJson json = {{"eye", {camera.eye.x, camera.eye.y, camera.eye.z}},
                      {"look", {camera.look_at.x, camera.look_at.y, camera.look_at.z}},
                      {"fov_deg", camera.vertical_fov_deg},
                      {"tiles", stage.scene.tiles()},
                      {"paths", made.paths},
                      {"seconds", made.seconds},
                      {"samples", {made.least_samples, made.most_samples}},
                      {"complete", made.is_complete}};
  if (counters) json.update(json_of(*counters, budget_bytes_of(stage.request.cells)));
  stage.console.print_json(json.dump());
}

// The options of render() for a request.
preview::Options options_of(const PreviewRequest& request) {
  preview::Options options = request.options;
  options.width = request.size.width, options.height = request.size.height;
  options.threads = request.load.threads;
  options.has_guides = !request.keeps_noise || request.picture_path.ends_with(".exr");
  return options;
}

// A camera as it was given, and in the scene's world.
struct FrameCamera {
  const preview::Camera &in_plane, &in_world;
};

// The picture that a file shows: a .png has its white balance, an .exr has the light itself.
preview::Image balanced(const Stage& stage, const preview::Image& image, const std::string& path) {
  preview::Image shown = image;
  if (path.ends_with(".png")) preview::balance(shown, preview::white_balance(stage.lights.white()));
  return shown;
}

// Renders one frame and writes it. `exposure` is the factor of all frames, decided by the first one.
Result<preview::Image> render_frame(const Stage& stage, const LitWorld& lit, const FrameCamera& camera,
                                    const std::string& path, std::optional<double>& exposure) {
  preview::Image image = preview::render(lit.world, stage.lights, lit.local, camera.in_world, stage.options);
  if (!stage.request.keeps_noise) image = preview::denoise(image, stage.options.threads);
  if (!exposure) exposure = stage.request.exposure.of(image, stage.scene.sky);
  preview::expose(image, *exposure);
  const Result<Done> written = preview::write_image(balanced(stage, image, path), path,
                                                    metadata_of(image, camera.in_plane, stage.scene.sky, *exposure));
  if (!written) return written.error();
  return image;
}

// Says why a picture shows nothing: the eye is in a wall, or no light reaches what it sees.
void note_if_blind(const Stage& stage, const preview::World& world, const preview::Camera& camera,
                   const preview::Image& image) {
  if (const double near_m = preview::farthest_in_picture_m(world, camera); near_m < kBlind_m)
    return stage.console.print_line(fmt::format(
        "note: a surface less than {:.2f} m away fills the picture; the eye may be inside a wall", kBlind_m));
  if (preview::is_black(image))
    stage.console.print_line(
        "note: the picture is black; the eye may be inside a building or below the ground, or --exposure is too low");
}

Result<std::vector<std::string>> picture_names(const PreviewRequest& request, std::size_t cameras) {
  if (!request.camera.is_film()) return std::vector{request.picture_path};
  return frame_names(request.picture_path, static_cast<int>(cameras));
}

Result<Exit> render_frames(Stage stage, const std::vector<preview::Camera>& cameras, const OnProgress& on_progress) {
  const Result<std::vector<std::string>> names = picture_names(stage.request, cameras.size());
  if (!names) return names.error();
  const StopOnInterrupt interrupt;
  stage.options.is_stopped = &interrupt.is_stopped();
  std::optional<double> exposure;
  std::optional<LitWorld> lit;
  std::vector<preview::Camera> shown = cameras;
  if (stage.scene.loaded.cylinder)
    for (preview::Camera& camera : shown) camera = preview::bent(camera, *stage.scene.loaded.cylinder);
  for (std::size_t i = 0; i < cameras.size() && !interrupt.is_stopped(); ++i) {
    std::error_code none;
    if (stage.request.keeps_frames && std::filesystem::exists((*names)[i], none)) continue;
    stage.options.on_progress = [&](double share) {
      on_progress("render", (static_cast<double>(i) + share) / static_cast<double>(cameras.size()));
    };
    if (!lit) lit.emplace(stage, shown);
    const Result<preview::Image> image = render_frame(stage, *lit, {cameras[i], shown[i]}, (*names)[i], exposure);
    if (!image) return image.error();
    print_picture_summary(stage, (*names)[i], *image, lit->world);
    note_if_blind(stage, lit->world, shown[i], *image);
    print_json(stage, *image, cameras[i], lit->world);
  }
  return Exit::kDone;
}

// Shows a window; the picture that P writes is the one of -o.
Result<Exit> fly(const Stage& stage, const preview::Camera& camera) {
  const LitWorld lit(stage, std::span(&camera, 1));
  preview::Options options = stage.options;
  options.exposure = stage.request.exposure.factor * preview::adapted_exposure(stage.scene.sky);
  options.has_guides = false;
  const std::string path = stage.request.picture_path.empty() ? "preview.png" : stage.request.picture_path;
  const auto write = [&](const preview::Image& image, const preview::Camera& at, double exposure) {
    const Result<Done> written = preview::write_image(image, path, metadata_of(image, at, stage.scene.sky, exposure));
    if (!written) return stage.console.print_error(written.error());
    stage.console.print_line(fmt::format("{}: eye {:.2f},{:.2f},{:.2f}, look {:.2f},{:.2f},{:.2f}", path, at.eye.x,
                                         at.eye.y, at.eye.z, at.look_at.x, at.look_at.y, at.look_at.z));
  };
  const Result<Done> shown = preview::show_interactive(lit.world, stage.lights, lit.local, camera, options, write);
  if (!shown) return shown.error();
  return Exit::kDone;
}

// The clouds of a scene's sky, as fine as the first camera needs.
std::shared_ptr<const preview::Clouds> clouds_of(const PreviewScene& scene, const sky::SkyModel& model,
                                                 const preview::Camera& camera, const PreviewRequest& request) {
  if (scene.sky.clouds.empty()) return nullptr;
  const double pixel_rad = preview::CameraRays(camera, request.size.width, request.size.height).pixel_rad();
  return std::make_shared<preview::Clouds>(scene.sky.clouds, model, camera.eye, pixel_rad, request.cloud_method,
                                           request.load.threads);
}

// Clears the haze of a view that shows land from afar, so that a large extent is as clear as a small one: one sees at
// least 50 times as far as the place looked at. Does nothing if the haze was asked for.
void clear_haze(const PreviewRequest& request, const preview::Camera& camera, sky::Sky& sky) {
  constexpr double kTimes = 50;
  if (!request.camera.finds_view() || request.load.air.visibility_km || request.load.air.turbidity) return;
  if (sky.visibility_km < sky::Sky{}.visibility_km) return;
  const double wanted_km = kTimes * length(camera.look_at - camera.eye) / 1000;
  sky.visibility_km = std::max(sky.visibility_km, std::min(wanted_km, sky::kClearest_km));
}

// Artists' textures, which replace those of a scene's recipes and tiles.
Result<std::vector<outputs::MaterialSet>> own_textures(const std::string& folder) {
  Outputs asked;
  asked.materials_folder = folder;
  return outputs::sets_of(asked);
}

CellRequest with_textures(CellRequest cells, const std::vector<outputs::MaterialSet>& sets) {
  for (const outputs::MaterialSet& set : sets) cells.textures.push_back(set.texture);
  return cells;
}

void replace_textures(const std::vector<outputs::MaterialSet>& sets, std::vector<bake::BakedTile>& tiles) {
  const outputs::TextureChoice choice({}, 0, sets);
  for (bake::BakedTile& tile : tiles) choice.apply(tile);
}

// The light of a scene, for the first camera.
preview::Lights lights_of(const PreviewScene& scene, const preview::Camera& camera, const PreviewRequest& request) {
  if (scene.sky.inside) return preview::Lights(preview::InsideLights(scene.sky), scene.lamps);
  const sky::SkyModel model = sky::generate(scene.sky, camera.eye.z, preview::ground_lights(scene.lamps, camera.eye));
  return preview::Lights(model, scene.lamps, scene.around, scene.fog, clouds_of(scene, model, camera, request));
}

Result<Exit> run_preview(PreviewRequest request, const Console& console) {
  if (request.picture_path.empty() && !request.is_interactive)
    return Error{"", "no picture is given; add -o FILE.png or -o FILE.exr"};
  for (std::string& path : request.load.paths) {
    if (const Result<Done> fits = check_run_path(path); !fits) return fits.error();
    path = manifest_without_tiles(path);
    if (request.load.level && path.ends_with(".kiln"))
      return Error{"--level", "is for a folder's tiles; of a manifest --tolerance or --pixel-error gives the detail"};
  }
  if (!request.picture_path.empty())
    if (const auto fits = check_output_file(request.picture_path, {".png", ".exr"}); !fits) return fits.error();
  if (request.camera.is_film())
    if (const auto names = picture_names(request, 1); !names) return names.error();
  if (request.is_interactive)
    if (const Result<Done> ready = preview::check_window(); !ready) return ready.error();
  const Result<std::optional<preview::EnvironmentMap>> environment = environment_of(request, console);
  if (!environment) return environment.error();
  const Result<std::vector<outputs::MaterialSet>> sets = own_textures(request.materials_folder);
  if (!sets) return sets.error();
  request.cells = with_textures(std::move(request.cells), *sets);
  const OnProgress on_progress = console.progress();
  const SceneRequest wanted{.load = request.load,
                            .cells = request.cells,
                            .finds_views = request.camera.finds_view(),
                            .needs_tiles = request.is_interactive,
                            .fog_share = request.fog_share};
  Result<PreviewScene> scene = load_preview_scene(wanted, on_progress);
  if (!scene) return scene.error();
  const Result<std::vector<preview::Camera>> cameras = cameras_of(request.camera, *scene, console);
  if (!cameras) return cameras.error();
  scene->for_views = {};
  if (scene->tree) {
    // a window's camera goes anywhere
    const std::span<const preview::Camera> seen =
        request.is_interactive ? std::span<const preview::Camera>() : *cameras;
    const Viewing viewing{seen, request.size.width, request.size.height};
    if (const Result<Done> read = load_levels(*scene, wanted, viewing, on_progress); !read) return read.error();
    if (!scene->recipes) console.print_line(levels_text(scene->loaded.tiles));
  }
  replace_textures(*sets, scene->loaded.tiles);
  if (scene->recipes)
    scene->panes = preview::lit_panes_of(*scene->recipes, preview::eyes_of(*cameras), request.load.threads);
  bend_tiles(*scene);
  if (!scene->note.empty()) console.print_line(scene->note);
  if (scene->loaded.cylinder && request.is_interactive)
    return Error{"--interactive",
                 "shows worlds in the plane, found one inside of a cylinder; give -o FILE.png instead"};
  if (!request.is_interactive && leave_out_hiding_land(*scene, *cameras))
    console.print_line("note: the land around the map would hide it from here and is left out");
  clear_haze(request, cameras->front(), scene->sky);
  on_progress("light", 0);
  const preview::Lights lights =
      *environment ? preview::Lights(**environment, scene->lamps) : lights_of(*scene, cameras->front(), request);
  const Stage stage{request, *scene, lights, console, options_of(request)};
  // a window shows the progress itself
  if (request.is_interactive) on_progress({}, 0);
  if (request.is_interactive) return fly(stage, cameras->front());
  return render_frames(stage, *cameras, on_progress);
}

std::vector<Option> tile_options(LoadRequest& load, CellRequest& cells) {
  return {
      {"inputs", "SCENE.kiln|OUT|FILE.glb...", "what to render: a manifest, a run's folder, or .glb files", true,
       append_text(load.paths)},
      {"--tolerance", "M",
       "bakes a manifest at this tolerance in metres before rendering (default: each cell is generated when it is "
       "seen, as fine as pixels need)",
       false, store_tolerance(load.tolerance_m)},
      {"--pixel-error", "PIXELS",
       "without --tolerance or --level: largest error in the picture in pixels (default: 0.5)", false,
       store_number(cells.pixel_error, {})},
      {"--unseen-error", "DEG",
       "for cells that a still picture does not show, nor their shadows: largest error as an angle from the viewer; 0: "
       "as for those that it shows (default: 0)",
       false, store_number(cells.unseen_deg, {0, 90, true})},
      {"--memory-budget", "SIZE",
       "memory for generated cells, such as 200MB or 4GB (default: 2GB, or half of the machine's memory)", false,
       store_bytes(cells.budget_bytes)},
      {"--level", "N",
       "level of detail of a folder's tiles, 0 is the finest (default: for each tile the coarsest that --pixel-error "
       "allows; the recipes of its manifest if the finest are too coarse)",
       false, store_whole(load.level, 0)},
      {"--only", "X_Y[,X_Y...]", "only these tiles, such as 0_0,0_-1 (default: all)", true,
       [&](const std::string& t) { return add_tiles(t, load.only); }},
      threads_option(load.threads),
  };
}

StoreValue store_exposure(Exposure& exposure) {
  return [&exposure](const std::string& text) -> Result<Done> {
    exposure = {.factor = 1, .is_auto = text.starts_with("auto"), .is_given = true};
    std::string_view number = std::string_view(text).substr(exposure.is_auto ? 4 : 0);
    if (exposure.is_auto && number.empty()) return Done{};
    const bool is_stops = number.starts_with('+') || number.starts_with('-');
    const auto given = number_in<double>(number.starts_with('+') ? number.substr(1) : number);
    const bool is_known = given && (is_stops ? std::abs(*given) <= 40 : *given > 0 && !exposure.is_auto);
    if (!is_known)
      return Error{"", fmt::format("expected stops with a sign such as +1 or -0.5, a factor above 0, auto, or auto+1, "
                                   "found \"{}\"",
                                   text)};
    exposure.factor = is_stops ? std::exp2(*given) : *given;
    return Done{};
  };
}

StoreValue store_switch(bool& is_on) {
  return [&is_on](const std::string&) -> Result<Done> {
    is_on = true;
    return Done{};
  };
}

std::vector<Option> sampling_options(PreviewRequest& request) {
  return {
      {"--spp", "N", "light paths for each pixel; more give less noise (default: 64)", false,
       store_whole(request.options.samples, 1)},
      {"--noise", "X",
       "fewer paths where they suffice: --spp is the most, and blocks of pixels get as many as a relative error of X, "
       "such as 0.05, needs",
       false, store_number(request.options.noise, {})},
      {"--bounces", "N", "reflections of each light path (default: 3)", false, store_whole(request.options.bounces, 0)},
      {"--roulette", "X",
       "paths that carry less than this share of light may end, and those that do not count for them; 0: none end "
       "(default: 0.1)",
       false, store_number(request.options.roulette, {0, 1, true})},
      {"--caustics", "", "light that mirrors and glass throw on matt surfaces stays sharp, with more noise", false,
       store_switch(request.options.has_caustics)},
      {"--no-denoise", "",
       "keeps the noise that is left (by default it is removed, guided by albedo, normals and depth)", false,
       store_switch(request.keeps_noise)},
  };
}

auto store_cloud_method(preview::CloudMethod& method) {
  return [&method](const std::string& text) -> Result<Done> {
    if (text != "approximate" && text != "paths")
      return Error{"", fmt::format("expected approximate or paths, not {}", text)};
    method = text == "paths" ? preview::CloudMethod::kPaths : preview::CloudMethod::kApproximate;
    return Done{};
  };
}

template <typename T, typename Parse>
StoreValue store_parsed(std::optional<T>& value, Parse parse) {
  return [&value, parse](const std::string& text) -> Result<Done> {
    Result<T> parsed = parse(text);
    if (!parsed) return parsed.error();
    value = std::move(*parsed);
    return Done{};
  };
}

std::vector<Option> shown_options(scene::ShownRequest& shown) {
  return {
      {"--layers", "NAME,...|-NAME,...",
       "layers to render: ground, roads, water, buildings, structures, things, plants, yards; a list keeps these "
       "alone, "
       "--layers=-NAME leaves one out (default: those of the scene)",
       false, store_parsed(shown.left_out, [](const std::string& text) { return parse_layers(text); })},
      {"--wood-density", "X", "for a manifest: factor on the number of trees in woods, 0 to 4 (default: the scene's)",
       false, store_parsed(shown.wood_density, [](const std::string& text) { return parse_wood_density(text); })},
      {"--lamps", "auto|on|off", "when street lamps are lit; auto: by the sun (default: the scene's)", false,
       store_parsed(shown.lamps, [](const std::string& text) { return parse_lamps(text); })},
      {"--lit-windows", "usual|none|SHARE",
       "for a manifest: share of flats, offices and shops with lit windows while it is dark, 0 to 1 (default: the "
       "scene's)",
       false, store_parsed(shown.lit_windows, [](const std::string& text) { return parse_lit_windows(text); })},
  };
}

std::vector<Option> light_options(PreviewRequest& request) {
  return {
      {"--time", "ISO",
       "date and time of the sky in UTC, or with an offset from it, such as 2026-12-21T23:00+01:00 (default: the "
       "scene's); a manifest gets lit windows by night",
       false, store_parsed(request.load.time, sky::parse_time)},
      {"--visibility", "KM", "how far one sees at sea level (default: the scene's)", false,
       store_number(request.load.air.visibility_km, {sky::kHaziest_km, sky::kClearest_km, true})},
      {"--turbidity", "T", "haze of the whole sky: 2 clear, 10 hazy (default: the scene's)", false,
       store_number(request.load.air.turbidity, {sky::kLeastTurbidity, sky::kMostTurbidity, true})},
      {"--fog", "SHARE",
       "fog fills valleys up to the height below which this share of a manifest's ground is, such as 0.2", false,
       store_number(request.fog_share, {0, 1, true})},
      {"--clouds", "clear|fair|broken|overcast|FILE.json", "clouds of the sky (default: the scene's, or fair)", false,
       store_parsed(request.load.clouds, sky::read_clouds)},
      {"--cloud-light", "approximate|paths",
       "paths: each ray to a cloud follows light through its droplets, a slow and noisy reference "
       "(default: approximate)",
       false, store_cloud_method(request.cloud_method)},
      {"--environment", "FILE.exr|.hdr", "light from a panorama instead of sun and sky", false,
       store_text(request.environment_path)},
      {"--environment-turn", "DEG", "compass bearing of the panorama's middle (default: 0, north)", false,
       store_number(request.environment_turn_deg, {-360, 360, true})},
      {"--materials", "FOLDER", "artists' textures, as for compile, which replace those of the manifest or the tiles",
       false, store_text(request.materials_folder)},
  };
}

std::vector<Option> picture_options(PreviewRequest& request) {
  return {
      {"--size", "WxH", "size in pixels (default: 1280x720)", false, store_size(request.size)},
      {"--exposure", "STOPS|X|auto",
       "brightness: stops with a sign, such as +1 or -0.5, or a factor without, on top of the adaptation of eyes to "
       "the dark; auto is metered as by a camera, auto+1 a stop more (default: auto)",
       false, store_exposure(request.exposure)},
      {"--keep-frames", "", "pictures of --path or --turntable that are there already are not rendered again", false,
       store_switch(request.keeps_frames)},
      {"--interactive", "",
       "a window to fly in while the picture refines: W A S D Q E and the mouse, shift is faster, + and - change the "
       "exposure, P writes a picture (preview.png, or -o), Esc ends",
       false, store_switch(request.is_interactive)},
      {"-o,--out", "FILE.png|FILE.exr",
       "picture to write, or with --path and --turntable pictures: frame_####.png; .exr has albedo, normals, depth and "
       "ids as further channels",
       false, store_text(request.picture_path)},
  };
}

}  // namespace

Verb preview_verb() {
  const auto request = std::make_shared<PreviewRequest>();
  Verb verb{"preview",
            "renders a picture of a manifest, a run's folder or .glb files",
            tile_options(request->load, request->cells),
            {}};
  for (std::vector<Option> options : {camera_options(request->camera), shown_options(request->load.shown),
                                      sampling_options(*request), light_options(*request), picture_options(*request)})
    for (Option& option : options) verb.options.push_back(std::move(option));
  verb.examples = {"citykiln preview out/town -o town.png",
                   "citykiln preview out/town --view street --time 2026-12-21T22:00 -o night.png",
                   "citykiln preview out/town/scene.kiln --eye 0,-200,+60 --look 0,0,+5 --spp 256 -o town.exr",
                   "citykiln preview out/town --turntable 100 --spp 16 -o frame_###.png"};
  verb.interrupted = "no picture was changed, except those that were finished";
  verb.run = [request](const Console& console) { return run_preview(*request, console); };
  return verb;
}

}  // namespace citykiln::commands
