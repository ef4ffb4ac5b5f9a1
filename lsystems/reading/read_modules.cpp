// Reads modules and productions.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "lsystems/random_source.h"
#include "lsystems/reading/read_lsystem.h"
#include "lsystems/reading/reader.h"

namespace citykiln::lsystems {
namespace {

constexpr std::string_view kSigns = "+-&^\\/|$%!'~@;,{}[].#?";

struct SymbolRow {
  std::string_view name;
  TurtleOp op;
};

constexpr SymbolRow kSymbols[] = {
#define SYMBOL(name, op, text) {name, TurtleOp::op},
#include "lsystems/turtle_symbols.inc"
    {"?P", TurtleOp::kQueryPosition},
    {"?H", TurtleOp::kQueryHeight},
    {"?S", TurtleOp::kQueryShade},
};

int answers_of(TurtleOp op) {
  if (op == TurtleOp::kQueryPosition) return 3;
  return op == TurtleOp::kQueryHeight || op == TurtleOp::kQueryShade ? 1 : 0;
}

TurtleOp op_of(const std::string& name) {
  const auto* row = std::find_if(std::begin(kSymbols), std::end(kSymbols),
                                 [&](const SymbolRow& symbol) { return symbol.name == name; });
  if (row != std::end(kSymbols)) return row->op;
  return name[0] == '~' ? TurtleOp::kInstance : TurtleOp::kNone;
}

bool is_unary(const std::string& name) { return name == "[" || name == "]" || name == "%"; }

std::string take_long_name(Reader& reader) {
  for (const std::string& name : reader.long_names) {
    if (!reader.starts_with(name)) continue;
    reader.at += name.size();
    return name;
  }
  return {};
}

// A name with prefix ~, @ or ?.
std::string take_prefixed(Reader& reader) {
  std::string name(1, reader.text[reader.at++]);
  const std::string rest = take_long_name(reader);
  if (!rest.empty()) return name + rest;
  if (!is_letter(reader.peek())) {
    reader.fail_expected(fmt::format("a letter behind '{}'", name));
    return {};
  }
  return name + reader.text[reader.at++];
}

// Reads ( a, b, … ) directly after a module's name. Returns the number of items.
template <typename ReadOne>
std::size_t read_list(Reader& reader, ReadOne read_one) {
  if (reader.peek() != '(') return 0;
  ++reader.at;
  std::size_t count = 0;
  do {
    read_one();
    if (++count > kArityLimit)
      reader.fail(reader.place(), fmt::format("a module has at most {} parameters", kArityLimit));
  } while (!reader.failed && reader.accept(","));
  reader.expect(")", "or ',' after a parameter");
  return count;
}

// Positions of open brackets, for errors.
struct Brackets {
  std::vector<TextPosition> open;

