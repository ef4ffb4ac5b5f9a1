#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/texts/utf8.h"
#include "exporters/file.h"
#include "exporters/gltf/glb.h"
#include "exporters/gltf/glb_checks.h"
#include "exporters/gltf/glb_names.h"
#include "exporters/gltf/image_units.h"
#include "exporters/gltf/pack/compress_glb.h"
#include "exporters/gltf/pack/shared_layout.h"
#include "exporters/gltf/read/decode_nodes.h"
#include "exporters/gltf/read/decode_pictures.h"
#include "exporters/gltf/read/glb_reader.h"
#include "exporters/tags_json.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using tinygltf::Value;

using bake::FeatureAttributes;

// Every row has a copy of its class, so that no small file may have a long one.
constexpr std::size_t kMostClassBytes = 64;

// The table and its schema.
struct Table {
  GltfReader& reader;
  const Value& schema;
  const Value& columns;
  std::size_t count;
};

// The first `count` values of a column.
template <typename T>
std::vector<T> values_in(GltfReader& reader, const Value& column, const char* member_name, std::size_t count) {
  const auto bytes = bytes_of(reader, whole(member(column, member_name)));
  expect(count <= bytes.size() / sizeof(T), "the property table to be as long as it says");
  std::vector<T> values(count);
  if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  return values;
}

std::vector<OsmId> ids_of(const Table& table) {
  const auto ids = values_in<std::uint64_t>(table.reader, member(table.columns, "id"), "values", table.count);
  const auto types = values_in<std::uint8_t>(table.reader, member(table.columns, "type"), "values", table.count);
  std::vector<OsmId> features(table.count);
  for (std::size_t i = 0; i < table.count; ++i) {
    expect(types[i] < kOsmTypeCount, "OSM types from 0 to 4");
    features[i] = {static_cast<OsmType>(types[i]), static_cast<std::int64_t>(ids[i])};
  }
  return features;
}

std::string text_in(const Value& value) {
  expect(value.IsString(), "a text");
  return value.Get<std::string>();
}

// The names of the enum's values, which are numbered from 0; the first one stands for none.
std::vector<std::string> kind_names_in(const Table& table) {
  const Value& values = member(member(member(table.schema, "enums"), "class"), "values");
  expect(values.IsArray() && values.ArrayLen() > 0, "the classes of features");
  std::vector<std::string> kinds = {""};
  for (std::size_t i = 1; i < values.ArrayLen(); ++i) {
    kinds.push_back(text_in(member(values.Get(i), "name")));
    expect(kinds.back().size() <= kMostClassBytes, "short names of classes");
  }
  return kinds;
}

void read_kinds(const Table& table, std::vector<FeatureAttributes>& rows) {
  const std::vector<std::string> kinds = kind_names_in(table);
  const auto numbers = values_in<std::uint16_t>(table.reader, member(table.columns, "class"), "values", table.count);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    expect(numbers[i] < kinds.size(), "classes that the enum lists");
    rows[i].kind = kinds[numbers[i]];
  }
}

void read_heights(const Table& table, std::vector<FeatureAttributes>& rows) {
  const auto heights_m = values_in<float>(table.reader, member(table.columns, "height_m"), "values", table.count);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    expect(std::isfinite(heights_m[i]) && heights_m[i] >= 0, "heights of at least 0");
    rows[i].height_m = heights_m[i];
  }
}

// The column of assumptions, if the table has it.
void read_assumed(const Table& table, std::vector<FeatureAttributes>& rows) {
  if (!table.columns.Has("assumed")) return;
  const auto sets = values_in<Assumptions>(table.reader, member(table.columns, "assumed"), "values", table.count);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].assumed = sets[i];
}

std::vector<std::uint32_t> text_offsets_in(const Table& table, const Value& column) {
  if (text_in(member(column, "stringOffsetType")) == "UINT32")
    return values_in<std::uint32_t>(table.reader, column, "stringOffsets", table.count + 1);
  const auto narrow = values_in<std::uint16_t>(table.reader, column, "stringOffsets", table.count + 1);
  return {narrow.begin(), narrow.end()};
}

// Stores each text of a column, if the table has it.
template <typename Store>
void read_texts(const Table& table, const char* name, Store store, std::vector<FeatureAttributes>& rows) {
  if (!table.columns.Has(name)) return;
  const Value& column = table.columns.Get(name);
  const std::vector<std::uint32_t> offsets = text_offsets_in(table, column);
  const auto bytes = bytes_of(table.reader, whole(member(column, "values")));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    expect(offsets[i] <= offsets[i + 1] && offsets[i + 1] <= bytes.size(), "texts inside their buffer view");
    std::string text(reinterpret_cast<const char*>(bytes.data()) + offsets[i], offsets[i + 1] - offsets[i]);
    expect(is_utf8(text), "texts in UTF-8");
    store(std::move(text), rows[i]);
  }
}

