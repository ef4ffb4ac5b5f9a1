#include "exporters/gltf/encode_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "compiler/geometry/trig.h"

namespace citykiln::exporters {
namespace {

using tinygltf::Value;

constexpr const char* kExtension = "KHR_lights_punctual";
constexpr const char* kGroup = "lights";

constexpr double kLeast_lx = 0.05;

double candela_of(const props::Luminaire& light) {
  return light.beam == props::Beam::kDown ? 3 * light.lumen / (2 * kPi) : light.lumen / props::beam_sr(light.beam);
}

const char* lamp_name(props::LampKind kind) { return kind == props::LampKind::kArm ? "ArmLamp" : "PostTopLamp"; }

tinygltf::Light light_of(const bake::PlacedLamp& lamp) {
  const auto colour = props::black_body_colour(lamp.light.temperature_k);
  const double largest = *std::ranges::max_element(colour), candela = candela_of(lamp.light);
  tinygltf::Light light;
  light.name = lamp_name(lamp.kind);
  light.type = lamp.light.beam == props::Beam::kDown ? "spot" : "point";
  for (const float c : colour) light.color.push_back(c / largest);
  // the colour's luminance is 1 / largest
  light.intensity = candela * largest;
  light.range = std::sqrt(candela / kLeast_lx);
  light.spot.innerConeAngle = 0, light.spot.outerConeAngle = kPi / 2;
  return light;
}

// The number of the lamp's light in the model.
int light_number(GlbBuilder& f, std::vector<props::Luminaire>& known, const bake::PlacedLamp& lamp) {
  const auto found = std::ranges::find(known, lamp.light);
  if (found != known.end()) return static_cast<int>(found - known.begin());
  known.push_back(lamp.light);
  f.model.lights.push_back(light_of(lamp));
  return static_cast<int>(known.size()) - 1;
}

const char* osm_type_of(OsmType type) {
  return type == OsmType::kNode ? "node" : type == OsmType::kWay ? "way" : "relation";
}

Value extras_of_lamp(const bake::PlacedLamp& lamp) {
  const OsmId id = lamp.placement.feature;
  return Value(Value::Object{{"class", Value(std::string(lamp_name(lamp.kind)))},
                             {"lumen", Value(static_cast<double>(lamp.light.lumen))},
                             {"temperature_k", Value(static_cast<double>(lamp.light.temperature_k))},
                             {"osm_id", Value(static_cast<double>(id.id))},
                             {"osm_type", Value(std::string(osm_type_of(id.type)))}});
}

tinygltf::Node node_of(const GlbBuilder& f, const bake::PlacedLamp& lamp, int light) {
  const Vec3 glass = props::glass_of(lamp.placement, lamp.kind) - f.tile.origin;
  const bake::Float3 at =
      to_gltf(bake::Float3{static_cast<float>(glass.x), static_cast<float>(glass.y), static_cast<float>(glass.z)});
  tinygltf::Node node;
  node.name = lamp_name(lamp.kind);
  node.translation = {at[0], at[1], at[2]};
  // lights shine along -z, these down
  constexpr double kHalf = std::numbers::sqrt2 / 2;
  if (lamp.light.beam == props::Beam::kDown) node.rotation = {-kHalf, 0, 0, kHalf};
  node.extensions[kExtension] = Value(Value::Object{{"light", Value(light)}});
  node.extras = extras_of_lamp(lamp);
  return node;
}

}  // namespace

void add_lights(GlbBuilder& f) {
  if (f.options.lights.empty()) return;
  tinygltf::Node group;
  group.name = kGroup;
  const auto first = static_cast<int>(f.model.nodes.size());
  f.model.nodes[0].children.push_back(first);
  f.model.nodes.emplace_back();
  std::vector<props::Luminaire> known;
  for (const bake::PlacedLamp& lamp : f.options.lights) {
    group.children.push_back(static_cast<int>(f.model.nodes.size()));
    const int light = light_number(f, known, lamp);
    f.model.nodes.push_back(node_of(f, lamp, light));
  }
  f.model.nodes[static_cast<std::size_t>(first)] = std::move(group);
  f.extensions.insert(kExtension);
}

bool is_light_group(const tinygltf::Node& node) { return node.name == kGroup && node.mesh < 0; }

}  // namespace citykiln::exporters
