#include "lsystems/rewriting/module_string.h"

#include <fmt/format.h>

namespace citykiln::lsystems {

std::string text_of(const LSystem& system, const ModuleString& string) {
  std::string text;
  std::size_t value = 0;
  bool was_long = false;
  for (const Kind k : string.kinds) {
    const ModuleKind& kind = system.kinds[k];
    const bool is_long = kind.name.size() > 1 && kind.name[0] != '~' && kind.name[0] != '@' && kind.name[0] != '?';
    if ((is_long || was_long) && !text.empty()) text += ' ';
    was_long = is_long;
    text += kind.name;
    for (int i = 0; i < kind.arity; ++i) text += fmt::format("{}{}", i == 0 ? '(' : ',', string.values[value++]);
    if (kind.arity > 0) text += ')';
  }
  return text;
}

}  // namespace citykiln::lsystems
