#include "exporters/gltf/glb_parts.h"

#include <cassert>
#include <stdexcept>
#include <string>
#include <utility>

#include "compiler/contract/system/program_version.h"

namespace citykiln::exporters {
namespace {

constexpr std::size_t kHeaderBytes = 12, kChunkBytes = 8;

void append_number(std::vector<std::byte>& bytes, std::size_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes.push_back(static_cast<std::byte>(value >> 8 * i));
}

void append_bytes(std::vector<std::byte>& bytes, const void* from, std::size_t size) {
  const auto* first = static_cast<const std::byte*>(from);
  bytes.insert(bytes.end(), first, first + size);
}

}  // namespace

nlohmann::json new_gltf() {
  return {{"asset", {{"version", "2.0"}, {"generator", kProgramVersion}}},
          {"buffers", nlohmann::json::array({nlohmann::json::object()})},
          {"scene", 0},
          {"scenes", nlohmann::json::array({{{"nodes", {0}}}})}};
}

std::uint32_t number_at(std::span<const std::byte> bytes, std::size_t at) {
  assert(at + 4 <= bytes.size());
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<std::uint32_t>(bytes[at + i]);
  return value;
}

std::string_view json_of_glb(std::span<const std::byte> bytes) {
  const auto json = bytes.subspan(kHeaderBytes + kChunkBytes, number_at(bytes, kHeaderBytes));
  return {reinterpret_cast<const char*>(json.data()), json.size()};
}

GlbParts split_glb(std::span<const std::byte> bytes) {
  const std::string_view json = json_of_glb(bytes);
  const auto buffer = bytes.subspan(kHeaderBytes + 2 * kChunkBytes + json.size());
  return {nlohmann::json::parse(json), {buffer.begin(), buffer.end()}};
}

std::vector<std::byte> join_glb(GlbParts parts) {
  parts.gltf["buffers"][0]["byteLength"] = parts.buffer.size();
  std::string json = parts.gltf.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  parts.buffer.resize((parts.buffer.size() + 3) / 4 * 4);
  std::vector<std::byte> front;
  append_bytes(front, "glTF\2\0\0\0", 8);
  append_number(front, kHeaderBytes + 2 * kChunkBytes + json.size() + parts.buffer.size());
  append_number(front, json.size()), append_bytes(front, "JSON", 4), append_bytes(front, json.data(), json.size());
  append_number(front, parts.buffer.size()), append_bytes(front, "BIN\0", 4);
  parts.buffer.insert(parts.buffer.begin(), front.begin(), front.end());
  return std::move(parts.buffer);
}

std::size_t append(GlbParts& parts, std::span<const unsigned char> bytes) {
  parts.buffer.resize((parts.buffer.size() + 7) / 8 * 8);
  append_bytes(parts.buffer, bytes.data(), bytes.size());
  return parts.buffer.size() - bytes.size();
}

std::size_t add_view(GlbParts& parts, std::span<const unsigned char> bytes) {
  nlohmann::json& views = parts.gltf["bufferViews"];
  views.push_back({{"buffer", 0}, {"byteOffset", append(parts, bytes)}, {"byteLength", bytes.size()}});
  return views.size() - 1;
}

std::span<const unsigned char> bytes_of_view(const GlbParts& parts, const nlohmann::json& view) {
  const auto number = [&](const char* name, std::uint64_t otherwise) -> std::uint64_t {
    return view.contains(name) ? view.at(name).get<std::uint64_t>() : otherwise;
  };
  const std::uint64_t offset = number("byteOffset", 0), size = view.at("byteLength").get<std::uint64_t>();
  if (number("buffer", 0) != 0 || offset > parts.buffer.size() || size > parts.buffer.size() - offset)
    throw std::out_of_range("buffer views inside the buffer");
  return {reinterpret_cast<const unsigned char*>(parts.buffer.data()) + offset, size};
}

}  // namespace citykiln::exporters
