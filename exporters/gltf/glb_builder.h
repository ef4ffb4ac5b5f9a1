// The glTF model that a tile is written into, with functions that append to it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/glb.h"
#include "exporters/gltf/glb_axes.h"
#include "exporters/gltf/picture_formats.h"
#include "exporters/gltf/tinygltf_config.h"

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

/// The model, and the objects that primitives share.
struct GlbBuilder {
  const bake::BakedTile& tile;
  const scene::Header& header;
  const GlbOptions& options;
  tinygltf::Model model{};  ///< The model without the bytes of its buffer, which tinygltf would copy several times.
  std::vector<std::byte> buffer{};  ///< The bytes of the model's only buffer.
  std::set<std::string> extensions{};
  std::vector<MaterialKey> material_keys{};        ///< One per glTF material.
  std::vector<const impostor::Cutout*> cutouts{};  ///< Distinct cutouts.

  /// Appends converted values as a buffer view and returns its index. Aligned to 8 bytes, as property tables require.
  /// Converts 256 values at a time, to save memory.
  template <typename T, typename Convert>
  int add_view_of(const std::vector<T>& values, int target, Convert convert) {
    buffer.resize((buffer.size() + 7) / 8 * 8);
    tinygltf::BufferView view;
    view.buffer = 0, view.byteOffset = buffer.size(), view.target = target;
    std::array<decltype(convert(values.front())), 256> some;
    for (std::size_t first = 0; first < values.size(); first += some.size()) {
      const auto from = std::span(values).subspan(first, std::min(some.size(), values.size() - first));
      std::ranges::transform(from, some.begin(), convert);
      append(std::as_bytes(std::span(some).first(from.size())));
    }
    view.byteLength = buffer.size() - view.byteOffset;
    model.bufferViews.push_back(view);
    return static_cast<int>(model.bufferViews.size()) - 1;
  }

  /// True if uvs are in metres, which KHR_texture_transform scales; false if uvs are in units of the image's size.
  bool has_uvs_in_metres() const { return options.compression != Compression::kNone; }

  PictureFormats pictures() const {
    if (options.has_exact_pictures) return PictureFormats::kPng;
    return values_of(options.target).reads_webp ? PictureFormats::kWebp : PictureFormats::kPngAndJpeg;
  }

  void append(std::span<const std::byte> bytes) { buffer.insert(buffer.end(), bytes.begin(), bytes.end()); }

  template <typename T>
  int add_view(const std::vector<T>& values, int target) {
    return add_view_of(values, target, [](const T& v) { return v; });
  }

  int add_accessor(int view, int component, int type, std::size_t count, bool normalised = false) {
    tinygltf::Accessor accessor;
    accessor.bufferView = view, accessor.componentType = component, accessor.type = type, accessor.count = count,
    accessor.normalized = normalised;
    model.accessors.push_back(accessor);
    return static_cast<int>(model.accessors.size()) - 1;
  }

  template <typename T>
  int add_attribute(const std::vector<T>& values, int component, int type, int target = TINYGLTF_TARGET_ARRAY_BUFFER,
                    bool normalised = false) {
    return add_accessor(add_view(values, target), component, type, values.size(), normalised);
  }

  /// Adds positions, directions or rotations in glTF's axes.
  template <typename T>
  int add_turned(const std::vector<T>& values, int type, int target = TINYGLTF_TARGET_ARRAY_BUFFER) {
    const int view = add_view_of(values, target, [](const T& v) { return to_gltf(v); });
    return add_accessor(view, TINYGLTF_COMPONENT_TYPE_FLOAT, type, values.size());
  }

  int add_as_floats(const std::vector<std::uint32_t>& numbers, int target = TINYGLTF_TARGET_ARRAY_BUFFER) {
    const int view = add_view_of(numbers, target, [](std::uint32_t n) { return static_cast<float>(n); });
    return add_accessor(view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_SCALAR, numbers.size());
  }
};

}  // namespace citykiln::exporters
