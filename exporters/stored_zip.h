// Writes zip archives without compression.
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
/// `alignment` bytes; dates are constant. Error: more than 4 GB. Source: PKWARE, APPNOTE.TXT 6.3.
Result<std::vector<std::byte>> stored_zip(std::span<const ZippedFile> files, std::size_t alignment);

}  // namespace citykiln::exporters
