// Unpacks PBF files with blobs that libosmium does not read: packed with lz4 or zstd, or without the size of their
// content.
#pragma once

#include <optional>
#include <string>

#include "compiler/contract/result.h"

namespace citykiln::source {

/// Returns the bytes of the file with all blobs unpacked, if it has a blob that libosmium does not read, else nothing.
/// Nothing too for a file that is no PBF: libosmium says what is wrong with it. Holds the unpacked file in memory; a
/// file that needs no change costs a few bytes read for each blob.
///
/// Errors, only for files with such a blob: data that cannot be unpacked, a packed blob of more than 32 MiB (the
/// format's limit), or one packed in another way.
/// @param path  A file whose blobs are complete (osm_format_of()).
Result<std::optional<std::string>> mended_pbf(const std::string& path);

}  // namespace citykiln::source
