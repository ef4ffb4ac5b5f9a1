// citykiln preview … -o picture.png: renders a picture of a manifest, a run's folder or .glb files.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "compiler/commands/ground_height.h"
#include "compiler/commands/load_cells.h"
#include "compiler/commands/load_tiles.h"
#include "compiler/commands/verb.h"
#include "compiler/commands/view_options.h"
#include "compiler/sky/plan.h"
#include "compiler/spec.h"
#include "preview/render.h"

namespace citykiln::commands {
namespace {

struct Request {
  LoadRequest load;
  CellRequest cells;
  std::string picture_path, view = "overview";
  std::optional<GivenPoint> eye, look_at;             ///< Plane metres.
  std::optional<GivenPoint> eye_lonlat, look_lonlat;  ///< Longitude and latitude in degrees, height in metres.
  std::optional<double> fov_deg;
  PictureSize size;
  preview::Options options;
};

Result<preview::Camera> camera_of(const Request& request, const Loaded& loaded, const GroundHeight& ground_m,
                                  const Console& console) {
  const auto point = [&](const auto& in_plane, const auto& lonlat) {
    return point_of(in_plane, lonlat, loaded.header, ground_m);
  };
  const Result<std::optional<Vec3>> eye = point(request.eye, request.eye_lonlat);
  const Result<std::optional<Vec3>> look_at = point(request.look_at, request.look_lonlat);
  if (!eye) return eye.error();
  if (!look_at) return look_at.error();
  if (eye->has_value() != look_at->has_value()) return Error{"", "--eye and --look must be given together"};
  if (eye->has_value()) note_if_below_ground(**eye, ground_m, console);

  Result<preview::Camera> camera =
      eye->has_value() ? Result(preview::Camera{**eye, **look_at}) : preview::named_view(loaded.tiles, request.view);
  if (camera && request.fov_deg) camera->vertical_fov_deg = *request.fov_deg;
  return camera;
}

/// The scene's sky, or the sky at another time; without a manifest at 45° north.
Result<sky::Sky> sky_of(const Request& request, const std::optional<scene::Header>& header) {
  if (header && request.load.time.empty()) return header->sky;
  return sky::plan(header ? header->origin : map::LonLat{0, 45}, request.load.time);
}

std::size_t budget_bytes_of(const CellRequest& request) {
  return request.budget_bytes > 0 ? request.budget_bytes : default_budget_bytes();
}

/// What is rendered: tiles, or cells.
struct Rendered {
  Loaded loaded;  ///< Without tiles for cells.
  preview::Camera camera;
  sky::Sky sky;
  std::shared_ptr<const preview::CellSource> cells;  ///< Null for tiles.
  std::vector<preview::StreetLamp> lamps;

