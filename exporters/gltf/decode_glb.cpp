#include <cmath>
#include <cstring>
#include <exception>
#include <filesystem>
#include <limits>
#include <optional>

#include "exporters/file.h"
#include "exporters/gltf/compress_glb.h"
#include "exporters/gltf/decode_pictures.h"
#include "exporters/gltf/decode_primitives.h"
#include "exporters/gltf/glb.h"
#include "exporters/gltf/glb_checks.h"
#include "exporters/gltf/glb_reader.h"
#include "exporters/gltf/shared_layout.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using bake::Float3;
using bake::Float4;
using bake::InstancedMesh;
using tinygltf::Value;

std::vector<OsmId> features_of(GltfReader& reader) {
  const auto extension = reader.model.extensions.find("EXT_structural_metadata");
  expect(extension != reader.model.extensions.end(), "the table of OSM ids");
  const Value& tables = member(extension->second, "propertyTables");
  expect(tables.IsArray() && tables.ArrayLen() > 0, "the table of OSM ids");
  const Value& table = tables.Get(0);
  const Value& columns = member(table, "properties");
  const auto ids = bytes_of(reader, whole(member(member(columns, "id"), "values"))),
             types = bytes_of(reader, whole(member(member(columns, "type"), "values")));
  const auto count = static_cast<std::size_t>(std::max(0, whole(member(table, "count"))));
  expect(count <= types.size() && count <= ids.size() / 8, "the table of OSM ids to be as long as it says");
  std::vector<OsmId> features(count);
  for (std::size_t i = 0; i < count; ++i) {
    expect(types[i] < 4, "OSM types from 0 to 3");
    features[i].type = static_cast<OsmType>(types[i]);
    std::memcpy(&features[i].id, ids.data() + 8 * i, 8);
  }
  return features;
}

InstancedMesh extended(GltfReader& reader, const tinygltf::Node& node, std::size_t features) {
  const Value& attributes = member(node.extensions.at("EXT_mesh_gpu_instancing"), "attributes");
  const auto accessor = [&](const char* name) { return whole(member(attributes, name)); };
  InstancedMesh out{node.name, primitives_of(reader, node.mesh, features), {}, {}, {}, {}};
  out.translations =
      turned(values_of<Float3>(reader, accessor("TRANSLATION"), TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3));
  out.rotations =
      turned(values_of<Float4>(reader, accessor("ROTATION"), TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC4));
  for (const Float3& s :
       values_of<Float3>(reader, accessor("SCALE"), TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3))
    out.scales.push_back(s[0]);
  out.features = as_numbers(
      values_of<float>(reader, accessor("_FEATURE_ID_0"), TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_SCALAR),
      features);
  const std::size_t n = out.translations.size();
  expect(out.rotations.size() == n && out.scales.size() == n && out.features.size() == n,
         "as many values for each instance");
  return out;
}

void add_single(const tinygltf::Node& node, std::size_t features, InstancedMesh& out) {
  expect(node.translation.size() == 3 && node.rotation.size() == 4 && node.scale.size() == 3,
         "a place for each instance");
  const auto f = [](double v) {
    expect(std::abs(v) <= std::numeric_limits<float>::max(), "places in single precision");
    return static_cast<float>(v);
  };
  const int feature = whole(member(node.extras, "feature"));
  expect(feature >= 0 && static_cast<std::size_t>(feature) < features, "feature ids inside the property table");
  out.translations.push_back(from_gltf(Float3{f(node.translation[0]), f(node.translation[1]), f(node.translation[2])}));
  out.rotations.push_back(
      from_gltf(Float4{f(node.rotation[0]), f(node.rotation[1]), f(node.rotation[2]), f(node.rotation[3])}));
  out.scales.push_back(f(node.scale[0]));
  out.features.push_back(static_cast<std::uint32_t>(feature));
}

