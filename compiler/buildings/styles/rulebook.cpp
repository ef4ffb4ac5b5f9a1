#include "compiler/buildings/styles/rulebook.h"

#include <algorithm>
#include <set>

#include "compiler/buildings/styles/style.h"
#include "grammars/language/read_rules.h"

namespace citykiln::buildings {
namespace {

Result<grammars::Program> program_of(Style style, std::span<const RuleText> texts) {
  const auto load = [&](const std::string& file) -> Result<std::string> {
    const auto found = std::ranges::find(texts, file, &RuleText::name);
    if (found == texts.end()) return Error{file, "there is no such rule file"};
    return found->text;
  };
  return grammars::read_rules(std::string(rule_file_of(style)) + ".cga", load);
}

bool is_shipped_file(const std::string& name, std::span<const RuleText> texts) {
  const auto text = std::ranges::find(texts, name, &RuleText::name);
  const auto shipped = std::ranges::find(shipped_rules(), name, &RuleText::name);
  return text != texts.end() && shipped != shipped_rules().end() && text->text == shipped->text;
}

bool has_rules(Style style) { return !rule_file_of(style).empty(); }

}  // namespace

Result<std::vector<RuleText>> rules_for(std::span<const Style> styles, std::span<const RuleText> available) {
  std::set<std::string> names;
  for (const Style style : styles) {
    if (!has_rules(style)) continue;
    const Result<grammars::Program> program = program_of(style, available);
    if (!program) return program.error();
    names.insert(program->files.begin(), program->files.end());
  }
  std::vector<RuleText> texts;
  for (const RuleText& rule : available)
    if (names.contains(rule.name)) texts.push_back(rule);
  std::ranges::sort(texts, {}, &RuleText::name);
  return texts;
}

Rulebook parse_rulebook(std::span<const RuleText> texts) {
  Rulebook rulebook;
  for (int i = 0; i < static_cast<int>(Style::kCount); ++i) {
    const auto style = static_cast<Style>(i);
    if (!has_rules(style)) continue;
    Result<grammars::Program> program = program_of(style, texts);
    if (!program) continue;
    program->is_shipped =
        std::ranges::all_of(program->files, [&](const std::string& name) { return is_shipped_file(name, texts); });
    rulebook.emplace(style, std::move(*program));
  }
  return rulebook;
}

std::vector<Style> styles_of(std::span<const Building> buildings) {
  std::set<Style> styles;
  for (const Building& building : buildings) styles.insert(building.style);
  return {styles.begin(), styles.end()};
}

}  // namespace citykiln::buildings
