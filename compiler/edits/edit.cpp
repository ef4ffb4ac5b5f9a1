#include "compiler/edits/edit.h"

#include <fmt/format.h>

#include <cmath>

namespace citykiln::edits {

std::string source_text(const Edits& edits) {
  return fmt::format("{} ({} edits, {:016x})", edits.name, edits.lines.size(), edits.hash);
}

std::string place_text(const Edits& edits, const Edit& edit) {
  return fmt::format("{}:{}:{}", edits.name, edit.line, edit.column);
}

double longest_move_m(const Edits& edits) {
  double sum_m = 0;
  for (const Edit& edit : edits.lines)
    if (const auto& moved_m = edit.changes.moved_m)
      sum_m += std::sqrt(moved_m->x * moved_m->x + moved_m->y * moved_m->y);
  return sum_m;
}

}  // namespace citykiln::edits
