// Packs and unpacks zstd frames (RFC 8878), with or without a dictionary that many small frames share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

// zstd's digested dictionaries
struct ZSTD_CDict_s;
struct ZSTD_DDict_s;

namespace citykiln::exporters {

/// Trains a dictionary in zstd's format: a 64th of the samples' bytes, at most 32 kB. Empty for fewer than 64 samples,
/// or if the trainer finds nothing in common. Deterministic for samples in the same order. At most 2 MB are used, every
/// n-th sample.
std::vector<std::uint8_t> train_dictionary(std::span<const std::vector<std::uint8_t>> samples);

/// A dictionary ready for use, which threads may share. Null for an empty dictionary; for unpacking, also if the bytes
/// are not a valid dictionary in zstd's format.
using PackingDictionary = std::shared_ptr<const ZSTD_CDict_s>;
using UnpackingDictionary = std::shared_ptr<const ZSTD_DDict_s>;
PackingDictionary packing_dictionary(std::span<const std::uint8_t> dictionary);
UnpackingDictionary unpacking_dictionary(std::span<const std::uint8_t> dictionary);

/// Packs bytes as one frame that states its raw size and no dictionary id.
std::vector<std::byte> packed(std::span<const std::uint8_t> raw, const PackingDictionary& dictionary);

/// The largest unpacked size of a frame, in bytes; a tile of a city has far less.
constexpr std::uint64_t kMostRawBytes = 1u << 28;

/// Unpacks a frame. Errors, which name `where`: not a frame, a frame that states no size or more than kMostRawBytes,
/// damage.
Result<std::vector<std::uint8_t>> unpacked(std::span<const std::byte> frame, const UnpackingDictionary& dictionary,
                                           const std::string& where);

}  // namespace citykiln::exporters
