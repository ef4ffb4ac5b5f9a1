#include "compiler/source/read_texts.h"

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

namespace citykiln::source {

namespace fs = std::filesystem;

Result<std::vector<TextFile>> read_texts(const std::string& folder, std::string_view ending) {
  assert(ending.starts_with('.'));
  std::error_code problem;
  std::vector<TextFile> files;
  fs::recursive_directory_iterator entries(folder, problem);
  if (problem) return Error{folder, "expected a folder: " + problem.message()};
  for (const fs::directory_entry& entry : entries) {
    if (!entry.is_regular_file(problem) || entry.path().extension() != ending) continue;
    std::ifstream file(entry.path(), std::ios::binary);
    if (!file) return Error{entry.path().string(), "cannot be read"};
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    files.push_back(
        {entry.path().lexically_relative(folder).generic_string(), std::string(without_byte_order_mark(text))});
  }
  std::sort(files.begin(), files.end(), [](const TextFile& a, const TextFile& b) { return a.name < b.name; });
  return files;
}

}  // namespace citykiln::source
