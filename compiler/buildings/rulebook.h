// The rule files that buildings are made by.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/contract/result.h"
#include "grammars/language/syntax.h"

namespace citykiln::buildings {

/// A rule file as it is written into the manifest.
struct RuleText {
  std::string name;  ///< As imports name it: "old_town_house.cga", "parts/window.cga".
  std::string text;
  bool operator==(const RuleText&) const = default;
};

/// What citykiln ships: grammars/rules, built in. Sorted by name.
std::span<const RuleText> shipped_rules();

/// The texts that these styles need, with all that they import, sorted by name. The first rule that cannot be read is
/// the error: one line, with file, line and column.
Result<std::vector<RuleText>> rules_for(std::span<const Style> styles, std::span<const RuleText> available);

/// Programs by style; kPlain has none.
using Rulebook = std::map<Style, grammars::Program>;

/// Those of the styles whose rules can be read. Cost: the texts' length.
Rulebook parse_rulebook(std::span<const Style> styles, std::span<const RuleText> texts);

/// The styles of some buildings, sorted, each once.
std::vector<Style> styles_of(std::span<const Building> buildings);

}  // namespace citykiln::buildings
