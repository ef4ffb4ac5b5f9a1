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

/// Returns the text without the byte order mark of UTF-8, which some editors write.
inline std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return text;
}

/// Reads the files with a suffix, such as ".cga", in a folder and its subfolders, sorted by name, without byte order
/// marks. Errors: not a folder,
/// a file that cannot be read.
Result<std::vector<TextFile>> read_texts(const std::string& folder, std::string_view ending);

}  // namespace citykiln::source
