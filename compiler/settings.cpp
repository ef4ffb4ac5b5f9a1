#include "compiler/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "compiler/contract/findings/assumption_names.h"
#include "compiler/contract/findings/code_names.h"
#include "compiler/contract/texts/parse.h"
#include "compiler/edits/parse_edits.h"
#include "compiler/geometry/snap.h"
#include "compiler/parse_shown.h"
#include "compiler/parse_values.h"
#include "compiler/sky/clouds/read_clouds.h"
#include "compiler/sky/moment.h"
#include "compiler/source/read_raster.h"

namespace citykiln {
namespace {

/// Stores the value of a result in `target`, or returns its error.
template <typename T, typename Target>
Result<Done> put(Result<T> result, Target& target) {
  if (!result) return result.error();
  target = std::move(*result);
  return Done{};
}

// ---- one function for each setting, in the order of the table ----

template <std::string CompileSpec::*kMember>
Result<Done> set_text(CompileSpec& spec, std::string_view text) {
  spec.*kMember = text;
  return Done{};
}

/// The heightmaps in a folder, sorted by name.
std::vector<std::string> heightmaps_in(const std::string& folder) {
  constexpr std::string_view kSuffixes[] = {".hgt", ".hgt.zip", ".hgt.gz", ".tif", ".tiff", ".asc", ".asc.gz"};
  std::vector<std::string> paths;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
    if (std::ranges::any_of(kSuffixes, [&](std::string_view end) { return entry.path().native().ends_with(end); }))
      paths.push_back(entry.path().string());
  std::ranges::sort(paths);
  return paths;
}

Result<Done> set_dem(CompileSpec& spec, std::string_view text) {
  if (std::error_code none; std::filesystem::is_directory(text, none)) {
    const std::vector<std::string> paths = heightmaps_in(std::string(text));
    if (paths.empty()) return expected("a folder with heightmaps (.hgt, .tif, .asc)", text);
    for (const std::string& path : paths)
      if (Result<Done> done = set_dem(spec, path); !done) return done;
    return Done{};
  }
  Result<source::RasterSpec> raster = source::parse_raster_spec(text);
  if (!raster) return raster.error();
  spec.rasters.push_back(std::move(*raster));
  return Done{};
}

Result<Done> set_edits(CompileSpec& spec, std::string_view text) {
  if (text.empty()) return spec.edits.reset(), Done{};
  return put(edits::read_edits(std::string(text)), spec.edits);
}

bool is_box_on_earth(const source::LonLatBox& box) {
  const bool is_on_earth = box.west >= -180 && box.east <= 180 && box.south >= -90 && box.north <= 90;
  return is_on_earth && box.west < box.east && box.south < box.north;
}

Result<Done> set_bbox(CompileSpec& spec, std::string_view text) {
  Result<std::vector<double>> n = parse_numbers(text, 4);
  if (!n) return n.error();
  source::LonLatBox box{(*n)[0], (*n)[1], (*n)[2], (*n)[3]};
  const bool is_across_180 = box.west <= 180 && box.east >= -180 && box.west - box.east > 180;
  if (!is_box_on_earth(is_across_180 ? source::LonLatBox{-180, box.south, box.east, box.north} : box)) {
    Error error = expected(
        "west,south,east,north in degrees with west < east and south < north, such as 7.40,43.72,7.44,43.75", text);
    if (is_box_on_earth({box.south, box.west, box.north, box.east}))
      error.message +=
          fmt::format("; latitude and longitude swapped? Try {},{},{},{}", box.south, box.west, box.north, box.east);
    return error;
  }
  if (is_across_180) box.east += 360;
  spec.map.bbox = box;
  return Done{};
}

// The extent is the outline's box, unless one is given.
Result<Done> set_clip(CompileSpec& spec, std::string_view text) {
  Result<source::Outline> outline = source::read_outline(std::string(text));
  if (!outline) return outline.error();
  clip_to(std::move(*outline), spec);
  return Done{};
}

Result<Done> set_origin(CompileSpec& spec, std::string_view text) {
  Result<std::vector<double>> n = parse_numbers(text, 2);
  if (!n) return n.error();
  if (std::abs((*n)[0]) > 180 || std::abs((*n)[1]) > 89)
    return expected("longitude,latitude in degrees, such as 7.42,43.73", text);
  spec.map.origin = LonLat{(*n)[0], (*n)[1]};
  return Done{};
}

Result<Done> set_tile(CompileSpec& spec, std::string_view text) {
  Result<double> tile_m = parse_number(text);
  // offsets inside a chunk are float32, which is exact up to 16 km (kQuantum_m)
  if (!tile_m || *tile_m < map::kCell_m || *tile_m > 16384 || std::fmod(*tile_m, map::kCell_m) != 0) {
    return expected("a multiple of 128 from 128 to 16384 (metres), such as 512", text);
  }
  spec.tile_m = *tile_m;
  return Done{};
}

/// A format that --emit names.
struct OutputFormat {
  std::string_view name;
  bool Outputs::*is_written;
};
constexpr std::array kOutputFormats = {OutputFormat{"kiln", &Outputs::manifest},
                                       OutputFormat{"glb", &Outputs::glb},
                                       OutputFormat{"usd", &Outputs::usd},
                                       OutputFormat{"3dtiles", &Outputs::tiles3d},
                                       OutputFormat{"3tz", &Outputs::tiles3d_archive},
                                       OutputFormat{"page", &Outputs::page}};

Result<Done> set_emit(CompileSpec& spec, std::string_view text) {
  for (const OutputFormat& format : kOutputFormats) spec.outputs.*format.is_written = false;
  for (const std::string_view name : split(text, ',')) {
    const auto format = std::ranges::find(kOutputFormats, name, &OutputFormat::name);
    if (format == kOutputFormats.end())
      return expected("kiln, glb, usd, 3dtiles, 3tz, page or several of them, such as kiln,usd", name);
    spec.outputs.*format->is_written = true;
  }
  return Done{};
}

std::string emitted_in(const CompileSpec& spec) {
  std::string names;
  for (const OutputFormat& format : kOutputFormats)
    if (spec.outputs.*format.is_written) names += (names.empty() ? "" : ",") + std::string(format.name);
  return names;
}

/// The default of a value of the sky, as text.
template <auto kValue>
std::string default_of_sky(const CompileSpec&) {
  return fmt::format("{}", sky::Sky{}.*kValue);
}

Result<Done> set_world(CompileSpec& spec, std::string_view text) {
  constexpr std::string_view kCylinder = "cylinder";
  if (text.starts_with(kCylinder)) {
    const auto radius_m =
        text.starts_with("cylinder:") ? number_in<double>(text.substr(kCylinder.size() + 1)) : std::optional<double>();
    if (!radius_m || !(*radius_m >= map::kLeastCylinder_m && *radius_m <= map::kLargestCylinder_m))
      return expected("cylinder:R with a radius from 100 to 1000000 (metres), such as cylinder:1000", text);
    spec.world = World::kCylinder, spec.cylinder = {*radius_m};
    return Done{};
  }
  if (text != "plane" && text != "ellipsoid") return expected("plane, ellipsoid or cylinder:R", text);
  spec.world = text == "plane" ? World::kPlane : World::kEllipsoid;
  return Done{};
}

Result<Done> set_geoid(CompileSpec& spec, std::string_view text) {
  return put(map::parse_geoid(text), spec.outputs.geoid);
}

Result<Done> set_target(CompileSpec& spec, std::string_view text) {
  const auto target = target_named(text);
  if (!target) return expected(targets_with([](const TargetValues&) { return true; }), text);
  spec.outputs.target = *target;
  return Done{};
}

// Rejects numbers that no program can render, which are mistakes.
Result<Done> set_lights(CompileSpec& spec, std::string_view text) {
  constexpr std::int64_t kMost = 100'000;
  const Result<std::int64_t> count = parse_whole(text, 0);
  if (!count) return count.error();
  if (*count > kMost) return expected("a whole number up to 100000", text);
  spec.outputs.lights = static_cast<std::size_t>(*count);
  return Done{};
}

template <typename T>
Result<Done> put_named(const std::optional<T>& value, const char* names, std::string_view text, T& place) {
  if (!value) return expected(names, text);
  place = *value;
  return Done{};
}

Result<Done> set_split(CompileSpec& spec, std::string_view text) {
  return put_named(node_split_named(text), "tile, layer or building", text, spec.outputs.split);
}

Result<Done> set_compression(CompileSpec& spec, std::string_view text) {
  Compression compression{};
  const Result<Done> done =
      put_named(compression_named(text), "none, lean, quantize, draco or meshopt", text, compression);
  if (done) spec.outputs.compress = compression;
  return done;
}

Result<Done> set_materials(CompileSpec& spec, std::string_view text) {
  spec.outputs.materials_folder = text;
  return Done{};
}

Result<Done> set_textures(CompileSpec& spec, std::string_view text) {
  if (text != "usual" && text != "fine") return Error{std::string(text), "expected usual or fine"};
  spec.outputs.has_fine_textures = text == "fine";
  return Done{};
}

Result<Done> set_layout(CompileSpec& spec, std::string_view text) {
  Layout layout{};
  const Result<Done> done = put_named(layout_named(text), "embedded or shared", text, layout);
  if (done) spec.outputs.layout = layout;
  return done;
}

Result<Done> set_drive_on(CompileSpec& spec, std::string_view text) {
  if (text != "left" && text != "right") return expected("left or right", text);
  spec.map.driving_side = text == "left" ? map::DrivingSide::kLeft : map::DrivingSide::kRight;
  return Done{};
}

/// Returns the names of the assumptions of --assume: "pavements, lamps or heights".
std::string assumption_names() {
  const std::vector<std::string> named = names_in(kNamedAssumptions);
  std::string names;
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (i > 0) names += i + 1 == named.size() ? " or " : ", ";
    names += named[i];
  }
  return names;
}

Result<Done> set_assume(CompileSpec& spec, std::string_view text) {
  if (text == "all" || text == "none") {
    spec.assume = text == "all" ? kNamedAssumptions : kNoAssumptions;
    return Done{};
  }
  Assumptions set = kNoAssumptions;
  for (const std::string_view name : split(text, ',')) {
    const std::optional<Assumption> assumption = assumption_named(name);
    if (!assumption || *assumption == Assumption::kHouses)
      return expected("all, none, or names among " + assumption_names(), text);
    set |= bit_of(*assumption);
  }
  spec.assume = set;
  return Done{};
}

Result<Done> set_time(CompileSpec& spec, std::string_view text) {
  if (text.empty()) return spec.time.reset(), Done{};
  return put(sky::parse_time(text), spec.time);
}

/// Stores a number of the air within limits.
Result<Done> put_number(std::string_view text, double low, double high, std::string_view what,
                        std::optional<double>& target) {
  const auto number = number_in<double>(text);
  if (!number || !(*number >= low && *number <= high)) return expected(what, text);
  target = number;
  return Done{};
}

Result<Done> set_visibility(CompileSpec& spec, std::string_view text) {
  return put_number(text, sky::kHaziest_km, sky::kClearest_km, "a visibility from 1 to 300 (kilometres), such as 30",
                    spec.air.visibility_km);
}

Result<Done> set_turbidity(CompileSpec& spec, std::string_view text) {
  return put_number(text, sky::kLeastTurbidity, sky::kMostTurbidity, "a turbidity from 1 to 20, such as 2.6",
                    spec.air.turbidity);
}

Result<Done> set_ground_albedo(CompileSpec& spec, std::string_view text) {
  return put_number(text, 0, 1, "an albedo from 0 to 1, such as 0.2", spec.air.ground_albedo);
}

Result<Done> set_clouds(CompileSpec& spec, std::string_view text) {
  Result<std::vector<sky::CloudRequest>> layers = sky::read_clouds(std::string(text));
  if (!layers) return layers.error();
  spec.clouds = std::move(*layers);
  return Done{};
}

Result<Done> set_seed(CompileSpec& spec, std::string_view text) {
  const auto seed = number_in<std::uint64_t>(text);
  if (!seed) return expected("a whole number of at least 0, such as 7", text);
  spec.seed = *seed;
  return Done{};
}

Result<Done> set_snow_line(CompileSpec& spec, std::string_view text) {
  spec.snow_line_m = number_in<double>(text);
  return spec.snow_line_m ? Result<Done>(Done{}) : expected("a height in metres, such as 2800", text);
}

Result<Done> set_fill(CompileSpec& spec, std::string_view text) {
  if (text != "lots" && text != "none") return expected("lots or none", text);
  spec.fill_lots = text == "lots";
  return Done{};
}

// A share of places: cars::CarShare or people::PeopleShare.
template <typename Share>
Result<Share> share_in(double step, std::string_view text) {
  if (text == "usual" || text == "true") return Share{.is_by_table = true};
  if (text == "none" || text == "false") return Share{};
  const auto share = number_in<double>(text);
  if (!share || !(*share >= 0 && *share <= 1))
    return expected("usual, none, or a share from 0 to 1, such as 0.7", text);
  return Share{.share = snapped_to(step, *share)};
}

Result<Done> set_cars(CompileSpec& spec, std::string_view text) {
  const Result<cars::CarShare> share = share_in<cars::CarShare>(cars::kShareStep, text);
  if (!share) return share.error();
  return spec.cars = *share, Done{};
}

Result<Done> set_traffic(CompileSpec& spec, std::string_view text) {
  const Result<cars::CarShare> share = share_in<cars::CarShare>(cars::kShareStep, text);
  if (!share) return share.error();
  return spec.traffic = *share, Done{};
}

Result<Done> set_people(CompileSpec& spec, std::string_view text) {
  const Result<people::PeopleShare> share = share_in<people::PeopleShare>(people::kPeopleStep, text);
  if (!share) return share.error();
  return spec.people = *share, Done{};
}

Result<Done> set_layers(CompileSpec& spec, std::string_view text) {
  return put(parse_layers(text), spec.shown.left_out);
}

Result<Done> set_wood_density(CompileSpec& spec, std::string_view text) {
  return put(parse_wood_density(text), spec.shown.wood_density);
}

Result<Done> set_lamps(CompileSpec& spec, std::string_view text) { return put(parse_lamps(text), spec.shown.lamps); }

Result<Done> set_lit_windows(CompileSpec& spec, std::string_view text) {
  return put(parse_lit_windows(text), spec.shown.lit_windows);
}

Result<Done> set_strict(CompileSpec& spec, std::string_view text) {
  spec.strict = {.is_on = text != "false", .codes = {}};
  if (text == "true" || text == "false") return Done{};
  for (const std::string_view name : split(text, ',')) {
    const std::optional<Code> code = code_named(name);
    if (!code) return expected("diagnosis codes as in report.json, such as MissingNode,RoofFallback", name);
    spec.strict.codes.push_back(*code);
  }
  return Done{};
}

Result<Done> set_surroundings(CompileSpec& spec, std::string_view text) {
  if (text != "true" && text != "false" && text != "none") return expected("none, or nothing", text);
  spec.outputs.surroundings = text == "true" ? AroundWish::kYes : AroundWish::kNo;
  return Done{};
}

constexpr Setting kSettings[] = {
    {"map", "FILE", "OpenStreetMap extract: .osm, .osm.gz, .osm.bz2 or .osm.pbf", false,
     set_text<&CompileSpec::map_path>},
    {"dem", "FILE[,key=value...]",
     "heightmaps (.hgt, GeoTIFF, ASCII grid, PNG) or folders of them, one or several, such as N43E007.hgt or "
     "a.png,bounds=7/43/8/44,scale=0.1; keys: bounds=W/S/E/N, scale=, offset=, encoding=terrarium|mapbox, tile=Z/X/Y, "
     "credit= (default: the ground is level)",
     true, set_dem},
    {"edits", "FILE",
     "file of edits that mend the map after it has been read, one a line, such as \"w123 set height=12\" (default: "
     "none)",
     false, set_edits},
    {"bbox", "W,S,E,N",
     "area to compile in degrees, such as 7.40,43.72,7.44,43.75 (default: the extract's bounding box)", false,
     set_bbox},
    {"clip", "FILE.geojson|FILE.poly",
     "polygons to compile: ground, roads, water and things end there, and buildings stay if their centroid is inside "
     "(default: all of the box)",
     false, set_clip},
    {"area", "NAME", "an administrative area of the map, by its name, name:en or id (r123), as the polygons of --clip",
     false, set_text<&CompileSpec::area>},
    {"origin", "LON,LAT",
     "origin of the plane in degrees, such as 7.42,43.73 (default: the area's centre, rounded to 0.01)", false,
     set_origin},
    {"tile", "M", "side of a tile in metres, a multiple of 128 (default: {})", false, set_tile,
     [](const CompileSpec& spec) { return fmt::format("{}", spec.tile_m); }},
    {"only", "X_Y[,X_Y...]", "only these tiles, such as 0_0,0_-1 (default: all)", true,
     [](CompileSpec& spec, std::string_view text) { return add_tiles(text, spec.only); }},
    {"out", "FOLDER", "folder for all outputs; it is created if missing", false,
     [](CompileSpec& spec, std::string_view text) { return put(Result(std::string(text)), spec.outputs.folder); }},
    {"emit", "kiln,glb,usd,3dtiles,3tz,page",
     "outputs to write: kiln (manifest), glb (tiles), usd (a scene of the tiles), 3dtiles (tileset.json, on the "
     "ellipsoid), 3tz (the same as one file, tileset.3tz), page (index.html, which shows 3dtiles in a browser) or "
     "several (default: {})",
     false, set_emit, emitted_in},
    {"lods", "M,M,...", "levels of detail: largest geometric error of each in metres, finest first (default: {})",
     false, [](CompileSpec& spec, std::string_view text) { return put(parse_ladder(text), spec.outputs.tolerances_m); },
     [](const CompileSpec& spec) { return fmt::format("{}", fmt::join(spec.outputs.tolerances_m, ",")); }},
    {"world", "plane|ellipsoid|cylinder:R",
     "shape of the world: ellipsoid for --emit 3dtiles and 3tz, plane for kiln and glb, or for all of them cylinder:R, "
     "the "
     "inside of a hollow cylinder with a radius of R metres around the x axis (default: that of the output)",
     false, set_world},
    {"geoid-height", "M|FILE.pgm",
     "for 3dtiles and 3tz: height of the geoid (sea level) above the ellipsoid in metres, such as 47.3, or a geoid of "
     "GeographicLib, such as egm96-5.pgm (default: 0)",
     false, set_geoid},
    {"compress", "none|lean|quantize|draco|meshopt",
     "compression of meshes in .glb files (default: lean where the target reads it)", false, set_compression},
    {"layout", "embedded|shared",
     "shared: plants, lamps and images of all tiles are files in glb/shared; embedded: each .glb stands alone "
     "(default: that of the target, embedded for generic)",
     false, set_layout},
    {"max-bytes", "N",
     "instead of levels: each .glb is as fine as this many bytes allow, such as 5000000, as target and compression are",
     false, [](CompileSpec& spec, std::string_view text) { return put(parse_whole(text, 1), spec.outputs.max_bytes); }},
    {"max-triangles", "N", "instead of levels: each .glb is as fine as this many triangles allow, such as 100000",
     false,
     [](CompileSpec& spec, std::string_view text) { return put(parse_whole(text, 1), spec.outputs.max_triangles); }},
    {"target", "generic|blender|godot|three|cesium|unreal|unity",
     "program that reads the .glb files; generic uses nothing that a reader may lack (default: {})", false, set_target,
     [](const CompileSpec& spec) { return std::string(values_of(spec.outputs.target).name); }},
    {"split", "tile|layer|building",
     "nodes of a tile: one, one for each layer (ground, roads, water, buildings ...), or one for each building too "
     "(default: {})",
     false, set_split, [](const CompileSpec& spec) { return std::string(name_of(spec.outputs.split)); }},
    {"surroundings", "[none]",
     "the land around the map, to the horizon, is a tile of its own: glb/surroundings.glb, usd/surroundings.usdc, a "
     "tile of 3dtiles (default: yes); none leaves it out",
     false, set_surroundings},
    {"lights", "N",
     "the N brightest street lamps of each tile are lights of .glb (KHR_lights_punctual) and USD (UsdLux) files, at "
     "any time (default: {})",
     false, set_lights, [](const CompileSpec& spec) { return fmt::format("{}", spec.outputs.lights); }},
    {"assume", "all|none|NAME,...", "what is assumed where the map is silent, such as pavements,lamps (default: all)",
     false, set_assume},
    {"fill", "lots|none",
     "lots: puts houses on residential land without buildings, beside mapped streets (default: none)", false, set_fill},
    {"drive-on", "left|right", "side of the road on which vehicles drive (default: by country)", false, set_drive_on},
    {"time", "ISO",
     "date and time of the sky in UTC, or with an offset from it, such as 2026-06-21T20:30+02:00 (default: midsummer, "
     "15:00 solar time)",
     false, set_time},
    {"visibility", "KM",
     "how far one sees at sea level, 1 to 300 km (default: {}, or by the turbidity if that is given)", false,
     set_visibility, default_of_sky<&sky::Sky::visibility_km>},
    {"turbidity", "T", "haze of the whole sky: 2 clear, 10 hazy (default: {})", false, set_turbidity,
     default_of_sky<&sky::Sky::turbidity>},
    {"ground-albedo", "X", "share of light that the land around reflects into the air, 0 to 1 (default: {})", false,
     set_ground_albedo, default_of_sky<&sky::Sky::ground_albedo>},
    {"clouds", "clear|fair|broken|overcast|FILE.json",
     "clouds of the sky, by name or in layers, also as files of outputs (default: fair, in the manifest alone)", false,
     set_clouds},
    {"seed", "N", "seed of all random choices, a whole number (default: {})", false, set_seed,
     [](const CompileSpec& spec) { return fmt::format("{}", spec.seed); }},
    {"snow-line", "M",
     "land above this height in metres is covered by snow, such as 2800 (default: all land in the winter of cold "
     "climates, "
     "else none)",
     false, set_snow_line},
    {"rules", "FOLDER", "folder of rule files (.cga) that replace shipped files of the same name", false,
     set_text<&CompileSpec::rules_folder>},
    {"things", "FOLDER",
     "folder with a table of things, things.txt, and rule files (.cga), which add to the shipped ones or replace those "
     "of the same name",
     false, set_text<&CompileSpec::things_folder>},
    {"species", "FOLDER",
     "folder with user-defined species (.lsys, .honda, .family, .tree) and tables of them, species.txt and "
     "spawners.txt, "
     "which "
     "add to the shipped ones or replace those of the same name",
     false, set_text<&CompileSpec::species_folder>},
    {"materials", "FOLDER",
     "folder with artists' textures by material: folders such as flemish_brick with pictures named as ambientCG and "
     "Poly "
     "Haven do, and a table materials.csv",
     false, set_materials},
    {"textures", "usual|fine", "textures of materials with up to 512 texels a side, or 1024 (default: usual)", false,
     set_textures},
    {"cars", "[usual|none|SHARE]",
     "the share of parking places with a parked car, from 0 to 1; usual: by country, kind of place and hour (default: "
     "usual where parking is assumed, else none)",
     false, set_cars},
    {"traffic", "[usual|none|SHARE]",
     "the share of slots of 13 m in the lanes of carriageways with a car, from 0 to 1; usual: by class of road and "
     "hour "
     "(default: none)",
     false, set_traffic},
    {"people", "[usual|none|SHARE]",
     "the share of spots on pavements, squares and paths with somebody, from 0 to 1; usual: by country, use of the "
     "ground and hour (default: none)",
     false, set_people},
    {"layers", "NAME,...|-NAME,...",
     "the layers of tiles: ground, roads, water, buildings, structures, things, plants, yards; a list keeps these "
     "alone, "
     "-NAME leaves one out (default: all)",
     false, set_layers},
    {"wood-density", "X", "factor on the number of trees in woods, from 0 to 4 (default: 1)", false, set_wood_density},
    {"lamps", "auto|on|off",
     "when street lamps are lit: auto: while the sun is 4° below the horizon; on: at any time; off: never, and no lamp "
     "is a light of tiles (default: auto)",
     false, set_lamps},
    {"lit-windows", "usual|none|SHARE",
     "the share of flats, offices and shops with lit windows while it is dark, from 0 to 1; usual: by use and hour "
     "(default: usual)",
     false, set_lit_windows},
    {"tags", "", "keep all tags of the map's elements, in the manifest and as a property of each feature in .glb files",
     false, [](CompileSpec& spec, std::string_view text) { return put(parse_switch(text), spec.map.keeps_tags); }},
    {"threads", "N", "number of threads; 0 uses all processors (default: {})", false,
     [](CompileSpec& spec, std::string_view text) { return put(parse_whole(text, 0), spec.threads); },
     [](const CompileSpec& spec) { return fmt::format("{}", spec.threads); }},
    {"strict", "[=CODE,...]",
     "exit with code 2 if map or height data had to be corrected or left out; with codes, such as "
     "--strict=MissingNode,RoofFallback, if one of these was diagnosed",
     false, set_strict},
};

}  // namespace

std::span<const Setting> settings() { return kSettings; }

std::string help_of(const Setting& setting) {
  std::string help(setting.help);
  if (setting.default_in) help.replace(help.find("{}"), 2, setting.default_in({}));
  return help;
}

Result<Done> apply(const Setting& setting, std::string_view text, CompileSpec& spec) {
  CompileSpec changed = spec;
  const Result<Done> done = setting.apply(changed, text);
  if (done) spec = std::move(changed);
  return done;
}

}  // namespace citykiln
