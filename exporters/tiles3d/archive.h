// A tileset as one file: the 3D Tiles Archive Format 1.3 (.3tz), a zip archive of stored files with an index that finds
// each by the hash of its name. Source: github.com/erikdahlstrom/3tz-specification.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "exporters/zip_writer.h"

namespace citykiln::exporters {

/// The place of a file in an archive.
struct ArchivePlace {
  std::array<std::byte, 16> md5{};  ///< The hash of the name.
  std::uint64_t offset = 0;         ///< The start of its local header, in bytes.
};

/// An archive in progress. The caller writes all bytes that the functions return, one after another.
struct TilesetArchive {
  ZipWriter zip{};
  std::vector<ArchivePlace> index{};
};

/// Adds a file. Returns the bytes before it; the caller writes them and then the file. Each name may be added once.
/// Deterministic. Error: a file of 4 GB or more; the archive must not be used after that.
///
/// @param name  The path relative to tileset.json, ASCII: "Q1_0_0.glb".
Result<std::vector<std::byte>> add_to_archive(TilesetArchive& archive, const std::string& name,
                                              std::span<const std::byte> bytes);

/// Returns the end of the archive: its index, as the last file, and the directory. A tileset.json must be among the
/// files. Error: an index of 4 GB or more.
Result<std::vector<std::byte>> end_of_archive(TilesetArchive archive);

/// Returns the index of places: 24 bytes each, the MD5 and then the offset, little-endian, ascending by the MD5 as two
/// little-endian numbers of 64 bits, the first more important.
std::vector<std::byte> archive_index(std::vector<ArchivePlace> places);

}  // namespace citykiln::exporters
