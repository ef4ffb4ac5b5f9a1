#include "exporters/usd/encode_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numbers>
#include <span>

#include "compiler/bake/place_lamps.h"
#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/trig.h"
#include "compiler/sky/recipe.h"
#include "exporters/joined_attributions.h"
#include "exporters/run_files.h"
#include "exporters/usd/layer_writer.h"
#include "exporters/usd/text_writer.h"
#include "exporters/usd/usd_names.h"

namespace citykiln::exporters {
namespace {

constexpr double kSolarIlluminance_lx = 127500, kExtinction = 0.21;

// The luminance in cd/m² of a radiance of 1 in USD: that of a white surface that faces the sun at the zenith.
double usd_unit_luminance_cd_m2() { return kSolarIlluminance_lx * exponential(-kExtinction) / std::numbers::pi; }

// ---- lamps ----------------------------------------------------------------------------------------------------------

constexpr double kLantern_m = 0.1, kHead_m = 0.15;

double luminance_of(const props::Luminaire& light) {
  const double axis_cd = light.lumen / props::beam_sr(light.beam);
  const double radius_m = light.beam == props::Beam::kDown ? kHead_m : kLantern_m;
  // seen along the axis, both are a disk of this radius
  return axis_cd / (kPi * radius_m * radius_m);
}

UsdDictionary data_of(const bake::PlacedLamp& lamp) {
  const OsmId id = lamp.placement.feature;
  return {{"class", std::string(props::name_of(lamp.kind))},
          {"lumen", static_cast<double>(lamp.light.lumen)},
          {"temperature_k", static_cast<double>(lamp.light.temperature_k)},
          {"osm_id", fmt::format("{}", id.id)},
          {"osm_type", std::string(id.type == OsmType::kNode ? "node" : "way")}};
}

void write_lamp(LayerWriter& writer, const bake::PlacedLamp& lamp, Vec3 origin, std::size_t number) {
  const bool is_disk = lamp.light.beam == props::Beam::kDown;
  const auto colour = props::black_body_colour(lamp.light.temperature_k);
  writer.begin_prim({.type = is_disk ? "DiskLight" : "SphereLight",
                     .name = fmt::format("lamp_{}", number),
                     .custom_data = data_of(lamp)});
  writer.write({.type = "color3f", .name = "inputs:color", .value = bake::Float3{colour[0], colour[1], colour[2]}});
  const double intensity = luminance_of(lamp.light) / usd_unit_luminance_cd_m2();
  writer.write({.type = "float", .name = "inputs:intensity", .value = static_cast<float>(intensity)});
  writer.write({.type = "float", .name = "inputs:radius", .value = static_cast<float>(is_disk ? kHead_m : kLantern_m)});
  writer.write(
      {.type = "double3", .name = "xformOp:translate", .value = props::glass_of(lamp.placement, lamp.kind) - origin});
  static const std::string kOrder[] = {"xformOp:translate", "xformOp:rotateX"};
  const bool is_turned = lamp.up != Vec3{0, 0, 1};
  if (is_turned)
    writer.write(
        {.type = "float", .name = kOrder[1], .value = static_cast<float>(arctangent2_deg(-lamp.up.y, lamp.up.z))});
  writer.write({.type = "token[]",
                .name = "xformOpOrder",
                .value = UsdTokens{std::span(kOrder, is_turned ? 2 : 1)},
                .is_uniform = true});
  writer.end_prim();
}

// Writes the prim "lights" with a light for each lamp; writes nothing if there are no lamps. A lantern is a
// SphereLight of 0.1 m radius with lumen / (3 pi) candela. A lamp that shines down is a DiskLight of 0.15 m radius
// with all of its lumen. The intensity is the luminance over usd_unit_luminance_cd_m2(); the colour is
// linear and has luminance 1. customData: lumen, temperature_k, class, osm_id, osm_type.
// @param origin  The tile's origin, plane metres.
void write_usd_lights(LayerWriter& writer, std::span<const bake::PlacedLamp> lamps, Vec3 origin) {
  if (lamps.empty()) return;
  writer.begin_prim({.type = "Scope", .name = "lights"});
  for (std::size_t i = 0; i < lamps.size(); ++i) write_lamp(writer, lamps[i], origin, i);
  writer.end_prim();
}

// ---- light ----

constexpr double kSunAngle_deg = 0.533;
// Share of the sky in the illuminance of a level surface under a clear sky, sun high.
constexpr double kSkyShare = 0.15;

double air_mass(double height_deg) { return 1 / (sine(height_deg) + 0.50572 * power(height_deg + 6.07995, -1.6364)); }

// In lux, on a surface that faces the sun.
double illuminance_lx(const sky::Sky& sky) {
  const double height_deg = arcsine_deg(sky.to_sun.z);
  return sky::is_night(sky) ? 0
                            : kSolarIlluminance_lx * exponential(-kExtinction * air_mass(std::max(0.0, height_deg)));
}

// Six digits: more would be false, and would show the last bits of the arithmetic.
std::string six_digits(double value) { return fmt::format("{:.6g}", value); }

std::string vector4(Vec3 v, double w) {
  return fmt::format("({},{},{},{})", six_digits(v.x), six_digits(v.y), six_digits(v.z), w);
}

// A rotation that turns local z, against which a light shines, to the sun.
std::string turned_to(Vec3 to_sun) {
  const bool is_zenith = to_sun.x == 0 && to_sun.y == 0;
  const Vec3 x = is_zenith ? Vec3{1, 0, 0} : unit(cross(Vec3{0, 0, 1}, to_sun));
  return fmt::format("({},{},{},(0,0,0,1))", vector4(x, 0), vector4(cross(to_sun, x), 0), vector4(to_sun, 0));
}

void write_sun(TextWriter& writer, const sky::Sky& sky, double intensity) {
  writer.begin_prim(
      {.type = "DistantLight",
       .name = "sun",
       .custom_data = {{"illuminance_lx", std::round(illuminance_lx(sky))}, {"time", sky::text_of(sky.time)}}});
  writer.write({.type = "float", .name = "inputs:angle", .value = static_cast<float>(kSunAngle_deg)});
  writer.write_lines("float inputs:intensity = " + six_digits(intensity));
  writer.write({.type = "bool", .name = "inputs:normalize", .value = true});
  writer.write_lines("matrix4d xformOp:transform = " + turned_to(sky.to_sun) +
                     "\nuniform token[] xformOpOrder = [\"xformOp:transform\"]");
  writer.end_prim();
}

void write_lights(TextWriter& writer, const sky::Sky& sky) {
  const double full_lx = kSolarIlluminance_lx * exponential(-kExtinction);
  const double sun = std::numbers::pi * illuminance_lx(sky) / full_lx;
  if (!sky::is_night(sky)) write_sun(writer, sky, sun);
  const double height = std::max(0.02, sky.to_sun.z);
  writer.begin_prim({.type = "DomeLight", .name = "sky"});
  writer.write({.type = "color3f", .name = "inputs:color", .value = bake::Float3{0.7f, 0.85f, 1}});
  writer.write_lines("float inputs:intensity = " + six_digits(kSkyShare * height));
  writer.end_prim();
}

// ---- tiles ----

UsdBounds moved(const UsdBounds& bounds, Vec3 by) { return {bounds.low + by, bounds.high + by}; }

std::string hint_of(const UsdBounds& bounds) {
  const auto extent = extent_of(is_empty(bounds) ? UsdBounds{{}, {}} : bounds);
  return "float3[] extentsHint = " + text_of(std::span<const bake::Float3>(extent));
}

// The names of the variants of a tile.
std::string level_name(std::size_t level) { return fmt::format("L{}", level); }

void write_variant(TextWriter& writer, const UsdTile& tile, std::size_t n) {
  const UsdTileLevel& level = tile.levels[n];
  const std::string file = usd_level_name(tile.tile, n);
  writer.write_lines(fmt::format(R"("{}" (
    customData = {{
        double tolerance_m = {}
        double error_m = {}
        double plant_error_m = {}
    }}
    prepend payload = @./{}@
) {{
    {}
}})",
                                 level_name(n), level.tolerance_m, level.error_m, level.plant_error_m,
                                 file.substr(file.rfind('/') + 1), hint_of(level.bounds)));
}

