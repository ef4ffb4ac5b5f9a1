// Reads files of the source tree, for tests of rules.
#pragma once

#include <fstream>
#include <sstream>
#include <string>

#include "compiler/contract/result.h"
#include "tests/test_files.h"

namespace citykiln::grammars {

/// @param path  From the root of the tree.
inline Result<std::string> text_of_tree(const std::string& path) {
  std::ifstream in(source_file(path));
  if (!in) return Error{path, "cannot be read"};
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The text of a shipped rule file, named as in imports: "villa.cga", "parts/openings.cga".
inline Result<std::string> shipped(const std::string& file) { return text_of_tree("grammars/rules/" + file); }

}  // namespace citykiln::grammars
