// Unpacks PBF files with blobs that libosmium does not read: packed with lz4 or zstd, or without the size of their
// content.
#pragma once

#include <optional>
#include <string>

#include "compiler/contract/result.h"

namespace citykiln::source {

/// Returns the file with all blobs unpacked if it has such a blob, else nothing. Holds the unpacked file in memory
/// then; else it reads a few bytes of each blob.
///
/// Errors: a blob that is damaged, larger than 32 MiB (the format's limit), or packed in another way.
/// @param path  A file whose blobs are complete (osm_format_of()).
Result<std::optional<std::string>> mended_pbf(const std::string& path);

}  // namespace citykiln::source