// Reads instanced meshes, whose nodes follow each other. Returns the cutout image of each.
std::vector<std::optional<std::size_t>> add_instances(GltfReader& reader, const tinygltf::Node& root, BakedTile& tile) {
  std::vector<std::optional<std::size_t>> cutouts;  // one per entry of tile.instanced
  int last_mesh = root.mesh;
  bool is_open = false;
  for (const int child : root.children) {
    const tinygltf::Node& node = item(reader.model.nodes, child, "a node that exists");
    const bool is_extended = node.extensions.count("EXT_mesh_gpu_instancing") != 0;
    const bool goes_on = is_open && !is_extended && node.mesh == last_mesh;
    expect(goes_on || node.mesh > last_mesh, "each mesh in nodes that follow each other, in order");
    last_mesh = node.mesh, is_open = !is_extended;
    if (!goes_on) cutouts.push_back(cutout_image_of(reader.model, node.mesh));
    if (is_extended) {
      tile.instanced.push_back(extended(reader, node, tile.features.size()));
      continue;
    }
    if (!goes_on)
      tile.instanced.push_back({node.name, primitives_of(reader, node.mesh, tile.features.size()), {}, {}, {}, {}});
    add_single(node, tile.features.size(), tile.instanced.back());
  }
  return cutouts;
}

std::optional<bake::Viewpoint> viewpoint_of(const Value& extras) {
  if (!extras.Has("viewpoint")) return std::nullopt;
  const Value &seen = member(extras, "viewpoint"), &eye = member(seen, "eye_m");
  return bake::Viewpoint{{element(eye, 0), element(eye, 1), element(eye, 2)},
                         number(member(seen, "focal_px")),
                         number(member(seen, "pixel_error"))};
}

BakedTile tile_of(const tinygltf::Model& model) {
  expect(!model.nodes.empty() && model.buffers.size() == 1, "a node for the tile, and one buffer");
  GltfReader reader{model, model.buffers.front().data.size()};
  const tinygltf::Node& root = model.nodes.front();
  BakedTile tile;
  const Value &key = member(root.extras, "tile"), &origin = member(root.extras, "origin_m");
  expect(key.IsArray() && key.ArrayLen() == 2, "the tile's two numbers");
  tile.tile = {whole(key.Get(0)), whole(key.Get(1))};
  tile.origin = {element(origin, 0), element(origin, 1), element(origin, 2)};
  tile.tolerance_m = number(member(root.extras, "tolerance_m")), tile.error_m = number(member(root.extras, "error_m"));
  tile.plant_error_m = number(member(root.extras, "plant_error_m"));
  tile.viewpoint = viewpoint_of(root.extras);
  tile.features = features_of(reader);
  if (root.mesh >= 0) tile.primitives = primitives_of(reader, root.mesh, tile.features.size());
  const auto cutouts = add_instances(reader, root, tile);
  read_pictures(reader, cutouts, tile);
  return tile;
}

// Leaves images in the buffer, for read_pictures.
bool leave_picture(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                   void*) {
  return true;
}

BakedTile tile_of_plain(std::span<const std::byte> bytes) {
  expect_pictures_inside(bytes);
  tinygltf::Model model;
  std::string error, warning;
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto size = static_cast<unsigned int>(bytes.size());
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(leave_picture, nullptr);
  if (!loader.LoadBinaryFromMemory(&model, &error, &warning, data, size))
    throw FormatError{"binary glTF: " + error.substr(0, error.find('\n'))};
  return tile_of(model);
}

}  // namespace

Result<BakedTile> decode_glb(std::span<const std::byte> bytes, const std::string& name) {
  try {
    expect(bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0,
           "a binary glTF file, which begins with glTF");
    expect_chunks(bytes);
    const auto plain = decompressed_glb(bytes);
    return tile_of_plain(plain ? *plain : bytes);
  } catch (const FormatError& wrong) {
    return Error{name, "expected " + wrong.what};
  } catch (const std::exception& thrown) {
    return Error{name, std::string("expected binary glTF: ") + thrown.what()};
  }
}

Result<BakedTile> read_glb(const std::string& path) {
  auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  const auto whole = with_shared_files(std::move(*bytes), std::filesystem::path(path).parent_path().string(), path);
  if (!whole) return whole.error();
  return decode_glb(*whole, path);
}

}  // namespace citykiln::exporters
