// Divides a .glb into its JSON and its buffer, and joins them. Writers fill the JSON as a document, which becomes text
// in join_glb() only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace citykiln::exporters {

struct GlbParts {
  nlohmann::json gltf{};            ///< The document, without the length of the buffer.
  std::vector<std::byte> buffer{};  ///< The bytes of the only buffer in the file.
};

/// Returns a document with one buffer and one scene, whose root is node 0. The node is not in it yet.
nlohmann::json new_gltf();

/// Returns the 32-bit little-endian number at an offset. Four bytes must follow it.
std::uint32_t number_at(std::span<const std::byte> bytes, std::size_t at);

/// Returns the text of the JSON chunk.
/// @param bytes  A .glb that expect_chunks() has accepted.
std::string_view json_of_glb(std::span<const std::byte> bytes);

/// Divides a .glb that expect_chunks() has accepted. Throws nlohmann's exceptions if the JSON is invalid.
GlbParts split_glb(std::span<const std::byte> bytes);

/// Joins the parts and sets the buffer's length. Reuses the buffer's memory for the file.
std::vector<std::byte> join_glb(GlbParts parts);

/// Appends bytes to the buffer at a multiple of eight, and returns their offset.
std::size_t append(GlbParts& parts, std::span<const unsigned char> bytes);
/// Appends bytes as a new buffer view and returns its index.
std::size_t add_view(GlbParts& parts, std::span<const unsigned char> bytes);

/// Returns the bytes of a buffer view. Throws std::out_of_range if it is not inside the buffer.
std::span<const unsigned char> bytes_of_view(const GlbParts& parts, const nlohmann::json& view);

}  // namespace citykiln::exporters
