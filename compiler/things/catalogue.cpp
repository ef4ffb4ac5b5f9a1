#include "compiler/things/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>

#include "compiler/contract/texts/parse.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/things/front_kinds.h"
#include "compiler/things/street_kinds.h"
#include "compiler/things/yard_kinds.h"
#include "grammars/language/builtin.h"
#include "grammars/language/read_rules.h"

namespace citykiln::things {
namespace {

// Visits each rule, function and attribute once.
class ValueFinder {
 public:
  explicit ValueFinder(const grammars::Program& program)
      : program_(program),
        attributes_(program.attributes.size()),
        functions_(program.functions.size()),
        rules_(program.rules.size()) {}

  void visit_rule(std::uint32_t rule) {
    if (rules_[rule]) return;
    rules_[rule] = true;
    visit(program_.rules[rule].body);
  }

  UsedValues found;

 private:
  void visit_function(std::uint32_t function) {
    if (functions_[function]) return;
    functions_[function] = true;
    visit(program_.functions[function].value);
  }

  void visit_attribute(std::uint32_t attribute) {
    if (attributes_[attribute]) return;
    attributes_[attribute] = true;
    const grammars::Attribute& read = program_.attributes[attribute];
    if (!read.is_const) found.attributes.insert(read.name);
    visit(read.value);
  }

  void visit(const grammars::Expression& expression) {
    if (expression.target == grammars::Target::kAttribute) visit_attribute(expression.index);
    if (expression.target == grammars::Target::kFunction) visit_function(expression.index);
    if (expression.target == grammars::Target::kBuiltin) found.draws |= is_draw(expression.index);
    found.draws |= expression.kind == grammars::ExpressionKind::kChance;
    for (const grammars::Expression& operand : expression.operands) visit(operand);
  }

  static bool is_draw(std::uint32_t function) {
    const grammars::FunctionKind kind = grammars::builtin_functions()[function].kind;
    return kind == grammars::FunctionKind::kDraw || kind == grammars::FunctionKind::kUniformDraw;
  }

  void visit(const grammars::Selector& selector) {
    visit(selector.key);
    for (const grammars::Selector& nested : selector.nested) visit(nested);
    visit(selector.body);
  }

  void visit(const grammars::Statement& statement) {
    for (const grammars::Expression& argument : statement.arguments) visit(argument);
    for (const grammars::Selector& selector : statement.selectors) visit(selector);
    for (const grammars::Body& block : statement.block) visit(block);
    if (statement.kind == grammars::StatementKind::kSuccessor && statement.index != ~0u) visit_rule(statement.index);
  }

  void visit(const grammars::Body& body) {
    found.draws |= body.kind == grammars::BodyKind::kChance;
    for (const grammars::Local& local : body.locals) visit(local.value);
    for (const grammars::Statement& statement : body.statements) visit(statement);
    for (const grammars::Branch& branch : body.branches) visit(branch.test), visit(branch.body);
  }

