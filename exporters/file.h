// Whole files in and out. What is half-written never has its final name.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// Writes beside the final name, closes, then renames. On any failure (full disk, unwritable folder) the temporary file
/// is removed, and what bore the final name before still does.
Result<Done> write_file(const std::string& path, std::span<const std::byte> bytes);
/// Errors: what is not there, a folder, a pipe (its size is not known).
Result<std::vector<std::byte>> read_file(const std::string& path);

}  // namespace citykiln::exporters
