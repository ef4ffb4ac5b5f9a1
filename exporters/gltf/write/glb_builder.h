// The .glb that a tile is written into, with functions that append to it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/glb.h"
#include "exporters/gltf/glb_axes.h"
#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/pictures/picture_formats.h"
#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {

/// The properties that distinguish the glTF materials of a tile.
struct MaterialKey {
  bake::PrimitiveKey primitive;                 ///< has_uvs is false if the uvs show no image.
  const materials::Texture* texture = nullptr;  ///< The material's texture, if the primitive shows it; else null.
  const impostor::Cutout* cutout = nullptr;     ///< The cutout, if the primitive shows one; else null.
  bool has_backs = false;                       ///< Both sides have their own faces (leaf_backs.h).
  materials::Tint tint = materials::kNoTint;    ///< Multiplies the base colour (plant_tints.h).
  bool operator==(const MaterialKey&) const = default;
};

/// The use of a buffer view, by glTF's numbers of targets.
enum class ViewUse : int { kOther = 0, kVertices = 34962, kIndices = 34963 };

/// The file, and the objects that primitives share. Members of JSON objects that have their default value are left out.
struct GlbBuilder {
  const bake::BakedTile& tile;
  const scene::Header& header;
  const GlbOptions& options;
  GlbParts file{};
  std::set<std::string> extensions{};
  std::vector<MaterialKey> material_keys{};        ///< One per glTF material.
  std::vector<const impostor::Cutout*> cutouts{};  ///< Distinct cutouts.
  std::set<std::uint32_t> instanced_features{};    ///< Features of the nodes of instances so far.

  /// Appends to a list of the file, such as "nodes", and returns the item's index.
  std::size_t add(const char* list, nlohmann::json item) {
    nlohmann::json& items = file.gltf[list];
    items.push_back(std::move(item));
    return items.size() - 1;
  }

  /// Appends converted values as a buffer view and returns its index. Aligned to 8 bytes, as property tables require.
  /// Converts 256 values at a time, to save memory.
  template <typename T, typename Convert = std::identity>
  std::size_t add_view(const std::vector<T>& values, ViewUse use, Convert convert = {}) {
    std::vector<std::byte>& buffer = file.buffer;
    buffer.resize((buffer.size() + 7) / 8 * 8);
    const std::size_t begin = buffer.size();
    std::array<std::decay_t<decltype(convert(values.front()))>, 256> some;
    for (std::size_t first = 0; first < values.size(); first += some.size()) {
      const auto from = std::span(values).subspan(first, std::min(some.size(), values.size() - first));
      std::ranges::transform(from, some.begin(), convert);
      const auto bytes = std::as_bytes(std::span(some).first(from.size()));
      buffer.insert(buffer.end(), bytes.begin(), bytes.end());
    }
    nlohmann::json view = {{"buffer", 0}, {"byteLength", buffer.size() - begin}};
    if (begin > 0) view["byteOffset"] = begin;
    if (use != ViewUse::kOther) view["target"] = static_cast<int>(use);
    return add("bufferViews", std::move(view));
  }

  /// True if uvs are in metres, which KHR_texture_transform scales; false if uvs are in units of the image's size.
  bool has_uvs_in_metres() const { return options.compression != Compression::kNone; }

  PictureFormats pictures() const {
    if (options.has_exact_pictures) return PictureFormats::kPng;
    return values_of(options.target).reads_webp ? PictureFormats::kWebp : PictureFormats::kPngAndJpeg;
  }

  /// Appends an accessor of a whole view and returns its index. Bytes are colours, in which 255 means 1.
  std::size_t add_accessor(std::size_t view, Component component, std::size_t width, std::size_t count) {
    constexpr const char* kTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    nlohmann::json accessor = {{"bufferView", view},
                               {"componentType", static_cast<int>(component)},
                               {"count", count},
                               {"type", kTypes[width - 1]}};
    if (component == Component::kUnsignedByte) accessor["normalized"] = true;
    return add("accessors", std::move(accessor));
  }

  /// Adds converted numbers, or arrays of them, as an attribute of vertices or of instances.
  template <typename T, typename Convert = std::identity>
  std::size_t add_attribute(const std::vector<T>& values, ViewUse use, Convert convert = {}) {
    using Type = ElementType<std::decay_t<decltype(convert(values.front()))>>;
    return add_accessor(add_view(values, use, convert), Type::kComponent, Type::kWidth, values.size());
  }

  /// Adds positions, directions or rotations in glTF's axes.
  template <typename T>
  std::size_t add_turned(const std::vector<T>& values, ViewUse use) {
    return add_attribute(values, use, [](const T& v) { return to_gltf(v); });
  }

  std::size_t add_as_floats(const std::vector<std::uint32_t>& numbers, ViewUse use) {
    return add_attribute(numbers, use, [](std::uint32_t n) { return static_cast<float>(n); });
  }
};

}  // namespace citykiln::exporters
