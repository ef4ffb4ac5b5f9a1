#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <string_view>

#include "exporters/compress_glb.h"
#include "exporters/file.h"
#include "exporters/glb.h"
#include "exporters/glb_frame.h"
#include "exporters/glb_parts.h"
#include "exporters/png.h"
#include "exporters/tinygltf_switches.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using bake::Float2;
using bake::Float3;
using bake::Float4;
using bake::Instanced;
using bake::Primitive;
using materials::Coloured;
using tinygltf::Value;

// What is wrong with a file: thrown inside this file only, and turned into an Error at its door.
struct Wrong {
  std::string what;
};

void expect(bool holds, const char* what) {
  if (!holds) throw Wrong{what};
}

template <typename T>
const T& item(const std::vector<T>& items, int index, const char* what) {
  expect(index >= 0 && static_cast<std::size_t>(index) < items.size(), what);
  return items[static_cast<std::size_t>(index)];
}

// A model while it is read. Each byte of the buffer is read once, so that no small file makes a large tile.
struct Source {
  const tinygltf::Model& model;
  std::size_t unread_bytes;
};

// The bytes of a buffer view, inside its buffer.
std::span<const unsigned char> bytes_of(Source& source, int view_number) {
  const tinygltf::BufferView& view = item(source.model.bufferViews, view_number, "a buffer view that exists");
  const auto& data = item(source.model.buffers, view.buffer, "a buffer that exists").data;
  expect(view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset,
         "buffer views inside the buffer");
  expect(view.byteLength <= source.unread_bytes, "each byte of the buffer to be used once");
  source.unread_bytes -= view.byteLength;
  return std::span(data).subspan(view.byteOffset, view.byteLength);
}

template <typename T>
std::vector<T> values_of(Source& source, int accessor_number, int component, int type) {
  const tinygltf::Accessor& accessor = item(source.model.accessors, accessor_number, "an accessor that exists");
  expect(accessor.componentType == component && accessor.type == type && accessor.byteOffset == 0,
         "accessors as citykiln writes them");
  const auto bytes = bytes_of(source, accessor.bufferView);
  expect(accessor.count <= bytes.size() / sizeof(T), "accessors inside their buffer view");
  std::vector<T> values(accessor.count);
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

template <typename T>
std::vector<T> finite(std::vector<T> values) {
  for (const T& v : values)
    for (const float c : v) expect(std::isfinite(c), "finite numbers");
  return values;
}

template <typename T>
std::vector<T> turned(std::vector<T> values) {
  values = finite(std::move(values));
  for (T& v : values) v = from_gltf(v);
  return values;
}

std::vector<std::uint32_t> as_numbers(const std::vector<float>& values, std::size_t below) {
  std::vector<std::uint32_t> numbers;
  for (const float v : values) {
    expect(v >= 0 && v < static_cast<float>(below), "feature ids inside the property table");
    numbers.push_back(static_cast<std::uint32_t>(v));
  }
  return numbers;
}

int attribute(const std::map<std::string, int>& attributes, const char* name) {
  const auto found = attributes.find(name);
  expect(found != attributes.end(), "the attributes that citykiln writes");
  return found->second;
}

const Value& member(const Value& value, const char* name) {
  expect(value.IsObject() && value.Has(name), "the extras and extensions that citykiln writes");
  return value.Get(name);
}

double number(const Value& value) {
  expect(value.IsNumber(), "a number");
  return value.GetNumberAsDouble();
}

int whole(const Value& value) {
  const double v = number(value);
  expect(v >= -2147483647.0 && v <= 2147483647.0, "a whole number");
  return static_cast<int>(v);
}

double element(const Value& array, std::size_t i) {
  expect(array.IsArray() && array.ArrayLen() > i, "an array long enough");
  return number(array.Get(i));
}

std::optional<materials::Material> material_called(std::string_view name) {
  for (int m = 0; m < static_cast<int>(materials::Material::kCount); ++m)
    if (const auto material = static_cast<materials::Material>(m); values_of(material).name == name) return material;
  return std::nullopt;
}

// A name's beginning, where it ends so.
std::optional<std::string_view> without(std::string_view name, std::string_view ending) {
  if (!name.ends_with(ending)) return std::nullopt;
  return name.substr(0, name.size() - ending.size());
}

// What a material's name ends with says what colours it.
constexpr std::pair<std::string_view, Coloured> kEndings[] = {{"", Coloured::kByMaterial},
                                                              {"Plain", Coloured::kByMaterial},
                                                              {"Marked", Coloured::kBySheet},
                                                              {"Imprinted", Coloured::kByAtlas},
                                                              {"Cutout", Coloured::kByCutout}};

// Whether it has uvs is not for the material to say.
bake::PrimitiveKey key_named(const std::string& name) {
  for (const auto& [ending, coloured] : kEndings)
    if (const auto beginning = without(name, ending))
      if (const auto material = material_called(*beginning))
        return {*material, coloured != Coloured::kByMaterial, coloured};
  throw Wrong{"a material that citykiln has, not \"" + name + "\""};
}

// Metres, or 16 bits that count steps.
std::vector<Float2> uvs_of(Source& source, int accessor_number) {
  if (item(source.model.accessors, accessor_number, "an accessor that exists").componentType ==
      TINYGLTF_COMPONENT_TYPE_FLOAT)
    return finite(values_of<Float2>(source, accessor_number, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2));
  std::vector<Float2> uvs;
  for (const auto& [u, v] : values_of<std::array<std::uint16_t, 2>>(
           source, accessor_number, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_VEC2))
    uvs.push_back(
        {static_cast<float>(u * materials::kTexturePlace_m), static_cast<float>(v * materials::kTexturePlace_m)});
  return uvs;
}

// Pictures are read after meshes.
bool has_picture(const tinygltf::Model& model, Coloured coloured) {
  const char* name = coloured == Coloured::kBySheet ? "sheet" : coloured == Coloured::kByCutout ? "cutout" : "imprints";
  return coloured == Coloured::kByMaterial || std::ranges::count(model.images, name, &tinygltf::Image::name) > 0;
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(Source& source, int accessor, std::size_t vertices) {
  const bool narrow = item(source.model.accessors, accessor, "an accessor that exists").componentType ==
                      TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  std::vector<std::uint32_t> indices;
  if (narrow) {
    const auto values =
        values_of<std::uint16_t>(source, accessor, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR);
    indices.assign(values.begin(), values.end());
  } else {
    indices = values_of<std::uint32_t>(source, accessor, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR);
  }
  expect(indices.size() % 3 == 0, "three indices a triangle");
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) expect(indices[i + k] < vertices, "indices of vertices that exist");
    triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
  }
  return triangles;
}

