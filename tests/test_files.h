// Paths of the files that tests and benchmarks read, and how much of a long test runs.
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

/// The first number, or the second where CITYKILN_FULL is set (./test.sh --full long): rounds of a test, for example.
int quick_or_full(int quick, int full);

}  // namespace citykiln
