#include "exporters/zip_writer.h"

#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <limits>

namespace citykiln::exporters {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t kLocalHeaderBytes = 30, kExtraHeaderBytes = 4;
constexpr std::uint32_t kLocalMagic = 0x04034b50, kEntryMagic = 0x02014b50, kEndMagic = 0x06054b50;
constexpr std::uint32_t kWideEndMagic = 0x06064b50, kWideLocatorMagic = 0x07064b50;
constexpr std::uint64_t kVersion = 10, kWideVersion = 45;
constexpr std::uint64_t kNoDate = 0x21;  // 1 January 1980
// An extra field of no meaning; only its length matters.
constexpr std::uint64_t kPaddingField = 0x1986;
// The extra field of ZIP64, and the values of 16 and 32 bits that say that the number is in a record of ZIP64.
constexpr std::uint64_t kWideField = 1, kWide16 = 0xffff, kWide32 = 0xffffffff;
constexpr std::uint64_t kWideEndBytes = 44;  // what follows the size itself

void put_field(Bytes& out, std::uint64_t number, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) out.push_back(static_cast<std::byte>(number >> 8 * i));
}

void put_field(Bytes& out, std::span<const std::byte> bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); }
void put_field(Bytes& out, std::string_view text) { put_field(out, std::as_bytes(std::span(text))); }

std::uint32_t crc32_of(std::span<const std::byte> bytes) {
  uLong crc = crc32(0, nullptr, 0);
  // zlib counts in 32 bits
  for (std::size_t at = 0; at < bytes.size(); at += 1 << 30) {
    const std::size_t size = std::min<std::size_t>(bytes.size() - at, 1 << 30);
    crc = crc32(crc, reinterpret_cast<const Bytef*>(bytes.data() + at), static_cast<uInt>(size));
  }
  return static_cast<std::uint32_t>(crc);
}

struct Description {
  std::string_view name;
  std::uint64_t bytes = 0;
  std::uint32_t crc = 0;
};

// Version, flags, method, date, checksum, sizes and length of the name: the same in both headers.
void put_description(Bytes& out, const Description& file, std::uint64_t version) {
  put_field(out, version, 2), put_field(out, 0, 2), put_field(out, 0, 2), put_field(out, kNoDate << 16, 4),
      put_field(out, file.crc, 4);
  put_field(out, file.bytes, 4), put_field(out, file.bytes, 4), put_field(out, file.name.size(), 2);
}

Bytes local_header(const ZipWriter& zip, const Description& file) {
  Bytes out;
  put_field(out, kLocalMagic, 4);
  put_description(out, file, kVersion);
  if (zip.alignment == 0) {
    put_field(out, 0, 2), put_field(out, file.name);
    return out;
  }
  const std::uint64_t without = zip.size + kLocalHeaderBytes + file.name.size() + kExtraHeaderBytes;
  const std::size_t padding = (zip.alignment - without % zip.alignment) % zip.alignment;
  put_field(out, kExtraHeaderBytes + padding, 2);
  put_field(out, file.name);
  put_field(out, kPaddingField, 2), put_field(out, padding, 2), out.resize(out.size() + padding);
  return out;
}

void put_entry(Bytes& out, const Description& file, std::uint64_t offset) {
  const bool is_wide = offset >= kWide32;
  put_field(out, kEntryMagic, 4), put_field(out, is_wide ? kWideVersion : kVersion, 2);
  put_description(out, file, is_wide ? kWideVersion : kVersion);
  put_field(out, is_wide ? kExtraHeaderBytes + sizeof offset : 0, 2);
  put_field(out, 0, 2), put_field(out, 0, 2), put_field(out, 0, 2), put_field(out, 0, 4);  // comment, disk, attributes
  put_field(out, std::min(offset, kWide32), 4);
  put_field(out, file.name);
  if (is_wide) put_field(out, kWideField, 2), put_field(out, sizeof offset, 2), put_field(out, offset, sizeof offset);
}

// The end of the directory in numbers of 64 bits, and where it is.
void put_wide_end(Bytes& out, const ZipWriter& zip) {
  const std::uint64_t at = zip.size + zip.entries.size();
  put_field(out, kWideEndMagic, 4), put_field(out, kWideEndBytes, 8), put_field(out, kWideVersion, 2),
      put_field(out, kWideVersion, 2);
  put_field(out, 0, 4), put_field(out, 0, 4);  // disks
  put_field(out, zip.files, 8), put_field(out, zip.files, 8), put_field(out, zip.entries.size(), 8),
      put_field(out, zip.size, 8);
  put_field(out, kWideLocatorMagic, 4), put_field(out, 0, 4), put_field(out, at, 8), put_field(out, 1, 4);
}

}  // namespace

Result<Bytes> add_zip_file(ZipWriter& zip, std::string_view name, std::span<const std::byte> bytes) {
  assert(name.size() <= std::numeric_limits<std::uint16_t>::max());
  if (bytes.size() >= kWide32) return Error{std::string(name), "a file of a zip archive has less than 4 GB"};
  const Description file{name, bytes.size(), crc32_of(bytes)};
  Bytes header = local_header(zip, file);
  put_entry(zip.entries, file, zip.size);
  zip.size += header.size() + bytes.size(), ++zip.files;
  return header;
}

Bytes zip_directory(const ZipWriter& zip) {
  const std::uint64_t entries = zip.entries.size();
  Bytes out = zip.entries;
  if (zip.files >= kWide16 || entries >= kWide32 || zip.size >= kWide32) put_wide_end(out, zip);
  const std::uint64_t files = std::min(zip.files, kWide16);
  put_field(out, kEndMagic, 4), put_field(out, 0, 2), put_field(out, 0, 2), put_field(out, files, 2),
      put_field(out, files, 2);
  put_field(out, std::min(entries, kWide32), 4), put_field(out, std::min(zip.size, kWide32), 4), put_field(out, 0, 2);
  return out;
}

}  // namespace citykiln::exporters
