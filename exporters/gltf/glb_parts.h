// A .glb divided into its JSON and its buffer. Writers fill the JSON as a document; join_glb() alone makes it text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace citykiln::exporters {

struct GlbParts {
  nlohmann::json gltf{};            ///< Without the buffer's length.
  std::vector<std::byte> buffer{};  ///< The bytes of its only buffer in the file.
};

/// The document of one buffer and one scene, whose root is node 0, without the node.
nlohmann::json new_gltf();

/// The 32 bit little-endian number at an offset, which must have four bytes.
std::uint32_t number_at(std::span<const std::byte> bytes, std::size_t at);

/// The text of the JSON chunk.
/// @param bytes  As expect_chunks() has accepted them, here and below.
std::string_view json_of_glb(std::span<const std::byte> bytes);

/// Divides a .glb. Throws nlohmann's exceptions where the JSON is invalid.
GlbParts split_glb(std::span<const std::byte> bytes);

/// Joins the parts and sets the buffer's length. Reuses the buffer's memory for the file.
std::vector<std::byte> join_glb(GlbParts parts);

/// Appends bytes to the buffer, at a multiple of eight, and returns their offset.
std::size_t append(GlbParts& parts, std::span<const unsigned char> bytes);
/// Appends bytes as a new buffer view and returns its index.
std::size_t add_view(GlbParts& parts, std::span<const unsigned char> bytes);

/// The bytes of a buffer view. Throws std::out_of_range where it is not in the buffer.
std::span<const unsigned char> bytes_of_view(const GlbParts& parts, const nlohmann::json& view);

}  // namespace citykiln::exporters
