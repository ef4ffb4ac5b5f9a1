#include "exporters/kiln/zstd_frame.h"

#include <fmt/format.h>
#include <zdict.h>
#include <zstd.h>

#include <algorithm>
#include <cassert>

namespace citykiln::exporters {
namespace {

// Higher levels take twice the time and gain a few percent.
constexpr int kLevel = 17;
// Measured on cities: a dictionary of a 64th of the raw bytes pays from a dozen tiles on; more than 32 kB gain a few
// tenths of a percent, and a reader of one tile has to read the dictionary too.
constexpr std::size_t kFewestSamples = 64, kBytesADictionaryByte = 64, kMostDictionaryBytes = 32768;
// Training on all of a large city would take half as long as compiling it, and gain 0.3 %.
constexpr std::size_t kMostSampleBytes = 2000000;

struct Samples {
  std::vector<std::uint8_t> bytes;
  std::vector<std::size_t> sizes;
};

Samples every_nth(std::span<const std::vector<std::uint8_t>> all, std::size_t n) {
  Samples samples;
  for (std::size_t i = 0; i < all.size(); i += n) {
    samples.bytes.insert(samples.bytes.end(), all[i].begin(), all[i].end());
    samples.sizes.push_back(all[i].size());
  }
  return samples;
}

}  // namespace

std::vector<std::uint8_t> train_dictionary(std::span<const std::vector<std::uint8_t>> samples) {
  if (samples.size() < kFewestSamples) return {};
  std::size_t total = 0;
  for (const auto& sample : samples) total += sample.size();
  const Samples chosen = every_nth(samples, total / kMostSampleBytes + 1);
  std::vector<std::uint8_t> dictionary(std::min(total / kBytesADictionaryByte, kMostDictionaryBytes));
  const std::size_t size = ZDICT_trainFromBuffer(dictionary.data(), dictionary.size(), chosen.bytes.data(),
                                                 chosen.sizes.data(), static_cast<unsigned>(chosen.sizes.size()));
  dictionary.resize(ZDICT_isError(size) != 0 ? 0 : size);
  return dictionary;
}

PackingDictionary packing_dictionary(std::span<const std::uint8_t> dictionary) {
  if (dictionary.empty()) return nullptr;
  return {ZSTD_createCDict(dictionary.data(), dictionary.size(), kLevel), ZSTD_freeCDict};
}

UnpackingDictionary unpacking_dictionary(std::span<const std::uint8_t> dictionary) {
  // zstd accepts any bytes without its magic number as a raw-content dictionary
  if (ZSTD_getDictID_fromDict(dictionary.data(), dictionary.size()) == 0) return nullptr;
  return {ZSTD_createDDict(dictionary.data(), dictionary.size()), ZSTD_freeDDict};
}

std::vector<std::byte> packed(std::span<const std::uint8_t> raw, const PackingDictionary& dictionary) {
  assert(raw.size() <= kMostRawBytes);
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kLevel);
  // the header holds the dictionary, so frames need not name it: saves four bytes per frame
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_dictIDFlag, 0);
  ZSTD_CCtx_refCDict(context.get(), dictionary.get());
  std::vector<std::byte> frame(ZSTD_compressBound(raw.size()));
  frame.resize(ZSTD_compress2(context.get(), frame.data(), frame.size(), raw.data(), raw.size()));
  return frame;
}

Result<std::vector<std::uint8_t>> unpacked(std::span<const std::byte> frame, const UnpackingDictionary& dictionary,
                                           const std::string& where) {
  const std::uint64_t size = ZSTD_getFrameContentSize(frame.data(), frame.size());
  if (size == ZSTD_CONTENTSIZE_UNKNOWN || size == ZSTD_CONTENTSIZE_ERROR)
    return Error{where, "expected a zstd frame that states its size"};
  if (size > kMostRawBytes)
    return Error{where, fmt::format("expected at most {} bytes unpacked, found {}", kMostRawBytes, size)};
  const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
  std::vector<std::uint8_t> raw(size);
  const std::size_t got =
      ZSTD_decompress_usingDDict(context.get(), raw.data(), raw.size(), frame.data(), frame.size(), dictionary.get());
  if (got != size) return Error{where, "expected a zstd frame, found damage in it"};
  return raw;
}

}  // namespace citykiln::exporters
