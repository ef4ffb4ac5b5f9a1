// Paths of the files that tests and benchmarks read.
#pragma once

#include <filesystem>
#include <string_view>

namespace citykiln {

/// A file or folder of the real data (../shared/data), which may be absent.
///
/// @param file  From the folder of the real data; empty for that folder itself.
std::filesystem::path real_data(std::string_view file = {});

/// A file of the source tree.
///
/// @param file  From the root of the tree.
std::filesystem::path source_file(std::string_view file);

}  // namespace citykiln
