// Blobs of PBF files: https://wiki.openstreetmap.org/wiki/PBF_Format#File_format.
#include "compiler/source/format/mended_pbf.h"

#include <fmt/format.h>
#include <lz4.h>
#include <zlib.h>
#include <zstd.h>

#include <cstdint>
#include <exception>
#include <fstream>
#include <protozero/pbf_reader.hpp>
#include <protozero/pbf_writer.hpp>
#include <string_view>

namespace citykiln::source {
namespace {

constexpr std::size_t kMostUnpacked_bytes = std::size_t{32} << 20;

// The fields of a Blob.
constexpr protozero::pbf_tag_type kRaw = 1, kRawSize = 2, kZlib = 3, kLz4 = 6, kZstd = 7;
// The fields of a BlobHeader.
constexpr protozero::pbf_tag_type kBlobType = 1, kBlobSize = 3;

// Wire types that differ from these are skipped: protozero's functions assert the type.
constexpr auto kIsNumber = protozero::pbf_wire_type::varint;
constexpr auto kIsBytes = protozero::pbf_wire_type::length_delimited;

struct Frame {
  std::string type;
  std::size_t at = 0, size = 0;  // of the blob
};

// Reads the header of the next blob; nothing at the end of the file.
std::optional<Frame> next_frame(std::ifstream& file) {
  unsigned char length[4];
  if (!file.read(reinterpret_cast<char*>(length), 4)) return std::nullopt;
  std::string header(std::size_t{length[0]} << 24 | length[1] << 16 | length[2] << 8 | length[3], '\0');
  file.read(header.data(), static_cast<std::streamsize>(header.size()));
  Frame frame;
  protozero::pbf_reader reader(header);
  while (reader.next()) {
    if (reader.tag() == kBlobType && reader.has_wire_type(kIsBytes))
      frame.type = reader.get_string();
    else if (reader.tag() == kBlobSize && reader.has_wire_type(kIsNumber))
      frame.size = static_cast<std::size_t>(reader.get_int32());
    else
      reader.skip();
  }
  frame.at = static_cast<std::size_t>(file.tellg());
  return frame;
}

std::string blob_of(std::ifstream& file, const Frame& frame) {
  std::string blob(frame.size, '\0');
  file.seekg(static_cast<std::streamoff>(frame.at));
  file.read(blob.data(), static_cast<std::streamsize>(blob.size()));
  return blob;
}

// True for raw data, and for zlib data behind the size of its content, as nearly all programs write them.
bool begins_as_usual(std::ifstream& file, const Frame& frame) {
  const std::string head = blob_of(file, {frame.type, frame.at, std::min<std::size_t>(frame.size, 16)});
  constexpr char kRawField = kRaw << 3 | 2, kSizeField = kRawSize << 3, kZlibField = kZlib << 3 | 2;
  if (head.starts_with(kRawField)) return true;
  std::size_t at = 1;
  while (at < head.size() && (head[at] & 0x80) != 0) ++at;
  return head.starts_with(kSizeField) && at + 1 < head.size() && head[at + 1] == kZlibField;
}

// The content of a blob, and the size that it states, 0 if none.
struct Packed {
  protozero::pbf_tag_type packing = 0;
  std::string_view data;
  std::size_t size = 0;
};

Packed packed_in(const std::string& blob) {
  Packed packed;
  protozero::pbf_reader reader(blob);
  while (reader.next()) {
    if (reader.tag() == kRawSize && reader.has_wire_type(kIsNumber)) {
      packed.size = static_cast<std::size_t>(reader.get_int32());
    } else if (!reader.has_wire_type(kIsBytes)) {
      reader.skip();
    } else {
      packed.packing = reader.tag();
      const auto view = reader.get_view();
      packed.data = {view.data(), view.size()};
    }
  }
  return packed;
}

// True if libosmium reads the blob.
bool is_usual(const Packed& packed) { return packed.packing == kRaw || (packed.packing == kZlib && packed.size > 0); }

// Unpacks zlib data up to the size of `out`; returns the bytes written, or nothing for damaged data.
std::optional<std::size_t> inflated(std::string_view data, std::string& out) {
  uLongf size = out.size();
  const int done = uncompress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
                              static_cast<uLong>(data.size()));
  return done == Z_OK ? std::optional<std::size_t>(size) : std::nullopt;
}

std::optional<std::size_t> unpack_into(const Packed& packed, std::string& out) {
  if (packed.packing == kZlib) return inflated(packed.data, out);
  if (packed.packing == kLz4) {
    const int size = LZ4_decompress_safe(packed.data.data(), out.data(), static_cast<int>(packed.data.size()),
                                         static_cast<int>(out.size()));
    return size >= 0 ? std::optional<std::size_t>(size) : std::nullopt;
  }
  const std::size_t size = ZSTD_decompress(out.data(), out.size(), packed.data.data(), packed.data.size());
  return ZSTD_isError(size) == 0 ? std::optional(size) : std::nullopt;
}

Result<std::string> unpacked_blob(const std::string& path, const Frame& frame, const Packed& packed) {
  const Error damaged{fmt::format("{}, byte {}", path, frame.at), "expected a PBF blob, found damaged data in it"};
  if (packed.packing == kRaw) return std::string(packed.data);
  if (packed.packing != kZlib && packed.packing != kLz4 && packed.packing != kZstd)
    return Error{damaged.where, "the PBF blob is packed in a way that is not read; expected zlib, lz4, zstd or none"};
  if (packed.size > kMostUnpacked_bytes) return damaged;
  std::string out(packed.size > 0 ? packed.size : kMostUnpacked_bytes, '\0');
  const std::optional<std::size_t> size = unpack_into(packed, out);
  if (!size || (packed.size > 0 && *size != packed.size)) return damaged;
  out.resize(*size);
  return out;
}

void append_frame(const std::string& type, const std::string& content, std::string& file) {
  std::string blob, header;
  protozero::pbf_writer(blob).add_bytes(kRaw, content);
  protozero::pbf_writer writer(header);
  writer.add_string(kBlobType, type);
  writer.add_int32(kBlobSize, static_cast<std::int32_t>(blob.size()));
  for (const int shift : {24, 16, 8, 0}) file += static_cast<char>(header.size() >> shift & 0xff);
  file += header + blob;
}

Result<std::optional<std::string>> unpacked_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string all;
  while (const std::optional<Frame> frame = next_frame(file)) {
    const std::string blob = blob_of(file, *frame);
    const Result<std::string> content = unpacked_blob(path, *frame, packed_in(blob));
    if (!content) return content.error();
    append_frame(frame->type, *content, all);
  }
  return std::optional(std::move(all));
}

}  // namespace

Result<std::optional<std::string>> mended_pbf(const std::string& path) {
  try {
    std::ifstream file(path, std::ios::binary);
    while (const std::optional<Frame> frame = next_frame(file)) {
      if (!begins_as_usual(file, *frame) && !is_usual(packed_in(blob_of(file, *frame)))) return unpacked_file(path);
      file.clear();
      file.seekg(static_cast<std::streamoff>(frame->at + frame->size));
    }
    return std::optional<std::string>();
  } catch (const std::exception&) {
    // libosmium says what is wrong
    return std::optional<std::string>();
  }
}

}  // namespace citykiln::source
