// Manifests and tiles in forms that a fuzzer can change: without checksums, compression and lengths, which would stop
// it at the door. `packed` puts them back, so that the readers are entered as always.
#pragma once

#include <zstd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "exporters/chunk_codec.h"
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

/// As in the manifest.
inline std::uint64_t checksum(ByteSpan bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const std::uint8_t b : bytes) hash = (hash ^ b) * 0x100000001b3u;
  return hash;
}

/// A .kiln whose bytes are right where they guard others. An unpacked manifest is: a byte, whose lowest bit asks that
/// the index is left as it is; four bytes, the header's size; the header; then each chunk's four bytes of size, and its
/// FlatBuffer as it is before zstd.
inline Bytes packed_manifest(ByteSpan unpacked) {
  if (unpacked.size() < 5) return {unpacked.begin(), unpacked.end()};
  const bool keeps_index = (unpacked[0] & 1) != 0;
  ByteSpan rest = unpacked.subspan(5);
  const ByteSpan header_span = take(rest, get(unpacked, 1, 4));
  Bytes header(header_span.begin(), header_span.end()), body;
  static ZSTD_CCtx* const context = ZSTD_createCCtx();
  flatbuffers::Verifier verifier(header.data(), header.size());
  const bool has_index = verifier.VerifyBuffer<fbs::Header>(nullptr);
  const auto* entries = has_index ? flatbuffers::GetRoot<fbs::Header>(header.data())->chunks() : nullptr;
  for (std::uint32_t i = 0; entries != nullptr && i < std::min(entries->size(), 8u); ++i) {
    const std::uint64_t size = rest.size() < 4 ? 0 : get(rest, 0, 4);
    take(rest, 4);
    const ByteSpan raw = take(rest, size);
    Bytes frame(ZSTD_compressBound(raw.size()));
    frame.resize(ZSTD_compressCCtx(context, frame.data(), frame.size(), raw.data(), raw.size(), 1));
    // fields may lie on each other in a changed header, so each is written only while all is sound
    const auto mend = [&](flatbuffers::voffset_t field, std::uint64_t value) {
      flatbuffers::Verifier still(header.data(), header.size());
      if (keeps_index || !still.VerifyBuffer<fbs::Header>(nullptr)) return;
      const auto* now = flatbuffers::GetRoot<fbs::Header>(header.data())->chunks();
      if (now == nullptr || i >= now->size()) return;
      const auto* entry = reinterpret_cast<const flatbuffers::Table*>(now->Get(i));
      const_cast<flatbuffers::Table*>(entry)->SetField<std::uint64_t>(field, value, 0);
    };
    using Entry = fbs::ChunkEntry;
    mend(Entry::VT_OFFSET, body.size()), mend(Entry::VT_SIZE, frame.size());
    mend(Entry::VT_RAW_SIZE, raw.size()), mend(Entry::VT_CHECKSUM, checksum(frame));
    body.insert(body.end(), frame.begin(), frame.end());
  }
  Bytes bytes{'C', 'I', 'T', 'Y', 'K', 'I', 'L', 'N'};
  put(bytes, header.size(), 8), put(bytes, checksum(header), 8);
  bytes.insert(bytes.end(), header.begin(), header.end());
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

/// Of a sound manifest.
inline Bytes unpacked_manifest(ByteSpan bytes) {
  const std::uint64_t size = get(bytes, 8, 8);
  const ByteSpan header = bytes.subspan(24, size), body = bytes.subspan(24 + size);
  Bytes unpacked{0};
  put(unpacked, size, 4);
  unpacked.insert(unpacked.end(), header.begin(), header.end());
  const Bytes aligned(header.begin(), header.end());
  for (const auto* entry : *flatbuffers::GetRoot<fbs::Header>(aligned.data())->chunks()) {
    Bytes raw(entry->raw_size());
    ZSTD_decompress(raw.data(), raw.size(), body.data() + entry->offset(), entry->size());
    put(unpacked, raw.size(), 4);
    unpacked.insert(unpacked.end(), raw.begin(), raw.end());
  }
  return unpacked;
}

/// Streams of a chunk: each two bytes of size, and its bytes; those that are not there are empty.
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

/// A .glb: four bytes, the size of its JSON; the JSON; the buffer.
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

/// Of a sound tile.
inline Bytes unpacked_glb(ByteSpan bytes) {
  const std::uint64_t size = get(bytes, 12, 4);
  Bytes unpacked;
  put(unpacked, size, 4);
  const ByteSpan json = bytes.subspan(20, size), buffer = bytes.subspan(28 + size);
  unpacked.insert(unpacked.end(), json.begin(), json.end());
  unpacked.insert(unpacked.end(), buffer.begin(), buffer.end());
  return unpacked;
}

/// A PNG whose checksums are right, as far as its chunks are whole. Unpacked is: the file.
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
