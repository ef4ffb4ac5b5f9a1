#include "compiler/buildings/styles/rulebook.h"

namespace citykiln::buildings {

std::span<const RuleText> shipped_rules() {
  static const std::vector<RuleText> rules = {
#include "compiler/buildings/shipped_rules_generated.h"
  };
  return rules;
}

}  // namespace citykiln::buildings
