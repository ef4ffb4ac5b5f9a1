// citykiln invent --kind KIND -o OUT: invents a world, as a map, heights and settings that compile takes.
#include "compiler/invent/invent.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/commands/verb.h"
#include "compiler/invent/tiles/tile_set.h"
#include "compiler/invent/write/encode_heights.h"
#include "compiler/invent/write/write_map.h"
#include "compiler/source/read_texts.h"
#include "exporters/file.h"
#include "exporters/output_folder.h"

namespace citykiln::commands {
namespace {

namespace fs = std::filesystem;

struct InventRequest {
  invent::AskedSettings asked;
  std::string settings_path, tile_set_path, folder;
};

Result<std::string> text_in(const std::string& path) {
  const Result<std::vector<std::byte>> bytes = exporters::read_file(path);
  if (!bytes) return bytes.error();
  return std::string(source::without_byte_order_mark({reinterpret_cast<const char*>(bytes->data()), bytes->size()}));
}

Result<invent::InventSettings> settings_of(const InventRequest& request) {
  if (request.settings_path.empty()) return invent::read_invent_settings("", "", request.asked);
  const Result<std::string> text = text_in(request.settings_path);
  if (!text) return text.error();
  if (text->empty()) return Error{request.settings_path, "the file is empty; expected a JSON object of settings"};
  return invent::read_invent_settings(*text, request.settings_path, request.asked);
}

Result<invent::TileSet> tile_set_of(const InventRequest& request) {
  if (request.tile_set_path.empty()) return invent::read_tile_set(invent::shipped_tile_set(), "city.tiles");
  const Result<std::string> text = text_in(request.tile_set_path);
  if (!text) return text.error();
  return invent::read_tile_set(*text, request.tile_set_path);
}

/// The settings with which compile reads the world.
std::string spec_text(const invent::InventSettings& settings, const std::string& folder) {
  const nlohmann::ordered_json spec = {{"map", folder + "/map.osm.pbf"},
                                       {"dem", folder + "/heights.tif"},
                                       {"origin", fmt::format("{},{}", settings.place.lon_deg, settings.place.lat_deg)},
                                       {"seed", settings.seed},
                                       {"lods", "0.1,0.5,1.2,2.5,12.5"}};
  return spec.dump(2) + "\n";
}

Result<invent::MapCounts> write_world(const invent::InventedWorld& world, const invent::InventSettings& settings,
                                      const std::string& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) return Error{folder, "cannot be created: " + problem.message()};
  const invent::WorldPlace place(settings.place);
  const auto counts = invent::write_map(world.map, place, settings.side_m, folder + "/map.osm.pbf");
  if (!counts) return counts.error();
  const auto write = [&](const char* name, std::span<const std::byte> bytes) {
    return exporters::write_file(folder + "/" + name, bytes);
  };
  if (auto done = write("heights.tif", invent::encode_heights(world.terrain, place)); !done) return done.error();
  if (auto done = write("invent.json", exporters::bytes_of(invent::text_of(settings))); !done) return done.error();
  if (auto done = write("spec.json", exporters::bytes_of(spec_text(settings, folder))); !done) return done.error();
  return *counts;
}

void print_world(const invent::InventedWorld& world, const invent::InventSettings& settings,
                 const invent::MapCounts& counts, const std::string& folder, double seconds, const Console& console) {
  console.print_line(fmt::format("{}: {} of {:.0f} m, seed {}: {} nodes, {} ways, {} relations, invented in {:.2f} s",
                                 folder, invent::name_of(settings.kind), settings.side_m, settings.seed, counts.nodes,
                                 counts.ways, counts.relations, seconds));
  const invent::TileGrid& tiles = world.tiles;
  if (tiles.columns > 0)
    console.print_line(
        fmt::format("{} x {} cells: {} fixed by noise, {} contradictions, {} decisions taken back; "
                    "road network: {} parts, connected to {}",
                    tiles.columns, tiles.rows, tiles.fixed, tiles.contradictions, tiles.backtracks, tiles.road_parts,
                    tiles.road_parts_left));
  console.print_line(fmt::format("  citykiln compile --spec {0}/spec.json -o {0}/run", folder));
  if (settings.spot.edge_m > 0)
    console.print_line(fmt::format("  citykiln preview {0}/run --eye {1:.1f},{2:.1f},+1.7 --look {1:.1f},{3:.1f},+1.5",
                                   folder, world.spot.x, world.spot.y, world.spot.y + 30));
  nlohmann::ordered_json summary = {{"folder", folder},
                                    {"kind", invent::name_of(settings.kind)},
                                    {"seed", settings.seed},
                                    {"size_m", settings.side_m},
                                    {"nodes", counts.nodes},
                                    {"ways", counts.ways},
                                    {"relations", counts.relations},
                                    {"seconds", seconds}};
  if (tiles.columns > 0)
    summary["tiles"] = {{"columns", tiles.columns},
                        {"rows", tiles.rows},
                        {"fixed", tiles.fixed},
                        {"not_fixed", tiles.not_fixed},
                        {"contradictions", tiles.contradictions},
                        {"backtracks", tiles.backtracks},
                        {"road_parts", tiles.road_parts},
                        {"road_parts_left", tiles.road_parts_left}};
  console.print_json(summary.dump());
}

Result<Exit> invent_world(const InventRequest& request, const Console& console) {
  if (request.folder.empty()) return Error{"", "no output folder is given; add -o FOLDER"};
  const auto begin = std::chrono::steady_clock::now();
  const Result<invent::InventSettings> settings = settings_of(request);
  if (!settings) return settings.error();
  const Result<invent::TileSet> tile_set = tile_set_of(request);
  if (!tile_set) return tile_set.error();
  const OnProgress on_progress = console.progress();
  on_progress("invent", 0);
  const Result<invent::InventedWorld> world = invent::invent(*settings, *tile_set);
  if (!world) return Error{request.tile_set_path, world.error().message};
  on_progress("write", 0);
  const InterruptNotice notice("the world is not whole; the same command writes it again");
  const Result<invent::MapCounts> counts = write_world(*world, *settings, request.folder);
  if (!counts) return counts.error();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  print_world(*world, *settings, *counts, request.folder, seconds, console);
  return Exit::kDone;
}

Result<Done> store_kind(const std::string& text, invent::AskedSettings& asked) {
  asked.kind = invent::world_kind_named(text);
  if (!asked.kind) return Error{"", fmt::format("expected village, town, city, tiles or forest, found \"{}\"", text)};
  return Done{};
}

Result<Done> store_seed(const std::string& text, invent::AskedSettings& asked) {
  const Result<std::int64_t> seed = parse_whole(text, 0);
  if (!seed) return seed.error();
  asked.seed = static_cast<std::uint64_t>(*seed);
  return Done{};
}

Result<Done> store_place(const std::string& text, invent::AskedSettings& asked) {
  const Result<std::vector<double>> place = parse_numbers(text, 2);
  if (!place) return place.error();
  if (!(std::abs((*place)[0]) <= 179 && std::abs((*place)[1]) <= 80))
    return Error{"", fmt::format("expected longitude,latitude up to 179 and 80 degrees, found \"{}\"", text)};
  asked.place = {(*place)[0], (*place)[1]};
  return Done{};
}

}  // namespace

