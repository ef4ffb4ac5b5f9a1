// Coding of integers and bytes in crates (.usdc).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// Compresses bytes: one block of LZ4 behind a byte that says so. @param bytes  Fewer than 2^30.
std::vector<std::byte> compress_bytes(std::span<const std::byte> bytes);

/// Compresses numbers: the commonest difference of neighbours, a code of two bits for each difference (the commonest
/// one, 8, 16 or 32 bits), the other differences; then compress_bytes().
/// Source: OpenUSD, "USDC File Format Specification", integer compression. O(n log n).
std::vector<std::byte> compress_integers(std::span<const std::int32_t> numbers);

/// The inverses. Errors: bytes that do not give exactly as many; never a crash, whatever the bytes.
Result<std::vector<std::byte>> decompress_bytes(std::span<const std::byte> packed, std::size_t size);
Result<std::vector<std::int32_t>> decompress_integers(std::span<const std::byte> packed, std::size_t count);

}  // namespace citykiln::exporters
