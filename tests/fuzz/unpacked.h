// Manifests and tiles without checksums, compression and lengths, so that a fuzzer's changes get past the first checks
// of the readers. The functions packed_… add them again; the readers themselves are unchanged.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "exporters/kiln/chunk_codec.h"
#include "exporters/kiln/streams.h"
#include "exporters/kiln/zstd_frame.h"
#include "exporters/manifest_generated.h"

namespace citykiln::exporters::fuzz {

using Bytes = std::vector<std::uint8_t>;
using ByteSpan = std::span<const std::uint8_t>;

inline void put(Bytes& bytes, std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}
inline std::uint64_t get(ByteSpan bytes, std::size_t at, int size) {
  std::uint64_t value = 0;
  for (int i = 0; i < size; ++i) value |= std::uint64_t{bytes[at + static_cast<std::size_t>(i)]} << 8 * i;
  return value;
}
/// Takes up to `size` bytes from the front.
inline ByteSpan take(ByteSpan& rest, std::uint64_t size) {
  const ByteSpan taken = rest.first(static_cast<std::size_t>(std::min<std::uint64_t>(size, rest.size())));
  rest = rest.subspan(taken.size());
  return taken;
}

/// The manifest's checksum (FNV-1a, 64 bits).
inline std::uint64_t checksum(ByteSpan bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const std::uint8_t b : bytes) hash = (hash ^ b) * 0x100000001b3u;
  return hash;
}

constexpr std::size_t kMostChunks = 8;

/// The header with its index replaced by one of these frames. Returns the input if it is no valid header with an index.
inline Bytes with_index(const Bytes& header, const std::vector<std::vector<std::byte>>& frames) {
  flatbuffers::Verifier verifier(header.data(), header.size());
  if (!verifier.VerifyBuffer<fbs::Header>(nullptr)) return header;
  fbs::HeaderT now;
  flatbuffers::GetRoot<fbs::Header>(header.data())->UnPackTo(&now);
  if (now.index == nullptr) return header;
  StreamWriter sizes;
  now.index->checksum.clear();
  for (const auto& frame : frames) {
    sizes.put(frame.size());
    now.index->checksum.push_back(checksum({reinterpret_cast<const std::uint8_t*>(frame.data()), frame.size()}));
  }
  now.index->size = sizes.bytes();
  flatbuffers::FlatBufferBuilder builder;
  builder.Finish(fbs::Header::Pack(builder, &now));
  return {builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize()};
}

/// The header's dictionary, loaded; empty if the header or the dictionary is invalid.
inline PackingDictionary dictionary_in(const Bytes& header) {
  flatbuffers::Verifier verifier(header.data(), header.size());
  if (!verifier.VerifyBuffer<fbs::Header>(nullptr)) return nullptr;
  const auto* dictionary = flatbuffers::GetRoot<fbs::Header>(header.data())->dictionary();
  if (dictionary == nullptr || unpacking_dictionary({dictionary->data(), dictionary->size()}) == nullptr)
    return nullptr;
  return packing_dictionary({dictionary->data(), dictionary->size()});
}

/// A .kiln file with correct checksums and sizes. The input holds a byte, whose lowest bit keeps the index unchanged;
/// the header's size in four bytes; the header's FlatBuffer; then for each of at most eight chunks its size in four
/// bytes and its uncompressed bytes.
inline Bytes packed_manifest(ByteSpan seed) {
  if (seed.size() < 5) return {seed.begin(), seed.end()};
  const bool keeps_index = (seed[0] & 1) != 0;
  ByteSpan rest = seed.subspan(5);
  const ByteSpan header_span = take(rest, get(seed, 1, 4));
  Bytes header(header_span.begin(), header_span.end());
  const PackingDictionary dictionary = dictionary_in(header);
  std::vector<std::vector<std::byte>> frames;
  while (rest.size() >= 4 && frames.size() < kMostChunks) {
    const std::uint64_t size = get(rest, 0, 4);
    take(rest, 4);
    frames.push_back(packed(take(rest, size), dictionary));
  }
  if (!keeps_index) header = with_index(header, frames);
  const std::vector<std::byte> frame = packed(header, nullptr);
  Bytes bytes{'C', 'I', 'T', 'Y', 'K', 'I', 'L', 'N'};
  put(bytes, 1, 2), put(bytes, 0, 2), put(bytes, frame.size(), 4);
  Bytes guarded = bytes;
  const auto append = [](Bytes& to, const std::vector<std::byte>& from) {
    for (const std::byte b : from) to.push_back(static_cast<std::uint8_t>(b));
  };
  append(guarded, frame);
  put(bytes, checksum(guarded), 8);
  append(bytes, frame);
  for (const auto& one : frames) append(bytes, one);
  return bytes;
}

/// Returns the beginning of a stream with its first numbers.
inline Bytes first_steps(const Bytes& stream, std::size_t count) {
  StreamReader reader(stream);
  for (std::size_t i = 0; i < count; ++i) reader.get();
  return {stream.begin(), stream.end() - static_cast<std::ptrdiff_t>(reader.remaining())};
}

