// citykiln inspect FILE: what is in a manifest, a tile, a map; and any layer of it for QGIS.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compiler/bake/merge.h"
#include "compiler/commands/atlas_sheet.h"
#include "compiler/commands/console.h"
#include "compiler/commands/layers/geojson.h"
#include "compiler/commands/layers/lots_layer.h"
#include "compiler/commands/layers/map_layers.h"
#include "compiler/commands/layers/scene_layers.h"
#include "compiler/commands/materials_sheet.h"
#include "compiler/commands/plant_sheet.h"
#include "compiler/commands/run_paths.h"
#include "compiler/commands/sheet.h"
#include "compiler/commands/verb.h"
#include "compiler/contract/findings/assumption_names.h"
#include "compiler/contract/result.h"
#include "compiler/make_header.h"
#include "compiler/map/locate.h"
#include "compiler/map/plane/degrees.h"
#include "compiler/map/ways/private_ways.h"
#include "compiler/roads/junctions/layers.h"
#include "compiler/source/read_osm.h"
#include "compiler/things/generate.h"
#include "exporters/file.h"
#include "exporters/finish_commit.h"
#include "exporters/gltf/glb.h"
#include "exporters/gltf/material_names.h"
#include "exporters/gltf/write/encode_tile.h"
#include "exporters/kiln/manifest.h"
#include "exporters/output_folder.h"
#include "exporters/run_files.h"
#include "preview/render.h"

