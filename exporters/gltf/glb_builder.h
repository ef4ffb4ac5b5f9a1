// A glTF model while it is filled.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/glb_axes.h"
#include "exporters/gltf/tinygltf_config.h"

namespace citykiln::exporters {

/// What a primitive shows, and how it says where.
struct MaterialKey {
  bake::PrimitiveKey key;                       ///< Without uvs where they show nothing.
  const materials::Texture* texture = nullptr;  ///< Of its material, if it shows one.
  bool has_quantised_uvs = false;
  const impostor::Cutout* cutout = nullptr;  ///< If it is on one.
  bool operator==(const MaterialKey&) const = default;
};

/// One tile on its way.
struct GlbBuilder {
  const bake::BakedTile& tile;
  const scene::Header& header;
  tinygltf::Model model;          ///< Without its buffer's bytes: tinygltf would copy them, and again.
  std::vector<std::byte> buffer;  ///< Those.
  std::set<std::string> extensions;
  std::vector<MaterialKey> looks;                ///< One a material.
  std::vector<const impostor::Cutout*> cutouts;  ///< No two alike.

  /// Appends what `turn` makes of values as one buffer view, aligned to 8 bytes (property tables ask for it). Some at a
  /// time: all of them are much.
  template <typename T, typename Turn>
  int add_view_of(const std::vector<T>& values, int target, Turn turn) {
    buffer.resize((buffer.size() + 7) / 8 * 8);
    tinygltf::BufferView view;
    view.buffer = 0, view.byteOffset = buffer.size(), view.target = target;
    std::array<decltype(turn(values.front())), 256> some;
    for (std::size_t first = 0; first < values.size(); first += some.size()) {
      const auto from = std::span(values).subspan(first, std::min(some.size(), values.size() - first));
      std::ranges::transform(from, some.begin(), turn);
      append(std::as_bytes(std::span(some).first(from.size())));
    }
    view.byteLength = buffer.size() - view.byteOffset;
    model.bufferViews.push_back(view);
    return static_cast<int>(model.bufferViews.size()) - 1;
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

  /// Places, directions and turns in glTF's frame.
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
