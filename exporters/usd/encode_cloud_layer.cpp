#include "exporters/usd/encode_cloud_layer.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/geometry/mathematics.h"
#include "exporters/usd/crate_writer.h"
#include "exporters/usd/usd_builder.h"

namespace citykiln::exporters {
namespace {

using bake::Float3;

UsdBounds bounds_of_spheres(const sky::LayerParticles& layer) {
  UsdBounds bounds;
  for (const sky::CloudParticle& sphere : layer.spheres) {
    const Vec3 half{sphere.radius_m, sphere.radius_m, sphere.radius_m};
    include(bounds, sphere.centre - half), include(bounds, sphere.centre + half);
  }
  return bounds;
}

UsdBounds in_plane(const sky::LayerParticles& layer) {
  UsdBounds bounds;
  for (const sky::CloudParticle& sphere : layer.spheres) {
    const auto [low, high] = sky::box_of(sphere, layer.frame);
    include(bounds, low), include(bounds, high);
  }
  return bounds;
}

// Scales, turns to the wind, then lifts to the base, like LayerFrame::out_of().
void write_frame(LayerWriter& writer, const sky::LayerFrame& frame) {
  const std::vector<std::string> order = {"xformOp:translate", "xformOp:rotateZ", "xformOp:scale"};
  writer.write({.type = "double3", .name = order[0], .value = Vec3{0, 0, frame.base_m}});
  writer.write({.type = "double", .name = order[1], .value = arctangent2_deg(frame.along.y, frame.along.x)});
  writer.write({.type = "double3", .name = order[2], .value = Vec3{frame.stretch, 1, frame.flatten}});
  writer.write({.type = "token[]", .name = "xformOpOrder", .value = UsdTokens{order}, .is_uniform = true});
}

void write_cloud_extent(LayerWriter& writer, const UsdBounds& bounds) {
  const auto extent = extent_of(is_empty(bounds) ? UsdBounds{{}, {}} : bounds);
  writer.write({.type = "float3[]", .name = "extent", .value = std::span<const Float3>(extent)});
}

void write_points(LayerWriter& writer, const sky::LayerParticles& layer) {
  std::vector<Float3> points;
  std::vector<float> widths;
  for (const sky::CloudParticle& sphere : layer.spheres) {
    points.push_back(bake::narrowed(sphere.centre));
    widths.push_back(static_cast<float>(2 * sphere.radius_m));
  }
  const std::vector<Float3> white = {{0.92f, 0.92f, 0.92f}};
  writer.begin_prim({.type = "Points", .name = "particles"});
  write_cloud_extent(writer, bounds_of_spheres(layer));
  writer.write({.type = "point3f[]", .name = "points", .value = std::span<const Float3>(points)});
  writer.write(
      {.type = "float[]", .name = "widths", .value = std::span<const float>(widths), .interpolation = "vertex"});
  writer.write({.type = "color3f[]",
                .name = "primvars:displayColor",
                .value = std::span<const Float3>(white),
                .interpolation = "constant"});
  writer.write({.type = "token", .name = "purpose", .value = UsdToken{"proxy"}, .is_uniform = true});
  writer.end_prim();
}

void write_volume(LayerWriter& writer, const UsdBounds& bounds) {
  writer.begin_prim({.type = "Volume", .name = "volume"});
  write_cloud_extent(writer, bounds);
  writer.write({.type = "token", .name = "purpose", .value = UsdToken{"render"}, .is_uniform = true});
  writer.write(UsdRelationship{"field:density", {"/clouds/volume/density"}});
  writer.begin_prim({.type = "OpenVDBAsset", .name = "density"});
  writer.write({.type = "asset", .name = "filePath", .value = UsdAsset{"./clouds.vdb"}});
  writer.write({.type = "token", .name = "fieldName", .value = UsdToken{"density"}});
  writer.end_prim(), writer.end_prim();
}

// "cumulus", and "cumulus_2" for the second of its kind.
std::string unique_layer_name(std::span<const sky::LayerParticles> layers, std::size_t i) {
  const auto kind = layers[i].layer.kind;
  const auto before = std::ranges::count(layers.first(i), kind, [](const auto& other) { return other.layer.kind; });
  return before > 0 ? fmt::format("{}_{}", sky::name_of(kind), before + 1) : std::string(sky::name_of(kind));
}

}  // namespace

std::vector<std::byte> encode_cloud_layer(std::span<const sky::LayerParticles> layers, bool has_volume) {
  CrateWriter writer({.default_prim = "clouds"});
  writer.begin_prim({.type = "Xform", .name = "clouds", .kind = "component"});
  UsdBounds bounds;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const sky::CloudLayer& layer = layers[i].layer;
    writer.begin_prim({.type = "Xform",
                       .name = unique_layer_name(layers, i),
                       .custom_data = {{"cover", layer.cover},
                                       {"base_m", layer.base_m},
                                       {"top_m", layer.top_m},
                                       {"clouds", static_cast<std::int32_t>(layers[i].clouds)},
                                       {"extinction_per_m", sky::extinction_per_m(layer.kind)}}});
    write_frame(writer, layers[i].frame);
    write_points(writer, layers[i]);
    writer.end_prim();
    include(bounds, in_plane(layers[i]));
  }
  if (has_volume) write_volume(writer, bounds);
  writer.end_prim();
  return writer.finish();
}

}  // namespace citykiln::exporters
