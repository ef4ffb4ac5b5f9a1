// Bytes as zstd frames (RFC 8878), on their own or with a dictionary that many small ones share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

// zstd's own digested dictionaries
struct ZSTD_CDict_s;
struct ZSTD_DDict_s;

namespace citykiln::exporters {

/// A dictionary in zstd's format, trained on `samples`: a 64th of their bytes, at most 32 kB. Empty where it would not
/// pay (fewer than 64 samples) or the trainer finds nothing in common. Same samples in the same order, same bytes.
/// Cost: grows with the bytes of at most 2 MB of samples, every n-th of all.
std::vector<std::uint8_t> train_dictionary(std::span<const std::vector<std::uint8_t>> samples);

/// A dictionary made ready once, then shared by all threads. Null for none, and for unpacking where the bytes are no
/// sound dictionary in zstd's format.
using PackingDictionary = std::shared_ptr<const ZSTD_CDict_s>;
using UnpackingDictionary = std::shared_ptr<const ZSTD_DDict_s>;
PackingDictionary packing_dictionary(std::span<const std::uint8_t> dictionary);
UnpackingDictionary unpacking_dictionary(std::span<const std::uint8_t> dictionary);

/// One frame that states its raw size, and no dictionary's number.
std::vector<std::byte> packed(std::span<const std::uint8_t> raw, const PackingDictionary& dictionary);

/// No frame of a city's tile comes near this; one that states more is not believed.
constexpr std::uint64_t kMostRawBytes = 1u << 28;

/// Errors, at `where`: no frame, one that does not state its size or too large a one, damage.
Result<std::vector<std::uint8_t>> unpacked(std::span<const std::byte> frame, const UnpackingDictionary& dictionary,
                                           const std::string& where);

}  // namespace citykiln::exporters