UsdDictionary plane_data(const scene::Header& header) {
  const auto cylinder = scene::cylinder_of(header);
  return {{"attribution", joined_attributions(header.attributions)},
          {"projection", cylinder ? fmt::format("inside of a cylinder around x, radius {} m", cylinder->radius_m)
                                  : std::string("transverse Mercator, WGS84, scale 1 at the origin")},
          {"lon_0", header.origin.lon_deg},
          {"lat_0", header.origin.lat_deg}};
}

// The layer of clouds (encode_cloud_layer.h) is loaded like a tile.
constexpr std::string_view kCloudsPrim = R"(
def Xform "clouds" (
    kind = "component"
    prepend payload = @./clouds.usdc@
)
{
})";

// A prim whose content is a payload: a file beside the scene's layer, or below it.
void write_payload(TextWriter& writer, const std::string& name, const std::string& path, const UsdBounds& bounds,
                   Vec3 origin) {
  writer.write_lines(fmt::format(R"(
def Xform "{}" (
    prepend apiSchemas = ["GeomModelAPI"]
    kind = "component"
    prepend payload = @./{}@
)
{{
    {}
    double3 xformOp:translate = {}
    uniform token[] xformOpOrder = ["xformOp:translate"]
}})",
                                 name, path.substr(path.find('/') + 1), hint_of(bounds), text_of(origin)));
}

