// Writes whole zip archives without compression, in memory (zip_writer.h writes larger ones).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// A file of an archive.
struct ZippedFile {
  std::string name;  ///< With folders: "textures/AsphaltColour.jpg".
  std::vector<std::byte> bytes;
};

/// Returns a zip archive of uncompressed files in the given order. The data of each file begin at a multiple of
/// `alignment` bytes, not 0; dates are constant. Error: more than 4 GB.
Result<std::vector<std::byte>> stored_zip(std::span<const ZippedFile> files, std::size_t alignment);

}  // namespace citykiln::exporters