namespace citykiln::commands {
namespace {

using OrderedJson = nlohmann::ordered_json;

// A picture of things, each at three tolerances.

// The things that a sheet shows, and where it is written.
struct ThingsSheet {
  std::string folder;              ///< A folder with a table and rules, as for compile; "" for the shipped ones alone.
  std::vector<std::string> names;  ///< Names of rows of the table; empty for all.
  std::string path;                ///< The picture to write.
};

constexpr std::array kSheetTolerances_m = {0.02, 0.1, 0.5};
constexpr int kTolerances = static_cast<int>(kSheetTolerances_m.size());
constexpr int kThingPixels = 180, kThingsInRow = 4, kThingSamples = 24;

// The form of a row without tags.
things::Form default_form(const map::ThingRow& row) {
  const std::string value = row.tags.empty() ? "" : row.tags.front().front().value;
  return {.kind = row.name,
          .width_m = row.width.default_m,
          .depth_m = row.depth.default_m,
          .height_m = row.height.default_m,
          .value = value == "*" ? "" : value,
          .text = "30"};
}

bake::BakedTile tile_of_thing(const things::Form& form, const things::Kind& kind, double tolerance_m) {
  const things::GeneratedThing thing = things::generate(form, kind, 0, false, tolerance_m);
  bake::BakedTile tile;
  tile.features = {OsmId{}};
  tile.primitives = {ground_square(materials::Material::kPaving,
                                   static_cast<float>(20 * std::max({form.width_m, form.depth_m, form.height_m})))};
  if (!thing.meshes.empty())
    tile.instanced.push_back({.name = form.kind,
                              .primitives = bake::instanced_primitives(thing.meshes, bake::Layer::kProps),
                              .translations = {{0, 0, 0}},
                              .rotations = {{0, 0, 0, 1}},
                              .scales = {1},
                              .features = {0}});
  tile.textures = bake::textures_shown(tile, tolerance_m, materials::TextureCache(1));
  return tile;
}

// From in front of it, a little to the right.
preview::Camera camera_before(const things::Form& form) {
  const double size_m = length(Vec3{form.width_m, form.depth_m, form.height_m});
  const Vec3 middle{0, 0, form.height_m / 2};
  return {middle + unit(Vec3{0.5, -1, 0.25}) * (1.7 * size_m), middle, 38};
}

// The rows of the table with these names, in the order of the table; all of them if no name is given.
Result<std::vector<map::ThingRow>> rows_with(const std::vector<map::ThingRow>& table,
                                             const std::vector<std::string>& names) {
  if (names.empty()) return table;
  for (const std::string& name : names)
    if (std::ranges::find(table, name, &map::ThingRow::name) == table.end())
      return Error{"--kind", fmt::format("no row of the table of things is called \"{}\"", name)};
  std::vector<map::ThingRow> rows;
  std::ranges::copy_if(table, std::back_inserter(rows),
                       [&](const map::ThingRow& row) { return std::ranges::find(names, row.name) != names.end(); });
  return rows;
}

// Draws a thing at all tolerances, in the place of its number.
void draw_thing(const map::ThingRow& row, const things::Kind& kind, int number, const sky::Sky& sky,
                preview::Image& sheet) {
  preview::Options options;
  options.width = options.height = kThingPixels, options.samples = kThingSamples;
  const things::Form form = default_form(row);
  for (int k = 0; k < kTolerances; ++k) {
    const bake::BakedTile tile = tile_of_thing(form, kind, kSheetTolerances_m[static_cast<std::size_t>(k)]);
    put_picture(preview::render(std::span(&tile, 1), sky, camera_before(form), options),
                kThingPixels * (number % kThingsInRow * kTolerances + k), kThingPixels * (number / kThingsInRow),
                sheet);
  }
}

// Draws things in their default sizes at 2, 10 and 50 cm, four things in a row, and prints a line for each row of the
// sheet. Errors: a name that the table lacks, those of the table and the rules, and of writing the picture. Takes
// about a second a thing.
Result<Done> draw_things_sheet(const ThingsSheet& asked, const Console& console) {
  CompileSpec spec;
  spec.things_folder = asked.folder;
  spec.cars = cars::kUsualCars;
  const Result<things::Catalogue> catalogue = read_things(spec);
  if (!catalogue) return catalogue.error();
  const Result<things::Kinds> kinds = things::kinds_of(*catalogue);
  if (!kinds) return kinds.error();
  const Result<std::vector<map::ThingRow>> drawn = rows_with(catalogue->table, asked.names);
  if (!drawn) return drawn.error();
  const sky::Sky sky = sheet_sky();
  const int rows = (static_cast<int>(drawn->size()) + kThingsInRow - 1) / kThingsInRow;
  preview::Image sheet = empty_sheet(kThingPixels * kThingsInRow * kTolerances, kThingPixels * rows);
  std::vector<std::string> lines(static_cast<std::size_t>(rows));
  for (int i = 0; i < static_cast<int>(drawn->size()); ++i) {
    const map::ThingRow& row = (*drawn)[static_cast<std::size_t>(i)];
    lines[static_cast<std::size_t>(i / kThingsInRow)] += " " + row.name;
    draw_thing(row, kinds->at(row.name), i, sky, sheet);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) console.print_line(fmt::format("row {}:{}", i + 1, lines[i]));
  return preview::write_image(sheet, asked.path);
}

struct InspectRequest {
  std::string path, layer, geojson_path;
  ThingsSheet sheet;
  std::string picture;
  bool draws_materials = false, draws_atlases = false;
};

// ---- descriptions ----

/// The number of things of each kind.
OrderedJson things_json(const scene::Chunk& chunk) {
  std::map<std::string, int> counts;
  for (const things::Thing& thing : chunk.things) ++counts[thing.form.kind];
  return counts;
}

OrderedJson chunk_json(const scene::Chunk& chunk) {
  return {{"tile", to_string(chunk.tile)},
          {"heights", fmt::format("{} x {} every {} by {} m", chunk.heights.columns, chunk.heights.rows,
                                  chunk.heights.step_m.x, chunk.heights.step_m.y)},
          {"land_cover_polygons", chunk.surfaces.size()},
          {"roads", chunk.roads.size()},
          {"junctions", chunk.junctions.size()},
          {"bridges", chunk.bridges.size()},
          {"tunnels", chunk.tunnels.size()},
          {"buildings", chunk.buildings.size()},
          {"trees", chunk.trees.size()},
          {"woods", chunk.woods.size()},
          {"barriers", chunk.barriers.size()},
          {"lamps", chunk.lamps.size()},
          {"sports_fields", chunk.pitches.size()},
          {"things", things_json(chunk)}};
}

/// The numbers of elements of which something is assumed, by the name of the assumption.
OrderedJson assumed_json(const std::map<OsmId, Assumptions>& assumed) {
  OrderedJson json = OrderedJson::object();
  for (const auto& [id, set] : assumed)
    for (const std::string& name : names_in(set)) json[name] = json.value(name, 0) + 1;
  return json;
}

/// The assumptions of the elements of a scene.
std::map<OsmId, Assumptions> assumed_in(const scene::Scene& scene) {
  std::map<OsmId, Assumptions> assumed;
  const auto add = [&](const auto& objects) {
    for (const auto& object : objects)
      if (object.assumed != kNoAssumptions) assumed[object.id.osm] |= object.assumed;
  };
  for (const scene::Chunk& chunk : scene.chunks)
    add(chunk.roads), add(chunk.bridges), add(chunk.tunnels), add(chunk.buildings);
  return assumed;
}

OrderedJson describe(const scene::Scene& scene) {
  const scene::Header& header = scene.header;
  OrderedJson json = {
      {"form", "manifest"},
      {"origin_lonlat_deg", {header.origin.lon_deg, header.origin.lat_deg}},
      {"region_m", {header.extent.min.x, header.extent.min.y, header.extent.max.x, header.extent.max.y}},
      {"tile_m", header.tile_m},
      {"seed", header.seed},
      {"resampling_error_m", header.resampling_error_m},
      {"time", sky::text_of(header.sky.time)},
      {"climate", climate::name_of(header.climate.origin_class)},
      {"sources", header.sources},
      {"attribution", header.attributions},
      {"assumed", assumed_json(assumed_in(scene))}};
  json["tiles"] = OrderedJson::array();
  for (const scene::Chunk& chunk : scene.chunks) json["tiles"].push_back(chunk_json(chunk));
  json["streams"] = OrderedJson::array();
  for (const exporters::StreamSize& size : exporters::stream_sizes_of(scene))
    json["streams"].push_back(
        {{"stream", size.name}, {"raw_bytes", size.raw_bytes}, {"packed_bytes", size.packed_bytes}});
  return json;
}

/// The assumptions of the elements of a tile.
std::map<OsmId, Assumptions> assumed_in(const bake::BakedTile& tile) {
  std::map<OsmId, Assumptions> assumed;
  for (std::size_t i = 0; i < tile.attributes.size(); ++i) assumed[tile.features[i]] = tile.attributes[i].assumed;
  return assumed;
}

OrderedJson describe(const bake::BakedTile& tile) {
  OrderedJson json = {{"form", "glb"},
                      {"tile", to_string(tile.tile)},
                      {"origin_m", {tile.origin.x, tile.origin.y, tile.origin.z}},
                      {"tolerance_m", tile.tolerance_m},
                      {"error_m", tile.error_m},
                      {"triangles", exporters::triangles_of(tile)},
                      {"instances", exporters::instances_of(tile)},
                      {"features", tile.features.size() - 1},
                      {"assumed", assumed_json(assumed_in(tile))}};
  json["materials"] = OrderedJson::object();
  for (const bake::Primitive& primitive : tile.primitives) {
    OrderedJson& count = json["materials"][exporters::material_name(bake::key_of(primitive), tile.textures)];
    count = (count.is_null() ? 0 : count.get<std::size_t>()) + primitive.triangles.size();
  }
  json["instanced"] = OrderedJson::object();
  for (const bake::InstancedMesh& instanced : tile.instanced)
    json["instanced"][instanced.name] = instanced.translations.size();
  return json;
}

OrderedJson describe(const source::OsmData& osm, std::span<const roads::RoadLayer> off_ground, const Report& report) {
  OrderedJson json = {{"form", "map"},
                      {"tagged_nodes", osm.nodes.size()},
                      {"ways", osm.ways.size()},
                      {"areas", osm.areas.size()},
                      {"relations", osm.relations.size()},
                      {"node_box_deg", map::rounded_degrees(osm.node_box)}};
  if (osm.header_box) json["header_box_deg"] = map::rounded_degrees(*osm.header_box);
  json["road_layers_off_ground"] = OrderedJson::array();
  for (const roads::RoadLayer& layer : off_ground)
    json["road_layers_off_ground"].push_back({{"layer", layer.layer},
                                              {"passage", layer.passage == map::Passage::kBridge ? "bridge" : "tunnel"},
                                              {"roads", layer.roads.size()},
                                              {"junctions", layer.junctions.size()}});
  json["diagnoses"] = OrderedJson::object();
  for (const auto& [code, count] : report.counts()) json["diagnoses"][std::string(name_of(code))] = count;
  return json;
}

/// Prints one line for each name and value, and one line for each item of a list of objects.
void print_line(const OrderedJson& json, const Console& console) {
  for (const auto& [key, value] : json.items()) {
    if (!value.is_array() || value.empty() || !value.front().is_object()) {
      console.print_line(fmt::format("{:<20} {}", key, value.is_string() ? value.get<std::string>() : value.dump()));
      continue;
    }
    console.print_line(fmt::format("{:<20} {}", key, value.size()));
    for (const OrderedJson& item : value) console.print_line("  " + item.dump());
  }
}

// ---- files and layers ----

Result<Done> write_layer(const InspectRequest& request, const Result<Layer>& layer, const map::Plane& plane,
                         const std::vector<std::string>& attributions) {
  if (!layer) return layer.error();
  return exporters::write_file(request.geojson_path, exporters::bytes_of(geojson_of(*layer, plane, attributions)));
}

Result<OrderedJson> inspect_manifest(const InspectRequest& request) {
  const Result<scene::Scene> scene = exporters::read_manifest(request.path, {});
  if (!scene) return scene.error();
  if (!request.layer.empty()) {
    const map::Plane plane(scene->header.origin);
    const Result<Done> done = write_layer(request, layer_of(*scene, request.layer), plane, scene->header.attributions);
    if (!done) return done.error();
  }
  return describe(*scene);
}

Result<OrderedJson> inspect_tile(const InspectRequest& request) {
  if (!request.layer.empty()) return Error{request.path, "--layer needs a map or a manifest (.kiln), not a .glb"};
  const Result<bake::BakedTile> tile = exporters::read_glb(request.path);
  if (!tile) return tile.error();
  return describe(*tile);
}

Result<OrderedJson> inspect_map(const InspectRequest& request) {
  Report report;
  const Result<source::OsmData> osm = source::read_osm(request.path, 0, report);
  if (!osm) return osm.error();
  const source::LonLatBox box = map::choose_box(*osm, {});
  const map::Plane plane(map::default_origin(box));
  const map::Features features = map::locate(*osm, plane, box, {}, report);
  if (!request.layer.empty()) {
    const Result<Layer> layer = request.layer == "lots" ? lots_layer(features, map::private_ways(*osm), plane)
                                                        : layer_of(features, request.layer);
    const Result<Done> done = write_layer(request, layer, plane, {"© OpenStreetMap contributors"});
    if (!done) return done.error();
  }
  const std::vector<roads::RoadLayer> off_ground = roads::plan_layers(features, report);
  return describe(*osm, off_ground, report);
}

/// Copies findings.json of the run that a folder, or its manifest, belongs to.
Result<Done> write_findings(const InspectRequest& request) {
  const std::string folder = folder_of(request.path);
  std::error_code none;
  if (!std::filesystem::is_directory(folder, none))
    return Error{request.path, "has no findings; expected the folder of a run, or the scene.kiln in it"};
  if (const Result<Done> done = exporters::finish_commit(folder); !done) return done.error();
  const Result<std::vector<std::byte>> findings = exporters::read_file(folder + "/" + exporters::kFindingsName);
  if (!findings) return findings.error();
  return exporters::write_file(request.geojson_path, *findings);
}

/// Error: a picture or layer could not be written.
Result<Done> check_outputs(const InspectRequest& asked) {
  for (const std::string& picture : {asked.sheet.path, asked.picture})
    if (!picture.empty())
      if (const auto fits = check_output_file(picture, {".png", ".exr"}); !fits) return fits;
  return asked.geojson_path.empty() ? Done{} : check_output_file(asked.geojson_path);
}

Result<Exit> run_inspect(const InspectRequest& asked, const Console& console) {
  if (const Result<Done> fits = check_outputs(asked); !fits) return fits.error();
  if (!asked.sheet.path.empty()) {
    const Result<Done> done = draw_things_sheet(asked.sheet, console);
    return done ? Result<Exit>(Exit::kDone) : done.error();
  }
  if (asked.draws_materials) {
    if (asked.picture.empty()) return Error{"--materials", "expected -o FILE.png too"};
    const Result<Done> done = draw_materials_sheet(asked.picture, console);
    return done ? Result<Exit>(Exit::kDone) : done.error();
  }
  if (asked.path.empty())
    return Error{"", "no file is given; expected a .kiln, a .glb, a map, the folder of a run, or a species with -o"};
  if (asked.draws_atlases) {
    if (asked.picture.empty()) return Error{"--atlases", "expected -o FILE.png too"};
    const Result<Done> done = draw_atlas_sheet(asked.path, asked.picture, console);
    return done ? Result<Exit>(Exit::kDone) : done.error();
  }
  if (!asked.picture.empty()) {
    const Result<Done> done = draw_plant_sheet({asked.path, asked.picture}, console);
    return done ? Result<Exit>(Exit::kDone) : done.error();
  }
  if (asked.layer.empty() != asked.geojson_path.empty())
    return Error{"", "--layer and --geojson must be given together"};
  if (asked.layer == "findings") {
    if (const Result<Done> done = write_findings(asked); !done) return done.error();
    console.print_line(fmt::format("{}: layer findings", asked.geojson_path));
    return Exit::kDone;
  }
  const Result<std::string> path = find_committed_manifest(asked.path);
  if (!path) return path.error();
  InspectRequest request = asked;
  request.path = *path;
  const Result<OrderedJson> json = request.path.ends_with(".kiln")  ? inspect_manifest(request)
                                   : request.path.ends_with(".glb") ? inspect_tile(request)
                                                                    : inspect_map(request);
  if (!json) return json.error();
  if (!request.geojson_path.empty()) {
    console.print_line(fmt::format("{}: layer {}", request.geojson_path, request.layer));
    return Exit::kDone;
  }
  print_line(*json, console);
  console.print_json(json->dump(1));
  return Exit::kDone;
}

}  // namespace

Verb inspect_verb() {
  const auto request = std::make_shared<InspectRequest>();
  Verb verb{
      "inspect",
      "prints the contents of a manifest, a .glb or a map, or writes a layer of it as GeoJSON, or draws things or a "
      "plant",
      {},
      {}};
  verb.options = {
      {"file", "FILE",
       "what to inspect: a .kiln, a .glb, a map or the folder of a run; with -o a species: the name of a shipped one, "
       "a "
       "plant's file or a folder of species",
       false, store_text(request->path)},
      {"--layer", "NAME",
       "layer to write: roads, junctions, areas, buildings or plants; of a map also lots; of a run's folder also "
       "findings",
       false, store_text(request->layer)},
      {"--geojson", "FILE", "GeoJSON file for the layer, in longitude and latitude, for example for QGIS", false,
       store_text(request->geojson_path)},
      {"-o,--out", "FILE.png",
       "draws a species at 0.1, 0.5, 1.2, 2.5 and 12.5 m (at a tenth if it is low), and prints its triangles and "
       "errors",
       false, store_text(request->picture)},
      {"--atlases", "",
       "with -o: draws all pictures of windows, doors and facades of a .glb or of a run's level 0, with their sizes in "
       "metres",
       false,
       [request](const std::string&) -> Result<Done> {
         request->draws_atlases = true;
         return Done{};
       }},
      {"--materials", "", "with -o: draws all materials with textures, on a sphere, a wall and the ground", false,
       [request](const std::string&) -> Result<Done> {
         request->draws_materials = true;
         return Done{};
       }},
      {"--sheet", "FILE.png", "draws a picture of all things (benches, bollards, ...) at 2, 10 and 50 cm", false,
       store_text(request->sheet.path)},
      {"--things", "FOLDER", "for --sheet: folder with a table of things and rule files, as for compile", false,
       store_text(request->sheet.folder)},
      {"--kind", "NAME", "for --sheet: a row of the table to draw, such as bench (default: all)", true,
       append_text(request->sheet.names)},
  };
  verb.examples = {"citykiln inspect oak -o oak.png",
                   "citykiln inspect --sheet things.png --kind bench --kind bollard",
                   "citykiln inspect --materials -o materials.png",
                   "citykiln inspect out/town --atlases -o atlases.png",
                   "citykiln inspect out/town/scene.kiln",
                   "citykiln inspect out/town/scene.kiln --layer buildings --geojson buildings.geojson"};
  verb.run = [request](const Console& console) { return run_inspect(*request, console); };
  return verb;
}

}  // namespace citykiln::commands
