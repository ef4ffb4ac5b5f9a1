// A .glb taken apart: its JSON and its buffer.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace citykiln::exporters {

struct GlbParts {
  nlohmann::json gltf;
  std::vector<std::byte> buffer;
};

/// The JSON, as it is written. @param bytes  Two chunks that fill the file, here and below.
std::string_view json_of_glb(std::span<const std::byte> bytes);

/// Throws what nlohmann's json does where the first is none.
GlbParts split_glb(std::span<const std::byte> bytes);

/// With the buffer's length, which `gltf` need not have. The buffer becomes the file where it has room for the rest.
std::vector<std::byte> join_glb(GlbParts parts);

/// Appends bytes to the buffer, at a multiple of eight, and returns where.
std::size_t append(GlbParts& parts, std::span<const unsigned char> bytes);
/// The same as a new buffer view of `gltf`; its number.
std::size_t add_view(GlbParts& parts, std::span<const unsigned char> bytes);

/// Bytes of a view into the buffer. Throws std::out_of_range where there are none such.
std::span<const unsigned char> bytes_of_view(const GlbParts& parts, const nlohmann::json& view);

}  // namespace citykiln::exporters
