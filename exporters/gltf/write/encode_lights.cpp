#include "exporters/gltf/write/encode_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "compiler/geometry/trig.h"
#include "exporters/gltf/glb_names.h"

namespace citykiln::exporters {
namespace {

using Json = nlohmann::json;

constexpr const char* kExtension = "KHR_lights_punctual";

constexpr double kLeast_lx = 0.05;

double candela_of(const props::Luminaire& light) {
  return light.beam == props::Beam::kDown ? 3 * light.lumen / (2 * kPi) : light.lumen / props::beam_sr(light.beam);
}

Json light_of(const bake::PlacedLamp& lamp) {
  const auto colour = props::black_body_colour(lamp.light.temperature_k);
  const double largest = *std::ranges::max_element(colour), candela = candela_of(lamp.light);
  // the colour's luminance is 1 / largest
  Json light = {{"name", props::name_of(lamp.kind)}, {"type", "point"}, {"intensity", candela * largest}};
  for (const float c : colour) light["color"].push_back(c / largest);
  if (candela > 0) light["range"] = std::sqrt(candela / kLeast_lx);
  if (lamp.light.beam == props::Beam::kDown)
    light["type"] = "spot", light["spot"] = {{"innerConeAngle", 0.0}, {"outerConeAngle", kPi / 2}};
  return light;
}

// The number of the lamp's light in the file.
std::size_t light_number(GlbBuilder& f, std::vector<props::Luminaire>& known, const bake::PlacedLamp& lamp) {
  const auto found = std::ranges::find(known, lamp.light);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  known.push_back(lamp.light);
  f.file.gltf["extensions"][kExtension]["lights"].push_back(light_of(lamp));
  return known.size() - 1;
}

// All numbers are written with a fraction.
Json extras_of_lamp(const bake::PlacedLamp& lamp) {
  const OsmId id = lamp.placement.feature;
  return {{"class", props::name_of(lamp.kind)},
          {"lumen", lamp.light.lumen},
          {"temperature_k", lamp.light.temperature_k},
          {"osm_id", static_cast<double>(id.id)},
          {"osm_type", name_of(id.type)}};
}

// The rotation of a light that shines down: lights shine along -z.
Json shining_down(Vec3 up) {
  constexpr double kHalf = std::numbers::sqrt2 / 2;
  if (up == Vec3{0, 0, 1}) return {-kHalf, 0.0, 0.0, kHalf};
  // from glTF's z to `up`, which is (x, z, -y) there, by half of the angle between them
  const double w = 1 - up.y, size = std::sqrt(up.x * up.x + up.z * up.z + w * w);
  if (size < 1e-6) return {1.0, 0.0, 0.0, 0.0};
  return {-up.z / size, up.x / size, 0.0, w / size};
}

Json node_of(const GlbBuilder& f, const bake::PlacedLamp& lamp, std::size_t light) {
  const Vec3 glass = props::glass_of(lamp.placement, lamp.kind) - f.tile.origin;
  Json node = {{"name", props::name_of(lamp.kind)},
               {"translation", to_gltf(bake::narrowed(glass))},
               {"extensions", {{kExtension, {{"light", light}}}}},
               {"extras", extras_of_lamp(lamp)}};
  if (lamp.light.beam == props::Beam::kDown) node["rotation"] = shining_down(lamp.up);
  return node;
}

}  // namespace

void add_lights(GlbBuilder& f) {
  if (f.options.lights.empty()) return;
  Json group = {{"name", kLightGroup}};
  const std::size_t number = f.add("nodes", nullptr);
  std::vector<props::Luminaire> known;
  for (const bake::PlacedLamp& lamp : f.options.lights)
    group["children"].push_back(f.add("nodes", node_of(f, lamp, light_number(f, known, lamp))));
  Json& nodes = f.file.gltf["nodes"];
  nodes[number] = std::move(group), nodes[0]["children"].push_back(number);
  f.extensions.insert(kExtension);
}

}  // namespace citykiln::exporters
