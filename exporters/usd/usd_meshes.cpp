#include "exporters/usd/usd_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>

#include "exporters/gltf/image_units.h"
#include "exporters/gltf/leaf_backs.h"
#include "exporters/gltf/material_names.h"
#include "exporters/rotated.h"
#include "exporters/usd/usd_materials.h"
#include "exporters/usd/usd_names.h"

namespace citykiln::exporters {
namespace {

using bake::Float2;
using bake::Float3;
using bake::InstancedMesh;
using bake::Primitive;
using materials::ColourSource;
using Ints = std::vector<std::int32_t>;

std::span<const std::int32_t> view(const Ints& numbers) { return numbers; }

void write_extent(UsdBuilder& b, const UsdBounds& bounds) {
  const auto extent = extent_of(bounds);
  b.writer.write({.type = "float3[]", .name = "extent", .value = std::span<const Float3>(extent)});
}

UsdBounds bounds_of(const Primitive& p) {
  UsdBounds bounds;
  for (const Float3& position : p.positions) include(bounds, bake::widened(position));
  return bounds;
}

void write_faces(UsdBuilder& b, const Primitive& p) {
  const Ints counts(p.triangles.size(), 3);
  Ints indices;
  indices.reserve(3 * p.triangles.size());
  for (const auto& triangle : p.triangles)
    for (const std::uint32_t vertex : triangle) indices.push_back(static_cast<std::int32_t>(vertex));
  b.writer.write({.type = "int[]", .name = "faceVertexCounts", .value = view(counts)});
  b.writer.write({.type = "int[]", .name = "faceVertexIndices", .value = view(indices)});
}

// Image units, with v up as `st` has it.
void write_st(UsdBuilder& b, const Primitive& p, const materials::TextureImage& image) {
  std::vector<Float2> st;
  st.reserve(p.uvs.size());
  for (const Float2& uv_m : p.uvs) {
    const Float2 uv = in_image_units(image, uv_m);
    st.push_back({uv[0], 1.0f - uv[1]});
  }
  b.writer.write(
      {.type = "texCoord2f[]", .name = "primvars:st", .value = std::span<const Float2>(st), .interpolation = "vertex"});
}

Float3 colour_of(materials::Material material, const materials::Tint& tint) {
  const auto& base = values_of(material).base_colour;
  const auto channel = [&](std::size_t c) { return base[c] * (static_cast<float>(tint[c]) / 255.0f); };
  return {channel(0), channel(1), channel(2)};
}

void write_colours(UsdBuilder& b, const Primitive& p) {
  std::vector<Float3> colours;
  std::map<materials::Tint, std::int32_t> numbers;  // of tints without their opacity, by first use
  Ints indices;
  for (materials::Tint tint : p.colours) {
    tint[3] = 255;
    const auto [at, is_new] = numbers.try_emplace(tint, static_cast<std::int32_t>(colours.size()));
    if (is_new) colours.push_back(colour_of(p.material, tint));
    indices.push_back(at->second);
  }
  const bool is_constant = colours.size() == 1;
  b.writer.write({.type = "color3f[]",
                  .name = "primvars:displayColor",
                  .value = std::span<const Float3>(colours),
                  .interpolation = is_constant ? "constant" : "vertex"});
  if (!is_constant) b.writer.write({.type = "int[]", .name = "primvars:displayColor:indices", .value = view(indices)});
}

void write_features(UsdBuilder& b, const Primitive& p) {
  if (p.features.empty()) return;
  const bool is_pure = std::ranges::all_of(p.triangles, [&](const auto& t) {
    return p.features[t[0]] == p.features[t[1]] && p.features[t[1]] == p.features[t[2]];
  });
  Ints rows;
  if (is_pure)
    for (const auto& t : p.triangles) rows.push_back(static_cast<std::int32_t>(p.features[t[0]]));
  else
    rows.assign(p.features.begin(), p.features.end());
  b.writer.write({.type = "int[]",
                  .name = "primvars:feature",
                  .value = view(rows),
                  .interpolation = is_pure ? "uniform" : "vertex"});
}

UsdBounds write_mesh(UsdBuilder& b, const std::string& name, const Primitive& front, const impostor::Cutout* cutout) {
  const bool is_leaf = front.colour_source == ColourSource::kByCutout;
  const bool is_backed = is_leaf && has_backs(front);
  const bool is_flat = is_leaf || materials::has_holes(front.material);
  const std::string material = material_path(b, front, cutout);
  const Primitive both = is_backed ? with_backs(front) : Primitive{};
  const Primitive& p = is_backed ? both : front;
  const UsdBounds bounds = bounds_of(p);
  b.writer.begin_prim({.type = "Mesh", .name = name, .api_schemas = {"MaterialBindingAPI"}});
  write_extent(b, bounds);
  b.writer.write({.type = "bool", .name = "doubleSided", .value = is_flat && !is_backed, .is_uniform = true});
  b.writer.write({.type = "token", .name = "orientation", .value = UsdToken{"rightHanded"}, .is_uniform = true});
  b.writer.write({.type = "token", .name = "subdivisionScheme", .value = UsdToken{"none"}, .is_uniform = true});
  write_faces(b, p);
  b.writer.write({.type = "point3f[]", .name = "points", .value = std::span<const Float3>(p.positions)});
  b.writer.write({.type = "normal3f[]",
                  .name = "normals",
                  .value = std::span<const Float3>(p.normals),
                  .interpolation = "vertex"});
  if (const materials::TextureImage* image = image_of(b, p, cutout)) write_st(b, p, *image);
  write_colours(b, p);
  write_features(b, p);
  b.writer.write(UsdRelationship{"material:binding", {material}});
  b.writer.end_prim();
  return bounds;
}

// ---- instances ----

// The box around a placed box.
UsdBounds placed(const UsdBounds& own, const InstancedMesh& instanced, std::size_t i) {
  UsdBounds box;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at{corner & 1 ? own.high.x : own.low.x, corner & 2 ? own.high.y : own.low.y,
                  corner & 4 ? own.high.z : own.low.z};
    const Vec3 turned = rotated(instanced.rotations[i], at * static_cast<double>(instanced.scales[i]));
    include(box, turned + bake::widened(instanced.translations[i]));
  }
  return box;
}

// The attributes of all instances, prototype by prototype.
struct Placements {
  Ints prototypes, features;
  std::vector<std::int64_t> ids;
  std::vector<Float3> positions, scales;
  std::vector<UsdQuath> orientations;
  UsdBounds bounds;
};

UsdQuath half_quaternion(const bake::Float4& q) {
  return {half_bits(q[0]), half_bits(q[1]), half_bits(q[2]), half_bits(q[3])};
}

void append_placements(Placements& all, const InstancedMesh& instanced, std::int32_t prototype, const UsdBounds& own) {
  for (std::size_t i = 0; i < instanced.translations.size(); ++i) {
    const float scale = instanced.scales[i];
    all.ids.push_back(static_cast<std::int64_t>(all.ids.size()));
    all.prototypes.push_back(prototype);
    all.features.push_back(static_cast<std::int32_t>(instanced.features[i]));
    all.positions.push_back(instanced.translations[i]);
    all.scales.push_back({scale, scale, scale});
    all.orientations.push_back(half_quaternion(instanced.rotations[i]));
    include(all.bounds, placed(own, instanced, i));
  }
}

void write_placements(UsdBuilder& b, const Placements& all) {
  write_extent(b, all.bounds);
  b.writer.write({.type = "int64[]", .name = "ids", .value = std::span<const std::int64_t>(all.ids)});
  b.writer.write({.type = "quath[]", .name = "orientations", .value = std::span<const UsdQuath>(all.orientations)});
  b.writer.write({.type = "point3f[]", .name = "positions", .value = std::span<const Float3>(all.positions)});
  b.writer.write({.type = "int[]", .name = "protoIndices", .value = view(all.prototypes)});
  b.writer.write({.type = "float3[]", .name = "scales", .value = std::span<const Float3>(all.scales)});
  b.writer.write({.type = "int[]", .name = "primvars:feature", .value = view(all.features), .interpolation = "vertex"});
}

UsdBounds bounds_of(const InstancedMesh& instanced) {
  UsdBounds bounds;
  for (const Primitive& p : instanced.primitives) include(bounds, bounds_of(p));
  return bounds;
}

// Names of prototypes, each once.
std::vector<std::string> prototype_names(std::span<const InstancedMesh> instanced) {
  std::vector<std::string> names;
  for (const InstancedMesh& each : instanced) {
    const std::string name = usd_identifier(each.name);
    const bool is_taken = std::ranges::count(names, name) > 0;
    names.push_back(is_taken ? fmt::format("{}_{}", name, names.size()) : name);
  }
  return names;
}

}  // namespace

