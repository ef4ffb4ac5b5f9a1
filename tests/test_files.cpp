#include "tests/test_files.h"

#include <cstdlib>

namespace citykiln {

std::filesystem::path real_data(std::string_view file) {
  const std::filesystem::path folder = CITYKILN_DATA;
  return file.empty() ? folder : folder / file;
}

std::filesystem::path source_file(std::string_view file) { return std::filesystem::path(CITYKILN_SOURCE) / file; }

int quick_or_full(int quick, int full) { return std::getenv("CITYKILN_FULL") == nullptr ? quick : full; }

}  // namespace citykiln
