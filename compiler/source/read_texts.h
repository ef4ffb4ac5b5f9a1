// All texts of a kind in a folder.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::source {

struct TextFile {
  std::string name;  ///< Below the folder, with "/" between folders: "parts/window.cga".
  std::string text;
};

/// Files with this ending (".cga") in a folder and the folders in it, sorted by name. Errors: what is no folder, a file
/// that cannot be read.
Result<std::vector<TextFile>> read_texts(const std::string& folder, std::string_view ending);

}  // namespace citykiln::source
