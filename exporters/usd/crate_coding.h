// Compresses integers and bytes as in crates (.usdc), and decompresses them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// Compresses bytes: writes a byte 0 (one chunk), then a block of LZ4.
/// @param bytes  Fewer than 2^30.
std::vector<std::byte> compress_bytes(std::span<const std::byte> bytes);

/// Compresses numbers. Writes the commonest difference of neighbours, a code of two bits for each difference (the
/// commonest one, 8, 16 or 32 bits) and the other differences, and packs them by compress_bytes(). Source: OpenUSD,
/// "USDC File Format Specification", integer compression. O(n log n).
std::vector<std::byte> compress_integers(std::span<const std::int32_t> numbers);

/// Decompresses the result of compress_bytes().
///
/// @param size  The number of bytes of the result.
///
/// Errors: bytes that do not unpack to exactly this size. No bytes make the function crash.
Result<std::vector<std::byte>> decompress_bytes(std::span<const std::byte> packed, std::size_t size);
/// Decompresses the result of compress_integers().
///
/// @param count  The number of numbers of the result.
///
/// Errors: bytes that do not unpack to exactly this count. No bytes make the function crash.
Result<std::vector<std::int32_t>> decompress_integers(std::span<const std::byte> packed, std::size_t count);

}  // namespace citykiln::exporters