  std::size_t tiles() const { return cells ? cells->scene().chunks.size() : loaded.tiles.size(); }
  preview::World world(const CellRequest& request) const {
    if (!cells) return preview::World(loaded.tiles, camera.eye);
    return preview::World(cells, camera.eye, budget_bytes_of(request));
  }
};

Result<Rendered> render_tiles(const Request& request, const Console& console) {
  Result<Loaded> loaded = load_tiles(request.load, console.progress());
  if (!loaded) return loaded.error();
  const Result<sky::Sky> sky = sky_of(request, loaded->header);
  if (!sky) return sky.error();
  const GroundHeight ground_m = [&](Vec2 place) { return ground_height_m(loaded->tiles, place); };
  const Result<preview::Camera> camera = camera_of(request, *loaded, ground_m, console);
  if (!camera) return camera.error();
  std::vector<preview::StreetLamp> lamps;
  if (sky::is_night(*sky)) lamps = preview::lamps_of(loaded->tiles);
  return Rendered{std::move(*loaded), *camera, *sky, nullptr, std::move(lamps)};
}

/// A view that was chosen on coarse ground: near the ground its height above that is kept.
preview::Camera on_ground(preview::Camera camera, std::span<const bake::BakedTile> coarse,
                          const GroundHeight& ground_m) {
  constexpr double kNear_m = 5;
  const std::optional<double> low_m = ground_height_m(coarse, in_plan(camera.eye));
  if (!low_m || camera.eye.z - *low_m > kNear_m) return camera;
  if (const std::optional<double> exact_m = ground_m(in_plan(camera.eye))) {
    camera.eye.z += *exact_m - *low_m, camera.look_at.z += *exact_m - *low_m;
  }
  return camera;
}

Result<Rendered> render_cells(const Request& request, const Console& console) {
  Result<scene::Scene> scene = read_scene(request.load);
  if (!scene) return scene.error();
  const GroundHeight ground_m = [&](Vec2 place) { return ground_height_m(*scene, place); };
  Loaded coarse{{}, scene->header};
  const bool has_eye = request.eye || request.eye_lonlat;
  if (!has_eye) coarse.tiles = coarse_tiles(*scene, request.load.threads);
  Result<preview::Camera> camera = camera_of(request, coarse, ground_m, console);
  if (!camera) return camera.error();
  if (!has_eye) *camera = on_ground(*camera, coarse.tiles, ground_m);
  const sky::Sky sky = scene->header.sky;
  std::vector<preview::StreetLamp> lamps;
  if (sky::is_night(sky)) lamps = preview::lamps_of(*scene, request.load.threads);
  coarse.tiles = {};
  return Rendered{std::move(coarse), *camera, sky,
                  cells_for(std::move(*scene), *camera, request.size.height, request.cells.pixel_error),
                  std::move(lamps)};
}

Result<Exit> run(const Request& request, const Console& console) {
  if (request.picture_path.empty()) return Error{"", "no picture is given; add -o FILE.png or -o FILE.exr"};
  const OnProgress on_progress = console.progress();
  const Result<Rendered> rendered =
      asks_for_cells(request.load) ? render_cells(request, console) : render_tiles(request, console);
  if (!rendered) return rendered.error();
  const preview::Camera& camera = rendered->camera;
  preview::Options options = request.options;
  options.on_progress = [&](double share) { on_progress("render", share); };
  options.width = request.size.width, options.height = request.size.height;
  options.threads = request.load.threads;
  options.exposure *= preview::adapted_exposure(rendered->sky);
  const preview::World world = rendered->world(request.cells);
  const preview::Lights lights(sky::generate(rendered->sky), rendered->lamps);
  const preview::Image image = preview::render(world, lights, camera, options);
  const Result<Done> written = preview::write_image(image, request.picture_path);
  if (!written) return written.error();

  console.print_line(fmt::format("{}: {} x {} pixels, {} paths each, {} tiles", request.picture_path, image.width,
                                 image.height, options.samples, rendered->tiles()));
  std::string cells;
  if (const auto counters = world.counters()) {
    console.print_line(text_of(*counters, budget_bytes_of(request.cells)));
    cells = ", " + json_of(*counters, budget_bytes_of(request.cells));
  }
  console.print_json(fmt::format(R"({{"eye": [{}, {}, {}], "look": [{}, {}, {}], "fov_deg": {}, "tiles": {}{}}})",
                                 camera.eye.x, camera.eye.y, camera.eye.z, camera.look_at.x, camera.look_at.y,
                                 camera.look_at.z, camera.vertical_fov_deg, rendered->tiles(), cells));
  return Exit::kDone;
}

std::vector<Option> tile_options(LoadRequest& load, CellRequest& cells) {
  return {
      {"inputs", "SCENE.kiln|OUT|FILE.glb...", "what to render: a manifest, a run's folder, or .glb files", true,
       append_text(load.paths)},
      {"--tolerance", "M",
       "bakes a manifest at this tolerance in metres before rendering (default: each cell is generated when it is "
       "seen, as fine as pixels need)",
       false, store_tolerance(load.tolerance_m)},
      {"--pixel-error", "PIXELS", "without --tolerance: largest error in the picture in pixels (default: 0.5)", false,
       store_number(cells.pixel_error, {})},
      {"--memory-budget", "SIZE",
       "memory for generated cells, such as 200MB or 4GB (default: 2GB, or half of the machine's memory)", false,
       store_bytes(cells.budget_bytes)},
      {"--level", "N", "level of detail of a folder's tiles, 0 is the finest (default: 0)", false,
       store_whole(load.level, 0)},
      {"--only", "X_Y[,X_Y...]", "only these tiles, such as 0_0,0_-1 (default: all)", true,
       [&](const std::string& t) { return add_tiles(t, load.only); }},
      threads_option(load.threads),
  };
}

std::vector<Option> camera_options(Request& request) {
  return {
      {"--view", "NAME", "overview, street, top, north, south, east, west or low (default: overview)", false,
       store_text(request.view)},
      {"--eye", "X,Y,Z",
       "place of the viewer in plane metres, such as 0,-200,150, or 0,-200,+2 for 2 m above the ground; needs --look",
       false, store_point(request.eye)},
      {"--look", "X,Y,Z", "place in the middle of the picture, such as 0,0,20", false, store_point(request.look_at)},
      {"--eye-lonlat", "LON,LAT,HEIGHT", "place of the viewer in degrees and metres, such as 7.42,43.73,150", false,
       store_point(request.eye_lonlat)},
      {"--look-lonlat", "LON,LAT,HEIGHT", "place in the middle of the picture in degrees and metres", false,
       store_point(request.look_lonlat)},
      {"--fov", "DEG", "vertical field of view in degrees (default: 45)", false,
       store_number(request.fov_deg, kFieldsOfView_deg)},
  };
}

std::vector<Option> picture_options(Request& request) {
  return {
      {"--size", "WxH", "size in pixels (default: 1280x720)", false, store_size(request.size)},
      {"--spp", "N", "light paths for each pixel; more give less noise (default: 64)", false,
       store_whole(request.options.samples, 1)},
      {"--bounces", "N", "reflections of each light path (default: 3)", false, store_whole(request.options.bounces, 0)},
      {"--exposure", "X",
       "factor on the brightness; the adaptation of eyes to the dark is added by itself (default: 1)", false,
       store_number(request.options.exposure, {})},
      {"--time", "ISO",
       "date and time of the sky in UTC, such as 2026-12-21T22:00 (default: the scene's); a manifest gets lit windows "
       "by "
       "night",
       false, store_text(request.load.time)},
      {"-o,--out", "FILE.png|FILE.exr", "picture to write", false, store_text(request.picture_path)},
  };
}

}  // namespace

Verb preview_verb() {
  const auto request = std::make_shared<Request>();
  Verb verb{"preview",
            "renders a picture of a manifest, a run's folder or .glb files",
            tile_options(request->load, request->cells),
            {}};
  for (Option& option : camera_options(*request)) verb.options.push_back(std::move(option));
  for (Option& option : picture_options(*request)) verb.options.push_back(std::move(option));
  verb.examples = {"citykiln preview out/town -o town.png",
                   "citykiln preview out/town --view street --time 2026-12-21T22:00 -o night.png",
                   "citykiln preview out/town/scene.kiln --eye 0,-200,+60 --look 0,0,+5 --spp 256 -o town.exr"};
  verb.run = [request](const Console& console) { return run(*request, console); };
  return verb;
}

}  // namespace citykiln::commands