UsdBounds write_meshes(UsdBuilder& b, std::span<const Primitive> primitives, const impostor::Cutout* cutout) {
  UsdBounds bounds;
  std::vector<std::string> names;
  for (const Primitive& p : primitives) {
    bake::PrimitiveKey key = key_of(p);
    key.has_uvs = image_of(b, p, cutout) != nullptr;
    std::string name = material_name(key, b.tile.textures);
    if (std::ranges::count(names, name) > 0) name += fmt::format("_{}", names.size());
    names.push_back(name);
    include(bounds, write_mesh(b, name, p, cutout));
  }
  return bounds;
}

void write_instances(UsdBuilder& b, const std::string& path, std::span<const InstancedMesh> instanced) {
  assert(!instanced.empty());
  const std::vector<std::string> names = prototype_names(instanced);
  Placements all;
  UsdRelationship prototypes{"prototypes", {}};
  for (std::size_t i = 0; i < instanced.size(); ++i) {
    append_placements(all, instanced[i], static_cast<std::int32_t>(i), bounds_of(instanced[i]));
    prototypes.targets.push_back(fmt::format("{}/instances/meshes/{}", path, names[i]));
  }
  include(b.bounds, all.bounds);
  b.writer.begin_prim({.type = "PointInstancer", .name = "instances"});
  write_placements(b, all);
  b.writer.write(prototypes);
  // not "prototypes": tinyusdz takes a prim and a property of one name for the same
  b.writer.begin_prim({.type = "Scope", .name = "meshes"});
  for (std::size_t i = 0; i < instanced.size(); ++i) {
    b.writer.begin_prim({.type = "Xform", .name = names[i]});
    write_meshes(b, instanced[i].primitives, shared_cutout(b, *instanced[i].cutout));
    b.writer.end_prim();
  }
  b.writer.end_prim();
  b.writer.end_prim();
}

}  // namespace citykiln::exporters
