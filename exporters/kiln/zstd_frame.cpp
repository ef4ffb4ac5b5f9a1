#include "exporters/kiln/zstd_frame.h"

#include <fmt/format.h>
#include <zdict.h>
#include <zstd.h>

#include <algorithm>

namespace citykiln::exporters {
namespace {

// Beyond 17 zstd takes twice the time for a few bytes in a hundred.
constexpr int kLevel = 17;
// Of real cities, a 64th of the raw bytes gains more than it costs from a dozen tiles on; beyond 32 kB the gain is a
// few bytes in a thousand, and whoever reads one tile reads the dictionary too.
constexpr std::size_t kFewestSamples = 64, kBytesADictionaryByte = 64, kMostDictionaryBytes = 32768;
// Training on all of a large city would take half as long as compiling it, and gain three bytes in a thousand.
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
  // zstd takes any bytes without its magic number for a dictionary of mere content
  if (ZSTD_getDictID_fromDict(dictionary.data(), dictionary.size()) == 0) return nullptr;
  return {ZSTD_createDDict(dictionary.data(), dictionary.size()), ZSTD_freeDDict};
}

std::vector<std::byte> packed(std::span<const std::uint8_t> raw, const PackingDictionary& dictionary) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kLevel);
  // four bytes a frame that say what the file says once
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
