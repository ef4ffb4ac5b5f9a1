// Reads fields of binary formats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace citykiln::exporters {

/// Returns a little-endian number of at most 8 bytes.
inline std::uint64_t number_at(std::span<const std::byte> bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value |= static_cast<std::uint64_t>(bytes[at + i]) << 8 * i;
  return value;
}

inline std::string text_at(std::span<const std::byte> bytes, std::size_t at, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes.data()) + at, size};
}

}  // namespace citykiln::exporters
