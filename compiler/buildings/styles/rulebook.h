// The rule files of the building styles, as texts and parsed.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/contract/result.h"
#include "grammars/language/syntax.h"

namespace citykiln::buildings {

/// A rule file: rules of a grammar by which buildings of one style get walls, windows and roofs. The manifest, the file
/// with a compiled scene, stores the rules that the scene uses.
struct RuleText {
  std::string name;  ///< The name used in imports: "old_town_house.cga", "parts/window.cga".
  std::string text;
  bool operator==(const RuleText&) const = default;
};

/// Returns the rule files of grammars/rules, which are compiled into the program. Sorted by name.
std::span<const RuleText> shipped_rules();

/// Returns the rule files that the styles need, imports included, sorted by name. Errors: a file that is not
/// among `available`; the first rule that does not parse, with file, line and column.
Result<std::vector<RuleText>> rules_for(std::span<const Style> styles, std::span<const RuleText> available);

/// The parsed rules by style; Style::kPlain has no rules.
using Rulebook = std::map<Style, grammars::Program>;

/// Parses the rules of every style. Leaves out styles whose files are missing or do not parse. The programs are copies
/// and do not refer to the texts. Cost: linear in the length of the texts.
Rulebook parse_rulebook(std::span<const RuleText> texts);

/// Returns the styles of some buildings, sorted and unique.
std::vector<Style> styles_of(std::span<const Building> buildings);

}  // namespace citykiln::buildings