Primitive primitive_of(Source& source, const tinygltf::Primitive& p, std::size_t features) {
  Primitive out;
  const bake::PrimitiveKey key = key_named(item(source.model.materials, p.material, "a material that exists").name);
  out.material = key.material, out.coloured = key.coloured;
  out.positions = turned(values_of<Float3>(source, attribute(p.attributes, "POSITION"), TINYGLTF_COMPONENT_TYPE_FLOAT,
                                           TINYGLTF_TYPE_VEC3));
  out.normals = turned(
      values_of<Float3>(source, attribute(p.attributes, "NORMAL"), TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3));
  out.colours = values_of<materials::Tint>(source, attribute(p.attributes, "COLOR_0"),
                                           TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_TYPE_VEC4);
  if (p.attributes.count("TEXCOORD_0") != 0) out.uvs = uvs_of(source, attribute(p.attributes, "TEXCOORD_0"));
  if (p.attributes.count("_FEATURE_ID_0") != 0)
    out.features = as_numbers(values_of<float>(source, attribute(p.attributes, "_FEATURE_ID_0"),
                                               TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_SCALAR),
                              features);
  const std::size_t n = out.positions.size();
  expect(out.normals.size() == n && out.colours.size() == n && (out.features.empty() || out.features.size() == n) &&
             (out.uvs.empty() || out.uvs.size() == n),
         "as many values in each attribute");
  expect(out.coloured == Coloured::kByMaterial || (!out.uvs.empty() && has_picture(source.model, out.coloured)),
         "a sheet, and a place on it, for each corner that is on it");
  out.triangles = triangles_of(source, p.indices, n);
  return out;
}

std::vector<Primitive> primitives_of(Source& source, int mesh, std::size_t features) {
  std::vector<Primitive> primitives;
  for (const tinygltf::Primitive& p : item(source.model.meshes, mesh, "a mesh that exists").primitives)
    primitives.push_back(primitive_of(source, p, features));
  return primitives;
}

