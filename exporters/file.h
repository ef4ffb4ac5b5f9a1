// Reads and writes whole files. A file gets its final name only when it is complete.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// Writes a temporary file beside the final name, closes it, then renames it. On any failure (full disk, unwritable
/// folder) it removes the temporary file and leaves an earlier file of that name as it was.
Result<Done> write_file(const std::string& path, std::span<const std::byte> bytes);
/// Reads a file. Errors: a missing file, a folder, a pipe (its size is unknown).
Result<std::vector<std::byte>> read_file(const std::string& path);

}  // namespace citykiln::exporters