void store_name(std::string text, FeatureAttributes& row) { row.name = std::move(text); }

void store_tags(const std::string& text, FeatureAttributes& row) {
  std::optional<map::TagList> tags = tags_in(text);
  expect(tags.has_value(), "tags as JSON objects of texts");
  row.tags = std::move(*tags);
}

// Reads the features and attributes that property_table() writes into the tile. Throws FormatError.
void read_property_table(GltfReader& reader, bake::BakedTile& tile) {
  const auto extension = reader.model.extensions.find(kMetadataExtension);
  expect(extension != reader.model.extensions.end(), "the table of OSM ids");
  const Value& tables = member(extension->second, "propertyTables");
  expect(tables.IsArray() && tables.ArrayLen() > 0, "the table of OSM ids");
  const auto count = whole(member(tables.Get(0), "count"));
  const Table table{reader, member(extension->second, "schema"), member(tables.Get(0), "properties"),
                    static_cast<std::size_t>(std::max(0, count))};
  tile.features = ids_of(table);
  if (!table.columns.Has("class")) return;
  tile.attributes.resize(table.count);
  read_kinds(table, tile.attributes);
  read_texts(table, "name", store_name, tile.attributes);
  read_heights(table, tile.attributes);
  read_texts(table, "tags", store_tags, tile.attributes);
  read_assumed(table, tile.attributes);
}

// The image that a primitive's uvs lie on; null where they show none.
const materials::TextureImage* image_under_uvs(const BakedTile& tile, const bake::Primitive& p,
                                               const impostor::Cutout* cutout) {
  if (p.colour_source == materials::ColourSource::kByMarkingAtlas) return &tile.marking_atlas;
  if (p.colour_source == materials::ColourSource::kByAtlas) return &tile.facade_atlas.colour;
  if (p.colour_source == materials::ColourSource::kByCutout) return cutout == nullptr ? nullptr : &cutout->colour;
  const auto texture = std::ranges::find(tile.textures, p.material, &materials::Texture::material);
  return texture == tile.textures.end() ? nullptr : &shown_image(**texture);
}

void put_uvs_in_metres(std::vector<bake::Primitive>& primitives, const impostor::Cutout* cutout,
                       const BakedTile& tile) {
  for (bake::Primitive& p : primitives) {
    const materials::TextureImage* image = image_under_uvs(tile, p, cutout);
    if (image == nullptr) continue;
    for (bake::Float2& uv : p.uvs) {
      uv = in_metres(*image, p.colour_source, uv);
      expect(std::isfinite(uv[0]) && std::isfinite(uv[1]), "texture coordinates in single precision");
    }
  }
}

void put_uvs_in_metres(BakedTile& tile) {
  put_uvs_in_metres(tile.primitives, nullptr, tile);
  for (bake::InstancedMesh& instanced : tile.instanced)
    put_uvs_in_metres(instanced.primitives, &*instanced.cutout, tile);
}

std::optional<bake::Viewpoint> viewpoint_of(const Value& extras) {
  if (!extras.Has("viewpoint")) return std::nullopt;
  const Value &seen = member(extras, "viewpoint"), &eye = member(seen, "eye_m");
  return bake::Viewpoint{{element(eye, 0), element(eye, 1), element(eye, 2)},
                         number(member(seen, "focal_px")),
                         number(member(seen, "pixel_error"))};
}

// The cylinder that a tile is in, if it is in one.
std::optional<bake::CylinderFrame> cylinder_of(const Value& extras) {
  if (!extras.Has("frame")) return std::nullopt;
  const Value& frame = member(extras, "frame");
  if (!frame.IsObject() || !frame.Has("radius_m")) return std::nullopt;
  const bake::CylinderFrame cylinder{number(member(frame, "radius_m")), number(member(frame, "middle_y_m"))};
  expect(cylinder.radius_m >= map::kLeastCylinder_m && cylinder.radius_m <= map::kLargestCylinder_m &&
             std::abs(cylinder.middle_y_m) < 1e7,
         "a radius and a place of a cylinder");
  return cylinder;
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
  tile.object_error_m = tile.error_m;
  tile.plant_error_m = number(member(root.extras, "plant_error_m"));
  tile.viewpoint = viewpoint_of(root.extras), tile.cylinder = cylinder_of(root.extras);
  read_property_table(reader, tile);
  const auto cutouts = read_nodes(reader, tile);
  read_pictures(reader, cutouts, tile);
  const auto& used = model.extensionsUsed;
  if (std::ranges::find(used, kTextureTransformExtension) == used.end()) put_uvs_in_metres(tile);
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