/// The inverse of packed_manifest, for a valid manifest; keeps the first tiles of a large one.
inline Bytes unpacked_manifest(ByteSpan bytes) {
  const auto file = std::as_bytes(bytes);
  const std::uint64_t size = get(bytes, 12, 4);
  fbs::HeaderT header;
  flatbuffers::GetRoot<fbs::Header>(unpacked(file.subspan(24, size), nullptr, "")->data())->UnPackTo(&header);
  const UnpackingDictionary dictionary = unpacking_dictionary(header.dictionary);
  const std::size_t count = std::min(header.index->checksum.size(), kMostChunks);
  StreamReader sizes(header.index->size);
  Bytes chunks;
  for (std::size_t i = 0, at = 24 + size; i < count; ++i) {
    const std::size_t frame_size = sizes.get();
    const auto raw = unpacked(file.subspan(at, frame_size), dictionary, "");
    put(chunks, raw->size(), 4);
    chunks.insert(chunks.end(), raw->begin(), raw->end());
    at += frame_size;
  }
  header.index->x = first_steps(header.index->x, count), header.index->y = first_steps(header.index->y, count);
  header.index->size.clear(), header.index->checksum.clear();
  flatbuffers::FlatBufferBuilder builder;
  builder.Finish(fbs::Header::Pack(builder, &header));
  Bytes seed{0};
  put(seed, builder.GetSize(), 4);
  seed.insert(seed.end(), builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize());
  seed.insert(seed.end(), chunks.begin(), chunks.end());
  return seed;
}

/// The streams of a chunk: each has its size in two bytes and then its bytes; missing ones are empty.
inline Streams packed_streams(ByteSpan rest) {
  Streams streams;
  for (const char* name : stream_names()) {
    const std::uint64_t size = rest.size() < 2 ? 0 : get(rest, 0, 2);
    take(rest, 2);
    const ByteSpan stream = take(rest, size);
    streams[name].assign(stream.begin(), stream.end());
  }
  return streams;
}

inline Bytes unpacked_streams(Streams streams) {
  Bytes unpacked;
  for (const char* name : stream_names()) {
    const std::size_t size = std::min<std::size_t>(streams[name].size(), 65535);
    put(unpacked, size, 2);
    unpacked.insert(unpacked.end(), streams[name].begin(), streams[name].begin() + static_cast<std::ptrdiff_t>(size));
  }
  return unpacked;
}

/// A .glb file from the size of its JSON in four bytes, the JSON, and the buffer.
inline Bytes packed_glb(ByteSpan unpacked) {
  if (unpacked.size() < 4) return {unpacked.begin(), unpacked.end()};
  ByteSpan rest = unpacked.subspan(4);
  const ByteSpan json = take(rest, get(unpacked, 0, 4));
  const std::size_t json_size = (json.size() + 3) / 4 * 4,
                    buffer_size = std::max<std::size_t>((rest.size() + 3) / 4, 1) * 4;
  Bytes bytes{'g', 'l', 'T', 'F'};
  put(bytes, 2, 4), put(bytes, 28 + json_size + buffer_size, 4);
  put(bytes, json_size, 4), put(bytes, 0x4e4f534a, 4);
  bytes.insert(bytes.end(), json.begin(), json.end());
  bytes.resize(20 + json_size, ' ');
  put(bytes, buffer_size, 4), put(bytes, 0x004e4942, 4);
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  bytes.resize(28 + json_size + buffer_size, 0);
  return bytes;
}

/// The inverse of packed_glb, for a valid tile.
inline Bytes unpacked_glb(ByteSpan bytes) {
  const std::uint64_t size = get(bytes, 12, 4);
  Bytes unpacked;
  put(unpacked, size, 4);
  const ByteSpan json = bytes.subspan(20, size), buffer = bytes.subspan(28 + size);
  unpacked.insert(unpacked.end(), json.begin(), json.end());
  unpacked.insert(unpacked.end(), buffer.begin(), buffer.end());
  return unpacked;
}

/// The PNG file with correct checksums in all complete chunks.
inline Bytes packed_png(ByteSpan unpacked) {
  constexpr std::size_t kSignature = 8, kFrame = 12;
  Bytes bytes(unpacked.begin(), unpacked.end());
  for (std::size_t at = kSignature; at + kFrame <= bytes.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | bytes[at + i];
    if (length > bytes.size() - at - kFrame) break;
    std::uint32_t crc = 0xffffffffu;
    for (std::size_t i = at + 4; i < at + 8 + length; ++i) {
      crc ^= bytes[i];
      for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? 0xedb88320u ^ crc >> 1 : crc >> 1;
    }
    for (std::size_t i = 0; i < 4; ++i) bytes[at + 8 + length + i] = static_cast<std::uint8_t>(~crc >> 8 * (3 - i));
    at += kFrame + length;
  }
  return bytes;
}

}  // namespace citykiln::exporters::fuzz
