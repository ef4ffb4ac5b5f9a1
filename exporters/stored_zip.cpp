#include "exporters/stored_zip.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace citykiln::exporters {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t kLocalHeaderBytes = 30, kExtraHeaderBytes = 4;
constexpr std::uint32_t kLocalMagic = 0x04034b50, kEntryMagic = 0x02014b50, kEndMagic = 0x06054b50;
constexpr std::uint64_t kVersion = 10, kNoDate = 0x21;  // 1 January 1980
// An extra field of no meaning; only its length matters.
constexpr std::uint64_t kPaddingField = 0x1986;

void put_field(Bytes& out, std::uint64_t number, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) out.push_back(static_cast<std::byte>(number >> 8 * i));
}

void put_field(Bytes& out, std::span<const std::byte> bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); }
void put_field(Bytes& out, const std::string& text) { put_field(out, std::as_bytes(std::span(text))); }

std::uint32_t crc32_of(const Bytes& bytes) {
  uLong crc = crc32(0, nullptr, 0);
  // zlib counts in 32 bits
  for (std::size_t at = 0; at < bytes.size(); at += 1 << 30) {
    const std::size_t size = std::min<std::size_t>(bytes.size() - at, 1 << 30);
    crc = crc32(crc, reinterpret_cast<const Bytef*>(bytes.data() + at), static_cast<uInt>(size));
  }
  return static_cast<std::uint32_t>(crc);
}

// Version, flags, method, date, checksum, sizes and length of the name: the same in both headers.
void put_description(Bytes& out, const ZippedFile& file, std::uint32_t crc) {
  put_field(out, kVersion, 2), put_field(out, 0, 2), put_field(out, 0, 2), put_field(out, kNoDate << 16, 4),
      put_field(out, crc, 4);
  put_field(out, file.bytes.size(), 4), put_field(out, file.bytes.size(), 4), put_field(out, file.name.size(), 2);
}

void put_file(Bytes& out, const ZippedFile& file, std::uint32_t crc, std::size_t alignment) {
  const std::size_t without = out.size() + kLocalHeaderBytes + file.name.size() + kExtraHeaderBytes;
  const std::size_t padding = (alignment - without % alignment) % alignment;
  put_field(out, kLocalMagic, 4);
  put_description(out, file, crc);
  put_field(out, kExtraHeaderBytes + padding, 2);
  put_field(out, file.name);
  put_field(out, kPaddingField, 2), put_field(out, padding, 2), out.resize(out.size() + padding);
  put_field(out, file.bytes);
}

void put_entry(Bytes& out, const ZippedFile& file, std::uint32_t crc, std::size_t offset) {
  put_field(out, kEntryMagic, 4), put_field(out, kVersion, 2);
  put_description(out, file, crc);
  put_field(out, 0, 2), put_field(out, 0, 2), put_field(out, 0, 2), put_field(out, 0, 2),
      put_field(out, 0, 4);  // extra, comment, disk, attributes
  put_field(out, offset, 4);
  put_field(out, file.name);
}

}  // namespace

Result<Bytes> stored_zip(std::span<const ZippedFile> files, std::size_t alignment) {
  Bytes out, entries;
  for (const ZippedFile& file : files) {
    const std::uint32_t crc = crc32_of(file.bytes);
    put_entry(entries, file, crc, out.size());
    put_file(out, file, crc, alignment);
  }
  const std::size_t start = out.size();
  put_field(out, entries);
  put_field(out, kEndMagic, 4), put_field(out, 0, 2), put_field(out, 0, 2), put_field(out, files.size(), 2),
      put_field(out, files.size(), 2);
  put_field(out, entries.size(), 4), put_field(out, start, 4), put_field(out, 0, 2);
  if (out.size() > std::numeric_limits<std::uint32_t>::max() ||
      files.size() > std::numeric_limits<std::uint16_t>::max())
    return Error{"", "a zip archive has at most 4 GB"};
  return out;
}

}  // namespace citykiln::exporters
