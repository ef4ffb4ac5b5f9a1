// Gives the bytes of a zip archive around its files, one file after another, so that an archive of any size is never
// in memory. Files are stored without compression. Source: PKWARE, APPNOTE.TXT 6.3.
//
//     local header, file, local header, file, …, directory
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// An archive in progress.
struct ZipWriter {
  /// The data of each file begin at a multiple of so many bytes, by an extra field in its header; 0: anywhere, without
  /// such a field.
  std::size_t alignment = 0;
  std::uint64_t size = 0;            ///< The bytes of all headers and files until now: the next header's offset.
  std::uint64_t files = 0;           ///< The number of files until now.
  std::vector<std::byte> entries{};  ///< The directory's entries of these files.
};

/// Adds a file. Returns its local header; the caller writes the header and then the file. Dates are constant.
/// Deterministic. Error: a file of 4 GB or more. Cost: a checksum of the bytes, about 1 GB/s.
///
/// @param name  With folders: "textures/AsphaltColour.jpg". At most 65,535 bytes.
Result<std::vector<std::byte>> add_zip_file(ZipWriter& zip, std::string_view name, std::span<const std::byte> bytes);

/// Returns the directory, which ends the archive. Offsets from 4 GB on and 65,535 or more files are in records of
/// ZIP64; smaller archives have none.
std::vector<std::byte> zip_directory(const ZipWriter& zip);

}  // namespace citykiln::exporters
