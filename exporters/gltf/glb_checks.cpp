#include "exporters/gltf/glb_checks.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "exporters/gltf/format_error.h"
#include "exporters/gltf/glb_parts.h"

namespace citykiln::exporters {
namespace {

// The depth of nested brackets.
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

// An unsigned number, which must be present unless there is a default, `otherwise`.
std::uint64_t json_number(const nlohmann::json& object, const char* name, std::optional<std::uint64_t> otherwise = {}) {
  if (otherwise && object.is_object() && !object.contains(name)) return *otherwise;
  expect(object.is_object() && object.contains(name) && object[name].is_number_unsigned(),
         "images inside the buffer, as citykiln writes them");
  return object[name].get<std::uint64_t>();
}

}  // namespace

void expect_pictures_inside(std::span<const std::byte> bytes) {
  const std::string_view json = json_of_glb(bytes);
  const auto keeps = [](int depth, nlohmann::json::parse_event_t event, const nlohmann::json& key) {
    return depth != 1 || event != nlohmann::json::parse_event_t::key || key == "images" || key == "bufferViews" ||
           key == "buffers";
  };
  const auto model = nlohmann::json::parse(json, keeps, false);
  if (!model.is_object()) return;
  const auto buffers = model.value("buffers", nlohmann::json::array()),
             views = model.value("bufferViews", nlohmann::json::array());
  expect(buffers.is_array() && std::ranges::none_of(buffers, [](const auto& b) { return b.contains("uri"); }),
         "a buffer inside the file");
  if (!model.contains("images")) return;
  expect(model["images"].is_array() && views.is_array() && buffers.size() == 1 && buffers[0].is_object(),
         "images inside the buffer, as citykiln writes them");
  for (const auto& image : model["images"]) {
    const std::uint64_t number = json_number(image, "bufferView");
    expect(number < views.size() && json_number(views[number], "buffer") == 0 &&
               json_number(views[number], "byteOffset", 0) < json_number(buffers[0], "byteLength"),
           "images inside the buffer, as citykiln writes them");
  }
}

void expect_chunks(std::span<const std::byte> bytes) {
  constexpr std::size_t kHeaderBytes = 12, kChunkBytes = 8;
  constexpr int kDeepest = 64;
  const auto size = bytes.size();
  expect(size >= kHeaderBytes + 2 * kChunkBytes && number_at(bytes, 8) == size, "the length that the header states");
  const std::uint64_t json = number_at(bytes, kHeaderBytes), begin = kHeaderBytes + kChunkBytes;
  expect(json <= size - begin - kChunkBytes && json + number_at(bytes, begin + json) == size - begin - kChunkBytes,
         "two chunks, JSON and its buffer, that fill the file");
  expect(depth_of(bytes.subspan(begin, json)) <= kDeepest, "JSON that is not nested deeper than glTF ever is");
}

}  // namespace citykiln::exporters
