#include "exporters/gltf/read/glb_reader.h"

namespace citykiln::exporters {

using tinygltf::Value;

std::span<const unsigned char> bytes_of(GltfReader& reader, int view_number) {
  const tinygltf::BufferView& view = item(reader.model.bufferViews, view_number, "a buffer view that exists");
  const auto& data = item(reader.model.buffers, view.buffer, "a buffer that exists").data;
  expect(view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset,
         "buffer views inside the buffer");
  expect(view.byteLength <= reader.unread_bytes, "each byte of the buffer to be used once");
  reader.unread_bytes -= view.byteLength;
  return std::span(data).subspan(view.byteOffset, view.byteLength);
}

std::vector<std::uint32_t> as_numbers(const std::vector<float>& values, std::size_t below) {
  std::vector<std::uint32_t> numbers;
  for (const float v : values) {
    expect(v >= 0 && v < static_cast<float>(below), "feature ids inside the property table");
    numbers.push_back(static_cast<std::uint32_t>(v));
  }
  return numbers;
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

}  // namespace citykiln::exporters