std::vector<OsmId> features_of(Source& source) {
  const auto extension = source.model.extensions.find("EXT_structural_metadata");
  expect(extension != source.model.extensions.end(), "the table of OSM ids");
  const Value& tables = member(extension->second, "propertyTables");
  expect(tables.IsArray() && tables.ArrayLen() > 0, "the table of OSM ids");
  const Value& table = tables.Get(0);
  const Value& columns = member(table, "properties");
  const auto ids = bytes_of(source, whole(member(member(columns, "id"), "values"))),
             types = bytes_of(source, whole(member(member(columns, "type"), "values")));
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

// The size of a texel stands beside the picture.
double texel_m_of(const tinygltf::Image& image) {
  const double texel_m = number(member(image.extras, "texel_m"));
  expect(texel_m > 0 && std::isfinite(texel_m), "texels with a size");
  return texel_m;
}

materials::Sheet picture_of(Source& source, const tinygltf::Image& image) {
  auto picture = decode_png(std::as_bytes(bytes_of(source, image.bufferView)), "");
  if (!picture) throw Wrong{"a picture: " + to_string(picture.error())};
  picture->texel_m = texel_m_of(image);
  return std::move(*picture);
}

// The texture that a picture belongs to: the last one, or the next.
materials::Texture& texture_with(std::vector<materials::Texture>& textures, std::string_view name) {
  const auto material = material_called(name);
  expect(material.has_value(), "pictures named after materials, and one sheet at most");
  if (!textures.empty() && textures.back().material == *material) return textures.back();
  expect(textures.empty() || textures.back().material < *material, "each material's pictures once, in order");
  return textures.emplace_back(materials::Texture{*material, {}, {}});
}

void read_texture(Source& source, const tinygltf::Image& image, std::vector<materials::Texture>& textures) {
  const auto coloured = without(image.name, "Colour"), shaped = without(image.name, "Normal");
  expect(coloured || shaped, "pictures named after materials, and one sheet at most");
  materials::Texture& texture = texture_with(textures, coloured ? *coloured : *shaped);
  materials::Sheet& place = coloured ? texture.colour : texture.normal;
  expect(place.texels.empty() && (shaped || texture.normal.texels.empty()), "each material's pictures once, in order");
  place = picture_of(source, image);
  expect(place.columns == place.rows, "textures that are square");
}

// A cutout: its colours, and its normals where these follow.
imprint::Cutout read_cutout(Source& source, std::size_t image) {
  const auto& images = source.model.images;
  const auto bytes = std::as_bytes(bytes_of(source, images[image].bufferView));
  auto picture = decode_cut_png(bytes, "");
  if (!picture) throw Wrong{"a picture: " + to_string(picture.error())};
  imprint::Cutout cutout{std::move(picture->colour), std::move(picture->opacity), {}};
  cutout.colour.texel_m = texel_m_of(images[image]);
  if (image + 1 < images.size() && images[image + 1].name == "cutoutNormal")
    cutout.normal = picture_of(source, images[image + 1]);
  return cutout;
}

// Which picture colours a mesh's primitives on cutouts, if any.
std::optional<std::size_t> cutout_image_of(const tinygltf::Model& model, int mesh) {
  std::optional<std::size_t> number;
  for (const tinygltf::Primitive& p : item(model.meshes, mesh, "a mesh that exists").primitives) {
    const tinygltf::Material& m = item(model.materials, p.material, "a material that exists");
    if (key_named(m.name).coloured != Coloured::kByCutout) continue;
    const int texture = m.pbrMetallicRoughness.baseColorTexture.index;
    const int image = item(model.textures, texture, "a texture that exists").source;
    expect(item(model.images, image, "a picture that exists").name == "cutout", "leaves on a cutout");
    expect(!number || *number == static_cast<std::size_t>(image), "one cutout a mesh");
    number = static_cast<std::size_t>(image);
  }
  return number;
}

// From `first` on. Meshes may share them, each with a copy of its own: a small file must not make a large tile.
void read_cutouts(Source& source, std::size_t first, std::span<const std::optional<std::size_t>> wanted,
                  BakedTile& tile) {
  const auto& images = source.model.images;
  std::uint64_t texels = 0;
  for (std::size_t i = first; i < images.size(); ++i) {
    if (images[i].name == "cutoutNormal" && i > first && images[i - 1].name == "cutout") continue;
    expect(images[i].name == "cutout", "pictures named after materials, and one sheet at most");
    const imprint::Cutout cutout = read_cutout(source, i);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (wanted[k] != i) continue;
      texels += cutout.colour.texels.size() + cutout.normal.texels.size();
      expect(texels <= materials::kMostTexels, "no more cutouts than a sheet has texels");
      tile.instanced[k].cutout = cutout;
    }
  }
}

bool are_one_size(const imprint::Atlas& atlas) {
  const auto& [colour, surface, emission, normal] = atlas;
  const auto is_as_large = [&](const materials::Sheet& other) {
    return colour.columns == other.columns && colour.rows == other.rows && colour.texel_m == other.texel_m;
  };
  return is_as_large(surface) && (emission.texels.empty() || is_as_large(emission)) &&
         (normal.texels.empty() || is_as_large(normal));
}