Verb invent_verb() {
  const auto request = std::make_shared<InventRequest>();
  invent::AskedSettings* const asked = &request->asked;
  Verb verb{"invent", "invents a world: a map, heights and settings, which compile takes as any other", {}, {}};
  verb.options = {
      {"--kind", "village|town|city|tiles|forest", "the kind of world (default: town)", false,
       [asked](const std::string& text) { return store_kind(text, *asked); }},
      {"--seed", "N", "the world is a function of this number (default: 1)", false,
       [asked](const std::string& text) { return store_seed(text, *asked); }},
      {"--size", "M",
       "side of the mapped square in metres, rounded up to a multiple of 256 (default: 1024; city: 2048)", false,
       store_number(asked->side_m, {1, invent::kMostSide_m, true})},
      {"--place", "LON,LAT", "the middle of the world in degrees (default: 12.3,48.7)", false,
       [asked](const std::string& text) { return store_place(text, *asked); }},
      {"--settings", "FILE.json", "settings of terrain, country and tiles, as in OUT/invent.json", false,
       store_text(request->settings_path)},
      {"--tileset", "FILE", "for tiles: the tiles of which the city is made", false,
       store_text(request->tile_set_path)},
      {"-o,--out", "FOLDER", "folder for map.osm.pbf, heights.tif, spec.json and invent.json", false,
       store_text(request->folder)},
  };
  verb.examples = {"citykiln invent --kind forest --seed 7 -o out/forest",
                   "citykiln compile --spec out/forest/spec.json -o out/forest/run"};
  verb.run = [request](const Console& console) { return invent_world(*request, console); };
  return verb;
}

}  // namespace citykiln::commands
