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
  double sum_m = 0, place_m = 0;
  for (const Edit& edit : edits.lines) {
    const Changes& changes = edit.changes;
    if (changes.placed) place_m = kFarthestPlace_m;
    if (changes.moved_m)
      sum_m += std::sqrt(changes.moved_m->x * changes.moved_m->x + changes.moved_m->y * changes.moved_m->y);
  }
  return sum_m + place_m;
}

}  // namespace citykiln::edits