// The sheet, if any, the atlas's two to four, if any, then colours and normals of materials, then cutouts.
void read_pictures(Source& source, std::span<const std::optional<std::size_t>> cutouts, BakedTile& tile) {
  const std::pair<const char*, materials::Sheet*> sheets[] = {{"sheet", &tile.sheet},
                                                              {"imprints", &tile.imprints.colour},
                                                              {"imprintsSurface", &tile.imprints.surface},
                                                              {"imprintsEmission", &tile.imprints.emission},
                                                              {"imprintsNormal", &tile.imprints.normal}};
  const auto& images = source.model.images;
  std::size_t i = 0;
  for (const auto& [name, place] : sheets)
    if (i < images.size() && images[i].name == name) *place = picture_of(source, images[i++]);
  for (; i < images.size() && images[i].name != "cutout"; ++i) read_texture(source, images[i], tile.textures);
  read_cutouts(source, i, cutouts, tile);
  expect(are_one_size(tile.imprints), "an atlas whose pictures are of one size");
}

Instanced extended(Source& source, const tinygltf::Node& node, std::size_t features) {
  const Value& attributes = member(node.extensions.at("EXT_mesh_gpu_instancing"), "attributes");
  const auto accessor = [&](const char* name) { return whole(member(attributes, name)); };
  Instanced out{node.name, primitives_of(source, node.mesh, features), {}, {}, {}, {}};
  out.translations =
      turned(values_of<Float3>(source, accessor("TRANSLATION"), TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3));
  out.rotations =
      turned(values_of<Float4>(source, accessor("ROTATION"), TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC4));
  for (const Float3& s :
       values_of<Float3>(source, accessor("SCALE"), TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3))
    out.scales.push_back(s[0]);
  out.features = as_numbers(
      values_of<float>(source, accessor("_FEATURE_ID_0"), TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_SCALAR),
      features);
  const std::size_t n = out.translations.size();
  expect(out.rotations.size() == n && out.scales.size() == n && out.features.size() == n,
         "as many values for each instance");
  return out;
}

void add_single(const tinygltf::Node& node, std::size_t features, Instanced& out) {
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

// Each mesh belongs to one kind of thing, whose nodes follow each other. Returns each one's cutout, by its picture.
std::vector<std::optional<std::size_t>> add_instances(Source& source, const tinygltf::Node& root, BakedTile& tile) {
  std::vector<std::optional<std::size_t>> cutouts;  // one an entry of tile.instanced
  int last_mesh = root.mesh;
  bool is_open = false;
  for (const int child : root.children) {
    const tinygltf::Node& node = item(source.model.nodes, child, "a node that exists");
    const bool is_extended = node.extensions.count("EXT_mesh_gpu_instancing") != 0;
    const bool goes_on = is_open && !is_extended && node.mesh == last_mesh;
    expect(goes_on || node.mesh > last_mesh, "each mesh for one kind of thing, in order");
    last_mesh = node.mesh, is_open = !is_extended;
    if (!goes_on) cutouts.push_back(cutout_image_of(source.model, node.mesh));
    if (is_extended) {
      tile.instanced.push_back(extended(source, node, tile.features.size()));
      continue;
    }
    if (!goes_on)
      tile.instanced.push_back({node.name, primitives_of(source, node.mesh, tile.features.size()), {}, {}, {}, {}});
    add_single(node, tile.features.size(), tile.instanced.back());
  }
  return cutouts;
}

std::optional<bake::SeenFrom> seen_from_of(const Value& extras) {
  if (!extras.Has("seen_from")) return std::nullopt;
  const Value &seen = member(extras, "seen_from"), &eye = member(seen, "eye_m");
  return bake::SeenFrom{{element(eye, 0), element(eye, 1), element(eye, 2)},
                        number(member(seen, "focal_px")),
                        number(member(seen, "pixel_error"))};
}

BakedTile tile_of(const tinygltf::Model& model) {
  expect(!model.nodes.empty() && model.buffers.size() == 1, "a node for the tile, and one buffer");
  Source source{model, model.buffers.front().data.size()};
  const tinygltf::Node& root = model.nodes.front();
  BakedTile tile;
  const Value &key = member(root.extras, "tile"), &origin = member(root.extras, "origin_m");
  expect(key.IsArray() && key.ArrayLen() == 2, "the tile's two numbers");
  tile.tile = {whole(key.Get(0)), whole(key.Get(1))};
  tile.origin = {element(origin, 0), element(origin, 1), element(origin, 2)};
  tile.tolerance_m = number(member(root.extras, "tolerance_m")), tile.error_m = number(member(root.extras, "error_m"));
  tile.plant_error_m = number(member(root.extras, "plant_error_m"));
  tile.seen_from = seen_from_of(root.extras);
  tile.features = features_of(source);
  if (root.mesh >= 0) tile.primitives = primitives_of(source, root.mesh, tile.features.size());
  const auto cutouts = add_instances(source, root, tile);
  read_pictures(source, cutouts, tile);
  return tile;
}

std::uint32_t number_at(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<std::uint32_t>(bytes[at + i]);
  return value;
}

// How deep brackets stand in each other. tinygltf calls itself for each.
int depth_of(std::span<const std::byte> json) {
  int depth = 0, deepest = 0;
  bool is_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = static_cast<char>(json[i]);
    if (is_text && c == '\\') ++i;
    if (c == '"') is_text = !is_text;
    if (!is_text && (c == '[' || c == '{')) deepest = std::max(deepest, ++depth);
    if (!is_text && (c == ']' || c == '}')) --depth;
  }
  return deepest;
}

