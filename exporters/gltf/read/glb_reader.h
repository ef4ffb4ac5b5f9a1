// Checked access to a glTF model. Every function throws FormatError for anything that citykiln does not write.
// decode_glb() catches it and returns a Result: no exception leaves the folder.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "exporters/gltf/format_error.h"
#include "exporters/gltf/glb_axes.h"
#include "exporters/gltf/read/tinygltf_config.h"
#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {

template <typename T>
const T& item(const std::vector<T>& items, int index, const char* what) {
  expect(index >= 0 && static_cast<std::size_t>(index) < items.size(), what);
  return items[static_cast<std::size_t>(index)];
}

/// A model while it is read. Each byte of the buffer may be read once, so a small file cannot make a large tile.
struct GltfReader {
  const tinygltf::Model& model;
  std::size_t unread_bytes;
};

/// Returns the bytes of a buffer view, which must lie in its buffer.
std::span<const unsigned char> bytes_of(GltfReader& reader, int view_number);

/// Returns the elements of an accessor, which must have the component type and the number of components of T.
template <typename T>
std::vector<T> values_of(GltfReader& reader, int accessor_number) {
  const tinygltf::Accessor& accessor = item(reader.model.accessors, accessor_number, "an accessor that exists");
  constexpr int kType = ElementType<T>::kWidth == 1 ? TINYGLTF_TYPE_SCALAR : int{ElementType<T>::kWidth};
  expect(accessor.componentType == static_cast<int>(ElementType<T>::kComponent) && accessor.type == kType &&
             accessor.byteOffset == 0,
         "accessors as citykiln writes them");
  const auto bytes = bytes_of(reader, accessor.bufferView);
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

/// Returns values in the plane's axes, and checks that they are finite.
template <typename T>
std::vector<T> turned(std::vector<T> values) {
  values = finite(std::move(values));
  for (T& v : values) v = from_gltf(v);
  return values;
}

/// Returns feature ids, which are written as floats, and checks that they are in [0, below).
std::vector<std::uint32_t> as_numbers(const std::vector<float>& values, std::size_t below);

// values of extras and extensions
const tinygltf::Value& member(const tinygltf::Value& value, const char* name);
double number(const tinygltf::Value& value);
int whole(const tinygltf::Value& value);
double element(const tinygltf::Value& array, std::size_t i);

}  // namespace citykiln::exporters
