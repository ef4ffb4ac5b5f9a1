// The frame of a PBF file: https://wiki.openstreetmap.org/wiki/PBF_Format (4 bytes of length, BlobHeader, Blob, and
// again).
#include "compiler/source/format/osm_format.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <protozero/pbf_reader.hpp>
#include <string_view>

#include "compiler/source/format/mended_xml.h"

namespace citykiln::source {
namespace {

namespace fs = std::filesystem;

struct Suffix {
  std::string_view text;
  OsmFormat format;
};
constexpr Suffix kSuffixes[] = {{".osm", OsmFormat::kXml},          {".xml", OsmFormat::kXml},
                                {".osm.gz", OsmFormat::kXmlGzip},   {".xml.gz", OsmFormat::kXmlGzip},
                                {".osm.bz2", OsmFormat::kXmlBzip2}, {".xml.bz2", OsmFormat::kXmlBzip2},
                                {".pbf", OsmFormat::kPbf}};

constexpr const char* kCutOff = "; the file is cut off: load it again";

// the longest BlobHeader that the format allows
constexpr std::uint32_t kMaxBlobHeader = 64 * 1024;

std::string_view content_name(OsmFormat format) {
  switch (format) {
    case OsmFormat::kXml:
      return "XML";
    case OsmFormat::kXmlGzip:
      return "gzip data";
    case OsmFormat::kXmlBzip2:
      return "bzip2 data";
    case OsmFormat::kPbf:
      return "OSM PBF data";
  }
  return "";
}

std::optional<OsmFormat> format_by_name(std::string_view path) {
  for (const Suffix& suffix : kSuffixes) {
    if (path.ends_with(suffix.text)) return suffix.format;
  }
  return std::nullopt;
}

// Empty if the first bytes match none of the four formats.
std::optional<OsmFormat> format_by_content(std::string_view head) {
  if (head.starts_with("\x1f\x8b")) return OsmFormat::kXmlGzip;
  if (head.starts_with("BZh")) return OsmFormat::kXmlBzip2;
  if (head.find("OSMHeader") != std::string_view::npos && head[0] == '\0') return OsmFormat::kPbf;
  if (utf8_of_utf16(head)) return OsmFormat::kXml;
  if (head.starts_with("\xef\xbb\xbf")) head.remove_prefix(3);
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && head[first] == '<') return OsmFormat::kXml;
  return std::nullopt;
}

// The size of the blob that follows a BlobHeader; empty if the bytes are not a BlobHeader.
std::optional<std::uint64_t> blob_size_in(std::string_view blob_header) {
  constexpr protozero::pbf_tag_type kDataSize = 3;
  try {
    protozero::pbf_reader reader(blob_header.data(), blob_header.size());
    while (reader.next()) {
      if (reader.tag() != kDataSize || !reader.has_wire_type(protozero::pbf_wire_type::varint)) {
        reader.skip();
      } else if (const std::int32_t size = reader.get_int32(); size > 0) {
        return static_cast<std::uint64_t>(size);
      }
    }
  } catch (const std::exception&) {
  }
  return std::nullopt;
}

// Returns an error for the first blob that extends past the end of the file.
std::optional<Error> find_broken_frame(const std::string& path, std::uint64_t file_size) {
  std::ifstream file(path, std::ios::binary);
  const auto error_at = [&](std::uint64_t byte, std::string message) {
    return Error{fmt::format("{}, byte {}", path, byte), std::move(message)};
  };
  std::string header;
  for (std::uint64_t at = 0; at < file_size;) {
    unsigned char length[4];
    if (!file.read(reinterpret_cast<char*>(length), 4)) {
      return error_at(at, "expected a PBF blob header, found the end of the file" + std::string(kCutOff));
    }
    const std::uint32_t header_size = std::uint32_t{length[0]} << 24 | length[1] << 16 | length[2] << 8 | length[3];
    if (header_size > kMaxBlobHeader) return error_at(at, "expected a PBF blob header, found other data");
    header.resize(header_size);
    if (!file.read(header.data(), header_size))
      return error_at(at, "the PBF blob header is cut short by the end of the file" + std::string(kCutOff));
    const std::optional<std::uint64_t> blob_size = blob_size_in(header);
    if (!blob_size) return error_at(at, "expected a PBF blob header, found other data");
    const std::uint64_t next = at + 4 + header_size + *blob_size;
    if (next > file_size) {
      return error_at(at, fmt::format("the PBF blob is cut short: it reaches to byte {}, the file ends at {}{}", next,
                                      file_size, kCutOff));
    }
    file.seekg(static_cast<std::streamoff>(next));
    at = next;
  }
  return std::nullopt;
}

std::string first_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(64, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

// True for the errors of expat at the end of a text, and those of zlib and libbz2 at the end of a file or in a broken
// one.
bool is_at_end(std::string_view message) {
  return message.ends_with("unclosed token") || message.ends_with("no element found") ||
         message.starts_with("gzip error") || message.starts_with("bzip2 error");
}

}  // namespace

std::string reading_error(const std::string& message) { return is_at_end(message) ? message + kCutOff : message; }

Error change_file_error(const std::string& path) {
  return {path,
          "holds changes of a map, not a map; apply them to the map that they were made for, such as with osmium "
          "apply-changes MAP.osm.pbf CHANGES.osc -o NEW.osm.pbf, and compile the new map"};
}

Result<OsmFormat> osm_format_of(const std::string& path) {
  std::error_code failure;
  if (!fs::exists(path, failure)) return Error{path, "no such file"};
  if (!fs::is_regular_file(path, failure)) return Error{path, "not a file"};
  for (const std::string_view suffix : {".osc", ".osc.gz", ".osc.bz2"})
    if (path.ends_with(suffix)) return change_file_error(path);
  const std::optional<OsmFormat> named = format_by_name(path);
  if (!named) return Error{path, "unknown suffix; expected .osm, .osm.gz, .osm.bz2 or .osm.pbf"};
  if (!std::ifstream(path)) return Error{path, std::strerror(errno)};
  const std::uint64_t size = fs::file_size(path, failure);
  if (failure) return Error{path, failure.message()};
  if (size == 0) return Error{path, "the file is empty"};

  const std::optional<OsmFormat> found = format_by_content(first_bytes(path));
  if (found != named) {
    return Error{path, fmt::format("expected {} as the file's name says, found {}", content_name(*named),
                                   found ? content_name(*found) : "something else")};
  }
  if (*named == OsmFormat::kPbf) {
    if (std::optional<Error> broken = find_broken_frame(path, size)) return *broken;
  }
  return *named;
}

}  // namespace citykiln::source