// A whole number of JSON, which must be there; `otherwise` where it may be left out.
std::uint64_t json_number(const nlohmann::json& object, const char* name, std::optional<std::uint64_t> otherwise = {}) {
  if (otherwise && object.is_object() && !object.contains(name)) return *otherwise;
  expect(object.is_object() && object.contains(name) && object[name].is_number_unsigned(),
         "a sheet inside the buffer, as citykiln writes it");
  return object[name].get<std::uint64_t>();
}

// tinygltf takes the address of a picture's first byte before anyone can ask whether it is in the buffer.
void expect_pictures_inside(std::span<const std::byte> bytes) {
  const std::string_view json = json_of_glb(bytes);
  const auto keeps = [](int depth, nlohmann::json::parse_event_t event, const nlohmann::json& key) {
    return depth != 1 || event != nlohmann::json::parse_event_t::key || key == "images" || key == "bufferViews" ||
           key == "buffers";
  };
  const auto model = nlohmann::json::parse(json, keeps, false);
  if (!model.is_object() || !model.contains("images")) return;
  const auto buffers = model.value("buffers", nlohmann::json::array()),
             views = model.value("bufferViews", nlohmann::json::array());
  expect(model["images"].is_array() && buffers.is_array() && views.is_array() && buffers.size() == 1 &&
             buffers[0].is_object() && !buffers[0].contains("uri"),
         "a sheet inside the buffer, as citykiln writes it");
  for (const auto& image : model["images"]) {
    const std::uint64_t number = json_number(image, "bufferView");
    expect(number < views.size() && json_number(views[number], "buffer") == 0 &&
               json_number(views[number], "byteOffset", 0) < json_number(buffers[0], "byteLength"),
           "a sheet inside the buffer, as citykiln writes it");
  }
}

// Two chunks that fill the file: tinygltf reads up to eight bytes behind one that is a little too long.
void expect_frame(std::span<const std::byte> bytes) {
  constexpr std::size_t kHeaderBytes = 12, kChunkBytes = 8;
  constexpr int kDeepest = 64;
  const auto size = bytes.size();
  expect(size >= kHeaderBytes + 2 * kChunkBytes && number_at(bytes, 8) == size, "the length that the header states");
  const std::uint64_t json = number_at(bytes, kHeaderBytes), begin = kHeaderBytes + kChunkBytes;
  expect(json <= size - begin - kChunkBytes && json + number_at(bytes, begin + json) == size - begin - kChunkBytes,
         "two chunks, JSON and its buffer, that fill the file");
  expect(depth_of(bytes.subspan(begin, json)) <= kDeepest, "JSON that is not nested deeper than glTF ever is");
}

// Pictures are left where they are, for sheet_of.
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
    throw Wrong{"binary glTF: " + error.substr(0, error.find('\n'))};
  return tile_of(model);
}

}  // namespace

Result<BakedTile> decode_glb(std::span<const std::byte> bytes, const std::string& name) {
  try {
    expect(bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0,
           "a binary glTF file, which begins with glTF");
    expect_frame(bytes);
    const auto plain = decompressed_glb(bytes);
    return tile_of_plain(plain ? *plain : bytes);
  } catch (const Wrong& wrong) {
    return Error{name, "expected " + wrong.what};
  } catch (const std::exception& thrown) {
    return Error{name, std::string("expected binary glTF: ") + thrown.what()};
  }
}

Result<BakedTile> read_glb(const std::string& path) {
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  return decode_glb(*bytes, path);
}

}  // namespace citykiln::exporters
