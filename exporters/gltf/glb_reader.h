// A glTF model while it is read, with doubt: whatever is not as citykiln writes it is told.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "exporters/gltf/glb_axes.h"
#include "exporters/gltf/tinygltf_config.h"

namespace citykiln::exporters {

/// What is wrong with a file: thrown by what reads one, and turned into an Error at its door, decode_glb().
struct FormatError {
  std::string what;
};

/// @param what  "expected …"
inline void expect(bool holds, const char* what) {
  if (!holds) throw FormatError{what};
}

template <typename T>
const T& item(const std::vector<T>& items, int index, const char* what) {
  expect(index >= 0 && static_cast<std::size_t>(index) < items.size(), what);
  return items[static_cast<std::size_t>(index)];
}

/// Each byte of the buffer is read once, so that no small file makes a large tile.
struct GltfReader {
  const tinygltf::Model& model;
  std::size_t unread_bytes;
};

/// The bytes of a buffer view, inside its buffer.
std::span<const unsigned char> bytes_of(GltfReader& source, int view_number);

template <typename T>
std::vector<T> values_of(GltfReader& source, int accessor_number, int component, int type) {
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

/// In our own frame.
template <typename T>
std::vector<T> turned(std::vector<T> values) {
  values = finite(std::move(values));
  for (T& v : values) v = from_gltf(v);
  return values;
}

/// Feature ids, which are written as floats.
std::vector<std::uint32_t> as_numbers(const std::vector<float>& values, std::size_t below);

// Of extras and extensions.
const tinygltf::Value& member(const tinygltf::Value& value, const char* name);
double number(const tinygltf::Value& value);
int whole(const tinygltf::Value& value);
double element(const tinygltf::Value& array, std::size_t i);

}  // namespace citykiln::exporters
