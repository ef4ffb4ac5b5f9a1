// Reads all text files with one suffix in a folder.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::source {

struct TextFile {
  std::string name;  ///< Path relative to the folder with "/" as separator: "parts/window.cga".
  std::string text;
};

/// Reads the files with a suffix, such as ".cga", in a folder and its subfolders, sorted by name. Errors: not a folder,
/// a file that cannot be read.
Result<std::vector<TextFile>> read_texts(const std::string& folder, std::string_view ending);

}  // namespace citykiln::source
