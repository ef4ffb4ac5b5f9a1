#include "exporters/usd/usd_lights.h"

#include <fmt/format.h>

#include "compiler/geometry/trig.h"
#include "exporters/usd/encode_scene.h"

namespace citykiln::exporters {
namespace {

constexpr double kLantern_m = 0.1, kHead_m = 0.15;

double luminance_of(const props::Luminaire& light) {
  const double axis_cd = light.lumen / props::beam_sr(light.beam);
  const double radius_m = light.beam == props::Beam::kDown ? kHead_m : kLantern_m;
  // seen along the axis, both are a disk of this radius
  return axis_cd / (kPi * radius_m * radius_m);
}

UsdDictionary data_of(const bake::PlacedLamp& lamp) {
  const OsmId id = lamp.placement.feature;
  return {{"class", std::string(lamp.kind == props::LampKind::kArm ? "ArmLamp" : "PostTopLamp")},
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
  static const std::string kOrder[] = {"xformOp:translate"};
  writer.write({.type = "token[]", .name = "xformOpOrder", .value = UsdTokens{kOrder}, .is_uniform = true});
  writer.end_prim();
}

}  // namespace

void write_usd_lights(LayerWriter& writer, std::span<const bake::PlacedLamp> lamps, Vec3 origin) {
  if (lamps.empty()) return;
  writer.begin_prim({.type = "Scope", .name = "lights"});
  for (std::size_t i = 0; i < lamps.size(); ++i) write_lamp(writer, lamps[i], origin, i);
  writer.end_prim();
}

}  // namespace citykiln::exporters