  const grammars::Program& program_;
  std::vector<bool> attributes_, functions_, rules_;
};

}  // namespace

UsedValues used_values(const grammars::Program& program, const std::string& start) {
  ValueFinder finder(program);
  if (const auto rule = program.rule_of.find(start); rule != program.rule_of.end()) finder.visit_rule(rule->second);
  return std::move(finder.found);
}

namespace {

constexpr const char* kStart = "Thing";

const RuleText* text_named(std::span<const RuleText> texts, std::string_view name) {
  const auto found = std::ranges::find(texts, name, &RuleText::name);
  return found == texts.end() ? nullptr : &*found;
}

Result<grammars::Program> program_of(const map::ThingRow& row, std::span<const RuleText> texts) {
  const auto load = [&](const std::string& file) -> Result<std::string> {
    const RuleText* found = text_named(texts, file);
    if (found == nullptr) return Error{file, "there is no such rule file"};
    return found->text;
  };
  Result<grammars::Program> program = grammars::read_rules(row.rule + ".cga", load);
  if (program && !program->rule_of.contains(kStart))
    return Error{row.rule + ".cga", fmt::format("expected a rule \"{}\", found none", kStart)};
  return program;
}

Result<Kind> kind_of(const map::ThingRow& row, std::span<const RuleText> texts) {
  Result<grammars::Program> program = program_of(row, texts);
  if (!program) return program.error();
  program->is_shipped = std::ranges::all_of(program->files, [&](const std::string& name) {
    const RuleText *text = text_named(texts, name), *shipped = text_named(shipped_things(), name);
    return shipped != nullptr && text->text == shipped->text;
  });
  UsedValues used = used_values(*program, kStart);
  return Kind{row, std::move(*program), std::move(used)};
}

Result<map::ThingTable> table_in(std::span<const RuleText> files, const std::string& place) {
  const RuleText* text = text_named(files, kTableName);
  return text == nullptr ? map::ThingTable{} : map::read_thing_table(text->text, place);
}

bool is_rule_file(const RuleText& text) { return text.name.ends_with(".cga"); }

// The number of the line of a table that begins with a name; 0 if there is none.
std::size_t line_of(std::string_view table, std::string_view name) {
  std::size_t number = 0;
  for (const std::string_view line : split(table, '\n')) {
    ++number;
    const std::vector<std::string_view> words = words_in(line);
    if (!words.empty() && words.front() == name) return number;
  }
  return 0;
}

// Error: a row names a rule file that is neither in the folder nor shipped.
Result<Done> check_rule_files(std::span<const RuleText> own, const Catalogue& catalogue, const std::string& place) {
  const RuleText* table = text_named(own, kTableName);
  for (const map::ThingRow& row : catalogue.table)
    if (text_named(catalogue.rules, row.rule + ".cga") == nullptr)
      return Error{fmt::format("{}:{}", place, table == nullptr ? 0 : line_of(table->text, row.name)),
                   fmt::format("rule: there is no file {}.cga in the folder, nor a shipped one", row.rule)};
  return Done{};
}

}  // namespace

Result<Catalogue> read_catalogue(std::span<const RuleText> own, const std::string& folder) {
  const std::string place = folder.empty() ? kTableName : folder + "/" + kTableName;
  Result<map::ThingTable> rows = table_in(own, place);
  if (!rows) return rows.error();
  const Result<map::ThingTable> shipped = table_in(shipped_things(), kTableName);
  if (!shipped) return shipped.error();
  Catalogue catalogue{map::merged(std::move(*rows), *shipped), {}};
  std::ranges::copy_if(own, std::back_inserter(catalogue.rules), is_rule_file);
  for (const RuleText& rule : shipped_things())
    if (is_rule_file(rule) && text_named(own, rule.name) == nullptr) catalogue.rules.push_back(rule);
  std::ranges::sort(catalogue.rules, {}, &RuleText::name);
  if (own.empty()) return catalogue;
  if (const Result<Done> there = check_rule_files(own, catalogue, place); !there) return there.error();
  const Result<Kinds> kinds = kinds_of(catalogue);
  if (!kinds) return kinds.error();
  return catalogue;
}

Result<Kinds> kinds_of(const Catalogue& catalogue, const std::set<std::string>& names) {
  Kinds kinds;
  for (const map::ThingRow& row : catalogue.table) {
    if (!names.empty() && !names.contains(row.name)) continue;
    Result<Kind> kind = kind_of(row, catalogue.rules);
    if (!kind)
      return Error{kind.error().where, fmt::format("{} (for the thing \"{}\")", kind.error().message, row.name)};
    kinds.emplace(row.name, std::move(*kind));
  }
  return kinds;
}

std::vector<RuleText> texts_for(const Catalogue& catalogue, const Kinds& kinds, std::span<const Thing> things,
                                std::span<const YardUse> uses) {
  std::set<std::string_view> used, files;
  for (const Thing& thing : things) used.insert(thing.form.kind);
  std::vector<RuleText> texts;
  for (const auto& [name, kind] : kinds) {
    if (!used.contains(name) && map::role_of(name) != map::ThingRole::kCar && !is_street_kind(name) &&
        !is_front_kind(name) && !is_kind_of(name, uses))
      continue;
    texts.push_back({name, kind.row.line});
    files.insert(kind.rules.files.begin(), kind.rules.files.end());
  }
  for (const RuleText& rule : catalogue.rules)
    if (files.contains(rule.name)) texts.push_back(rule);
  std::ranges::sort(texts, {}, &RuleText::name);
  return texts;
}

Kinds parse_kinds(std::span<const RuleText> texts) {
  Kinds kinds;
  for (const RuleText& text : texts) {
    if (is_rule_file(text)) continue;
    const Result<map::ThingTable> table = map::read_thing_table(text.text, text.name);
    if (!table || table->size() != 1) continue;
    if (Result<Kind> kind = kind_of(table->front(), texts)) kinds.emplace(text.name, std::move(*kind));
  }
  return kinds;
}

}  // namespace citykiln::things
