// Reads and writes whole files. Half-written files never have their final name.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// Writes a temporary file beside the final name, closes it, then renames it. On any failure (full disk, unwritable
/// folder) the temporary file is removed, and a file that had the final name before stays.
Result<Done> write_file(const std::string& path, std::span<const std::byte> bytes);
/// Reads a file. Errors: a missing file, a folder, a pipe (its size is unknown).
Result<std::vector<std::byte>> read_file(const std::string& path);

}  // namespace citykiln::exporters
