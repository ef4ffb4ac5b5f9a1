#include "compiler/commands/view/frame_names.h"

#include <fmt/format.h>

#include <charconv>

namespace citykiln::commands {
namespace {

// A run of characters of a path: [begin, end).
struct Run {
  std::size_t begin = 0, end = 0;
};

// The last run of these characters in the file's name without extension; an empty run if there is none.
Run last_run_of(const std::string& path, const char* characters) {
  const std::size_t slash = path.rfind('/'), name = slash == std::string::npos ? 0 : slash + 1;
  const std::size_t dot = path.rfind('.'), stem_end = dot == std::string::npos || dot < name ? path.size() : dot;
  if (stem_end == name) return {};
  const std::size_t last = path.find_last_of(characters, stem_end - 1);
  if (last == std::string::npos || last < name) return {};
  const std::size_t before = path.find_last_not_of(characters, last);
  return {before == std::string::npos ? 0 : before + 1, last + 1};
}

}  // namespace

Result<std::vector<std::string>> frame_names(const std::string& path, int count) {
  Run run = last_run_of(path, "#");
  long first = 1;
  if (run.end == 0) {
    run = last_run_of(path, "0123456789");
    const auto [end, problem] = std::from_chars(path.data() + run.begin, path.data() + run.end, first);
    if (run.end == 0 || problem != std::errc())
      return Error{path, "expected a name with # or digits for the frame's number, such as frame_####.png"};
  }
  std::vector<std::string> names;
  for (long i = 0; i < count; ++i)
    names.push_back(
        fmt::format("{}{:0{}}{}", path.substr(0, run.begin), first + i, run.end - run.begin, path.substr(run.end)));
  return names;
}

}  // namespace citykiln::commands
