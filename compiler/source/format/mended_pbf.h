// Unpacks PBF files with blobs that libosmium does not read: packed with lz4 or zstd, or without the size of their
// content.
#pragma once

#include <optional>
#include <string>

#include "compiler/contract/result.h"

namespace citykiln::source {

/// Returns a PBF file with the same content that libosmium reads, as bytes in memory with all blobs unpacked. Returns
/// nothing if libosmium reads the file as it is, or if the file is not a PBF: libosmium reports what is wrong with it.
///
/// Errors, only for files with a blob that libosmium does not read: data that cannot be unpacked; a packed blob whose
/// content is larger than 32 MiB, the format's limit; another way of packing. They state the path and the byte of the
/// blob.
///
/// Cost: a file that needs no change costs a few bytes read for each blob, others the time to unpack them and the
/// memory of the unpacked file.
/// @param path  A file whose blobs are complete (osm_format_of()).
Result<std::optional<std::string>> mended_pbf(const std::string& path);

}  // namespace citykiln::source
