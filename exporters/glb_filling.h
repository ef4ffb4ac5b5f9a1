// A glTF model while it is filled.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "compiler/bake/baked.h"
#include "exporters/tinygltf_switches.h"

namespace citykiln::exporters {

/// What a primitive shows, and how it says where.
struct Look {
  bake::PrimitiveKey key;                       ///< Without uvs where they show nothing.
  const materials::Texture* texture = nullptr;  ///< Of its material, if it shows one.
  bool is_in_steps = false;
  const imprint::Cutout* cutout = nullptr;  ///< If it is on one.
  bool operator==(const Look&) const = default;
};

/// One tile on its way.
struct Filling {
  const bake::BakedTile& tile;
  const scene::Header& header;
  tinygltf::Model model;              ///< Without its buffer's bytes: tinygltf would copy them, and again.
  std::vector<unsigned char> buffer;  ///< Those.
  std::set<std::string> extensions;
  std::vector<Look> looks;                      ///< One a material.
  std::vector<const imprint::Cutout*> cutouts;  ///< No two alike.

  /// Appends values as one buffer view, aligned to 8 bytes (property tables ask for it).
  template <typename T>
  int add_view(const std::vector<T>& values, int target) {
    buffer.resize((buffer.size() + 7) / 8 * 8, 0);
    const auto bytes = std::as_bytes(std::span(values));
    tinygltf::BufferView view;
    view.buffer = 0, view.byteOffset = buffer.size(), view.byteLength = bytes.size(), view.target = target;
    const auto* first = reinterpret_cast<const unsigned char*>(bytes.data());
    buffer.insert(buffer.end(), first, first + bytes.size());
    model.bufferViews.push_back(view);
    return static_cast<int>(model.bufferViews.size()) - 1;
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
};

}  // namespace citykiln::exporters