void write_tile_prim(TextWriter& writer, const UsdTile& tile) {
  write_payload(writer, usd_tile_prim(tile.tile), usd_tile_name(tile.tile), tile.levels.front().bounds, tile.origin);
}

}  // namespace

std::vector<std::byte> encode_tile_layer(const UsdTile& tile, const scene::Header& header) {
  assert(!tile.levels.empty());
  TextWriter writer({.default_prim = "tile", .custom_data = plane_data(header)});
  writer.write_lines(R"(
def Xform "tile" (
    prepend apiSchemas = ["GeomModelAPI"]
    kind = "component"
    variants = {
        string level = "L0"
    }
    prepend variantSets = "level"
)
{)");
  writer.indent();
  writer.write_lines(fmt::format(
      "double3 xformOp:translate = {}\nuniform token[] xformOpOrder = [\"xformOp:translate\"]", text_of(tile.origin)));
  writer.write_lines("variantSet \"level\" = {");
  writer.indent();
  for (std::size_t n = 0; n < tile.levels.size(); ++n) write_variant(writer, tile, n);
  writer.end_prim();
  write_usd_lights(writer, tile.lights, tile.origin);
  writer.end_prim();
  return writer.finish();
}

std::vector<std::byte> encode_scene(std::span<const UsdTile> tiles, const scene::Header& header,
                                    const UsdSurroundings* around) {
  assert(std::ranges::is_sorted(tiles, {}, &UsdTile::tile));
  TextWriter writer({.default_prim = "scene", .custom_data = plane_data(header)});
  UsdBounds bounds;
  for (const UsdTile& tile : tiles)
    if (!is_empty(tile.levels.front().bounds)) include(bounds, moved(tile.levels.front().bounds, tile.origin));
  writer.begin_prim({.type = "Xform", .name = "scene", .api_schemas = {"GeomModelAPI"}, .kind = "assembly"});
  writer.write_lines(hint_of(bounds));
  write_lights(writer, header.sky);
  if (around != nullptr) write_payload(writer, "surroundings", kUsdSurroundingsName, around->bounds, around->origin);
  if (sky::has_cloud_files(header.sky)) writer.write_lines(kCloudsPrim);
  writer.begin_prim({.type = "Xform", .name = "tiles", .kind = "group"});
  for (const UsdTile& tile : tiles) write_tile_prim(writer, tile);
  writer.end_prim(), writer.end_prim();
  return writer.finish();
}

}  // namespace citykiln::exporters
