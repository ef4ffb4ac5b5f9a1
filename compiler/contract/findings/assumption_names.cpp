#include "compiler/contract/findings/assumption_names.h"

namespace citykiln {

std::vector<std::string> names_in(Assumptions set) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < static_cast<std::size_t>(Assumption::kCount); ++i)
    if (const auto assumption = static_cast<Assumption>(i); has(set, assumption))
      names.emplace_back(name_of(assumption));
  return names;
}

std::string bits_text() {
  std::string text;
  for (const std::string& name : names_in(kAllAssumptions)) {
    if (!text.empty()) text += ", ";
    text += std::to_string(bit_of(*assumption_named(name))) + ' ' + name;
  }
  return text;
}

}  // namespace citykiln