  void take(Reader& reader, const std::string& name, TextPosition place) {
    if (name == "[") open.push_back(place);
    if (name != "]") return;
    if (open.empty()) return reader.fail(place, "']' without '['");
    open.pop_back();
  }
  void close(Reader& reader) const {
    if (!open.empty()) reader.fail(open.back(), "'[' without ']'");
  }
};

// Whether a word of three lower-case letters that no `module` declares follows on the line.
bool has_prose(const Reader& reader) {
  // 100 bytes suffice for a comment's first words, and bound the cost of many //
  const std::size_t line = std::min({reader.text.find('\n', reader.at), reader.end, reader.at + 100});
  for (std::size_t at = reader.at; at < line; ++at) {
    std::size_t to = at;
    while (to < line && reader.text[to] >= 'a' && reader.text[to] <= 'z') ++to;
    const std::string_view word = reader.text.substr(at, to - at);
    const bool declared = std::any_of(reader.long_names.begin(), reader.long_names.end(),
                                      [&](const std::string& name) { return word.starts_with(name); });
    if (word.size() >= 3 && !declared) return true;
    at = std::max(at, to);
  }
  return false;
}

// Rejects a // comment among modules: its letters would silently become modules.
void refuse_comment(Reader& reader, TextPosition place) {
  if (!reader.starts_with("// ") || !has_prose(reader)) return;
  reader.fail(place, "// is two modules here: use /* */ for comments among modules");
}

void check_arity(Reader& reader, const std::string& name, std::size_t arity, TextPosition place) {
  const int answers = answers_of(op_of(name));
  if (is_unary(name) && arity > 0) reader.fail(place, fmt::format("'{}' has no parameters", name));
  if (answers > 0 && arity != static_cast<std::size_t>(answers))
    reader.fail(place, fmt::format("expected {} of '{}', found {}", answers == 1 ? "1 parameter" : "3 parameters", name,
                                   arity));
  if (op_of(name) == TurtleOp::kTropism && arity != 4)
    reader.fail(place, fmt::format("expected 4 parameters of '@T', found {}", arity));
  if (name[0] == '?' && answers == 0) reader.fail(place, fmt::format("there is no query '{}', only ?P ?H ?S", name));
  if (name[0] == '?' && !reader.may_query) reader.fail(place, "interpretation rules have no queries");
}

std::string take_parameter(Reader& reader) {
  std::string name = take_name(reader);
  if (name.empty()) reader.fail_expected("a parameter's name");
  if (std::find(reader.slots.begin(), reader.slots.end(), name) != reader.slots.end())
    reader.fail(reader.place(), fmt::format("the parameter '{}' is named twice", name));
  return name;
}

// Skips a production's label, as p1:
void skip_label(Reader& reader) {
  reader.skip_space();
  std::size_t digits = reader.peek() == 'p' ? 1 : 0;
  while (digits > 0 && is_digit(reader.peek(digits))) ++digits;
  if (digits < 2) return;
  const std::size_t before = reader.at;
  reader.at += digits;
  if (!reader.accept(":")) reader.at = before;
}

Range appended(std::vector<Kind>& to, const std::vector<Kind>& kinds) {
  const Range range{static_cast<std::uint32_t>(to.size()), static_cast<std::uint32_t>(kinds.size())};
  to.insert(to.end(), kinds.begin(), kinds.end());
  return range;
}

void read_predecessor(Reader& reader, Rule& rule, TextPosition place, const std::vector<Kind>& pattern) {
  const LSystem& system = reader.system;
  if (pattern.size() != 1) {
    const char* long_names = pattern.size() > 1 ? "; `module` declares names of more than one letter" : "";
    return reader.fail(place,
                       fmt::format("expected one module before the arrow, found {}{}", pattern.size(), long_names));
  }
  rule.predecessor = pattern[0];
  if (is_unary(system.kinds[rule.predecessor].name))
    reader.fail(place, fmt::format("'{}' cannot be rewritten", system.kinds[rule.predecessor].name));
}

// Reads left < predecessor > right.
void read_left_side(Reader& reader, Rule& rule, bool contexts_allowed) {
  reader.skip_space();
  TextPosition place = reader.place();
  std::vector<Kind> pattern = read_pattern(reader);
  if (reader.accept("<")) {
    if (!contexts_allowed) return reader.fail(place, "these rules have no contexts");
    for (const Kind kind : pattern)
      if (is_unary(reader.system.kinds[kind].name))
        return reader.fail(place, "a left context is a path: no brackets and no %");
    rule.left = appended(reader.system.contexts, pattern);
    rule.predecessor_slot = static_cast<std::uint16_t>(reader.slots.size());
    reader.skip_space();
    place = reader.place();
    pattern = read_pattern(reader);
  }
  read_predecessor(reader, rule, place, pattern);
  rule.right_slot = static_cast<std::uint16_t>(reader.slots.size());
  reader.skip_space();
  place = reader.place();
  if (reader.failed || !reader.accept(">")) return;
  if (!contexts_allowed) return reader.fail(place, "these rules have no contexts");
  rule.right = appended(reader.system.contexts, read_pattern(reader));
}

// Reads ": condition"; "*" stands for no condition.
void read_condition(Reader& reader, Rule& rule) {
  if (reader.failed || !reader.accept(":") || reader.accept("*")) return;
  rule.condition = read_value(reader);
  rule.has_condition = true;
}

bool take_arrow(Reader& reader) {
  if (reader.accept("-->") || reader.accept("->")) return true;
  reader.fail_expected("'->'");
  return false;
}

void read_probability(Reader& reader, Rule& rule) {
  reader.skip_space();
  if (rule.has_probability) return reader.fail(reader.place(), "the production has a probability already");
  rule.probability = read_value(reader);
  rule.has_probability = true;
}

void read_successor_part(Reader& reader, Rule& rule) {
  if (reader.accept("(")) {
    read_probability(reader, rule);
    reader.expect(")", "after the probability");
  }
  if (!reader.accept("*")) rule.successor = read_successor(reader);
  if (rule.successor.kinds.count == 0)
    rule.successor.kinds.first = static_cast<std::uint32_t>(reader.system.successor_kinds.size());
  if (!reader.failed && reader.accept(":")) read_probability(reader, rule);
  reader.skip_space();
  if (!reader.failed && !reader.done()) reader.fail_expected("a module or the end of the production");
}

}  // namespace

std::string take_module_name(Reader& reader) {
  reader.skip_space();
  if (reader.done() || at_arrow(reader)) return {};
  const std::string name = take_long_name(reader);
  if (!name.empty()) return name;
  const char first = reader.peek();
  if (first == '~' || first == '@' || first == '?') return take_prefixed(reader);
  if (!is_letter(first) && !is_digit(first) && kSigns.find(first) == std::string_view::npos) return {};
  ++reader.at;
  return std::string(1, first);
}

Kind kind_named(Reader& reader, const std::string& name, std::size_t arity) {
  auto& kinds = reader.system.kinds;
  const auto [found, is_new] =
      reader.kind_of.try_emplace({name, static_cast<int>(arity)}, static_cast<Kind>(kinds.size()));
  if (!is_new) return found->second;
  if (kinds.size() >= 60'000) reader.fail(reader.place(), "a system has at most 60000 kinds of modules");
  kinds.push_back({name, static_cast<std::uint8_t>(arity), op_of(name), false});
  reader.system.has_queries |= name[0] == '?';
  return found->second;
}

Successor read_successor(Reader& reader) {
  Successor successor;
  LSystem& system = reader.system;
  successor.kinds.first = static_cast<std::uint32_t>(system.successor_kinds.size());
  successor.values.first = static_cast<std::uint32_t>(system.values.size());
  Brackets brackets;
  while (!reader.failed) {
    reader.skip_space();
    const TextPosition place = reader.place();
    refuse_comment(reader, place);
    const std::string name = take_module_name(reader);
    if (name.empty()) break;
    const std::size_t arity = read_list(reader, [&] { system.values.push_back(read_value(reader)); });
    check_arity(reader, name, arity, place);
    brackets.take(reader, name, place);
    system.successor_kinds.push_back(kind_named(reader, name, arity));
  }
  brackets.close(reader);
  successor.kinds.count = static_cast<std::uint32_t>(system.successor_kinds.size()) - successor.kinds.first;
  successor.values.count = static_cast<std::uint32_t>(system.values.size()) - successor.values.first;
  for (std::size_t i = successor.values.first; i < system.values.size(); ++i) successor.code += system.values[i].count;
  return successor;
}

std::vector<Kind> read_pattern(Reader& reader) {
  std::vector<Kind> pattern;
  Brackets brackets;
  while (!reader.failed) {
    reader.skip_space();
    const TextPosition place = reader.place();
    const std::string name = take_module_name(reader);
    if (name.empty()) break;
    const std::size_t arity = read_list(reader, [&] { reader.slots.push_back(take_parameter(reader)); });
    check_arity(reader, name, arity, place);
    brackets.take(reader, name, place);
    pattern.push_back(kind_named(reader, name, arity));
    if (pattern.size() > kArityLimit) reader.fail(place, fmt::format("a context has at most {} modules", kArityLimit));
  }
  brackets.close(reader);
  return pattern;
}

void read_rule(Reader& reader, RuleSet& set, bool contexts_allowed) {
  reader.slots.clear();
  reader.draws = 1;  // draw 0 chooses between rules
  reader.may_draw = true;
  skip_label(reader);
  reader.skip_space();
  Rule rule;
  rule.place = reader.place();
  read_left_side(reader, rule, contexts_allowed);
  const bool has_predecessor = !reader.failed;
  read_condition(reader, rule);
  if (!reader.failed && take_arrow(reader)) read_successor_part(reader, rule);
  rule.slots = static_cast<std::uint16_t>(reader.slots.size());
  if (reader.draws > static_cast<int>(kDrawsPerModule))
    reader.fail(rule.place, fmt::format("a production has at most {} random draws", kDrawsPerModule - 1));
  if (has_predecessor && reader.failed)
    reader.failed->message += fmt::format(" (in rule {})", reader.system.kinds[rule.predecessor].name);
  set.has_contexts |= rule.left.count + rule.right.count > 0;
  set.rules.push_back(rule);
  reader.slots.clear();
}

}  // namespace citykiln::lsystems
