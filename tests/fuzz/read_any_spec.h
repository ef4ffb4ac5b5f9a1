// Checks that a text is a spec or an error of one line, for fuzz_spec and for tests/compiler/any_spec_test.cpp, which
// changes its seeds.
#pragma once

#include <string>
#include <string_view>

#include "compiler/spec.h"
#include "tests/scratch_folder.h"

namespace citykiln {

// Reads the text as spec.json and checks the settings. Returns "" if they are read, or refused with one line that names
// the file, else what is wrong.
inline std::string fault_of_spec(std::string_view text) {
  static const ScratchFolder folder;
  const std::string path = folder.write("spec.json", text);
  const Result<CompileSpec> spec = read_spec(path);
  if (spec) {
    static_cast<void>(check_complete(*spec));
    static_cast<void>(check_target(spec->outputs));
    return "";
  }
  const std::string line = to_string(spec.error());
  if (!line.starts_with(path)) return "an error without the file: " + line;
  return line.find('\n') == std::string::npos ? "" : "an error of several lines: " + line;
}

}  // namespace citykiln
