// The JSON of a written .glb file, and the errors for files that were changed.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "exporters/gltf/glb.h"
#include "tests/exporters/made_tile.h"

namespace citykiln::exporters {

using bake::BakedTile;
using Bytes = std::vector<std::byte>;

inline constexpr GlbOptions kExtension{.target = Target::kCesium, .split = NodeSplit::kTile},
    kNodes{.target = Target::kGeneric, .split = NodeSplit::kTile};
inline constexpr GlbOptions kAll[] = {kExtension,
                                      kNodes,
                                      {.target = Target::kCesium},
                                      {.target = Target::kGeneric},
                                      {.target = Target::kCesium, .split = NodeSplit::kBuilding},
                                      {.target = Target::kGeneric, .split = NodeSplit::kBuilding}};

inline scene::Header header() {
  scene::Header h;
  h.origin = {7.25, 43.5}, h.attributions = {"© OpenStreetMap contributors", "hills"};
  return h;
}

// The tile as .glb with exact pictures, so that it can be read back.
inline Bytes encoded(const BakedTile& tile, GlbOptions options) {
  options.has_exact_pictures = true;
  return encode_glb(tile, header(), options);
}

inline Result<BakedTile> decoded(const Bytes& bytes) { return decode_glb(bytes, "tile.glb"); }
inline std::string refusal(const Result<BakedTile>& result) { return result ? "accepted" : to_string(result.error()); }

inline void put_number(Bytes& bytes, std::size_t at, std::size_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::byte>(value >> 8 * i);
}

// The JSON chunk.
inline std::string json_of(const Bytes& bytes) {
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + 12, 4);
  return {reinterpret_cast<const char*>(bytes.data()) + 20, size};
}

// The file with another JSON chunk, padded, and lengths that fit.
inline Bytes with_json(const Bytes& bytes, std::string json) {
  const auto buffer = std::span(bytes).subspan(20 + json_of(bytes).size());
  json.resize((json.size() + 3) / 4 * 4, ' ');
  Bytes changed(20 + json.size() + buffer.size());
  std::copy_n(bytes.begin(), 20, changed.begin());
  std::memcpy(changed.data() + 20, json.data(), json.size());
  std::copy(buffer.begin(), buffer.end(), changed.end() - static_cast<std::ptrdiff_t>(buffer.size()));
  put_number(changed, 8, changed.size()), put_number(changed, 12, json.size());
  return changed;
}

// The error for a tile whose JSON has one text replaced by another.
inline std::string refusal_with(const GlbOptions& options, const std::string& text, const std::string& other,
                                const BakedTile& tile = made_tile(1)) {
  const Bytes bytes = encoded(tile, options);
  std::string json = json_of(bytes);
  const auto at = json.find(text);
  EXPECT_NE(at, std::string::npos) << text << " in " << json;
  if (at == std::string::npos) return "";
  return refusal(decoded(with_json(bytes, json.replace(at, text.size(), other))));
}

// The bytes of an accessor's buffer view as floats.
inline std::vector<float> floats_of(const Bytes& glb, const nlohmann::json& gltf, std::size_t accessor) {
  const auto& view = gltf["bufferViews"][gltf["accessors"][accessor]["bufferView"].get<std::size_t>()];
  const std::size_t start = 20 + json_of(glb).size() + 8 + view.value("byteOffset", std::size_t{0});
  std::vector<float> values(view["byteLength"].get<std::size_t>() / sizeof(float));
  std::memcpy(values.data(), glb.data() + start, values.size() * sizeof(float));
  return values;
}

// The names of all children of a node.
inline std::vector<std::string> names_below(const nlohmann::json& gltf, std::size_t node) {
  std::vector<std::string> names;
  for (const auto& child : gltf["nodes"][node].value("children", nlohmann::json::array()))
    names.push_back(gltf["nodes"][child.get<std::size_t>()]["name"]);
  return names;
}

inline nlohmann::json gltf_of(const BakedTile& tile, const GlbOptions& options = kExtension) {
  return nlohmann::json::parse(json_of(encoded(tile, options)));
}

inline nlohmann::json material_called(const nlohmann::json& gltf, const std::string& name) {
  for (const auto& material : gltf["materials"])
    if (material["name"] == name || material["name"].get<std::string>().starts_with(name + "_")) return material;
  ADD_FAILURE() << "no material " << name;
  return {};
}

// The attributes of the primitive of a material.
inline nlohmann::json attributes_of(const nlohmann::json& gltf, const std::string& name) {
  for (const auto& primitive : gltf["meshes"][0]["primitives"])
    if (gltf["materials"][primitive["material"].get<std::size_t>()]["name"] == name) return primitive["attributes"];
  ADD_FAILURE() << "no primitive of " << name;
  return {};
}

inline std::string images_of(const BakedTile& tile) { return gltf_of(tile)["images"].dump(); }

}  // namespace citykiln::exporters
