#include "grammars/language/resolve.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "grammars/language/builtin.h"
#include "grammars/language/lexer.h"
#include "grammars/language/operation_table.h"

namespace citykiln::grammars {
namespace {

/// The names visible in one definition.
struct Resolver {
  Program& program;
  std::string prefix;
  std::vector<std::string> locals = {};
  std::optional<Error> failed = {};
  std::string within = {};  ///< " (in rule Facade)", for errors.

  void fail(TextPosition position, const std::string& message) {
    if (!failed) failed = Error{position_text(program.files[position.file], position), message + within};
  }
};

void resolve(Resolver& names, Expression& expression);
void resolve(Resolver& names, Body& body);

bool found_in(const std::map<std::string, std::uint32_t, std::less<>>& table, const std::string& name, Target target,
              Expression& expression) {
  const auto found = table.find(name);
  if (found == table.end()) return false;
  expression.target = target;
  expression.index = found->second;
  return true;
}

bool is_local(const Resolver& names, Expression& name) {
  for (std::size_t i = names.locals.size(); i-- > 0;) {
    if (names.locals[i] != name.text) continue;
    name.target = Target::kLocal;
    name.index = static_cast<std::uint32_t>(i);
    return true;
  }
  return false;
}

bool is_builtin(std::span<const BuiltinRow> rows, Target target, Expression& name) {
  const int row = row_of(rows, name.text);
  if (row < 0) return false;
  name.target = target;
  name.index = static_cast<std::uint32_t>(row);
  return true;
}

std::string counted(std::size_t count) { return std::to_string(count) + (count == 1 ? " argument" : " arguments"); }

void check_arity(Resolver& names, const Expression& call, Arity arity) {
  const std::size_t given = call.operands.size();
  if (given >= arity.least && given <= arity.most) return;
  const std::string wants =
      arity.least == arity.most ? counted(arity.most) : std::to_string(arity.least) + " to " + counted(arity.most);
  names.fail(call.position, "expected " + wants + " of '" + call.text + "', found " + std::to_string(given));
}

Arity arity_of_row(const Expression& call) { return arity_of(builtin_functions()[call.index].arguments); }

void resolve_name(Resolver& names, Expression& name) {
  if (is_local(names, name)) return;
  if (found_in(names.program.attribute_of, names.prefix + name.text, Target::kAttribute, name)) return;
  if (is_builtin(shape_values(), Target::kShape, name)) return;
  // rand may be written without parentheses.
  if (is_builtin(builtin_functions(), Target::kBuiltin, name)) return check_arity(names, name, arity_of_row(name));
  if (is_material_value(name.text)) return void(name.target = Target::kShape), void(name.index = ~0u);
  if (!found_in(names.program.function_of, names.prefix + name.text, Target::kFunction, name))
    return names.fail(name.position, "nothing defines the value '" + name.text + "'");
  const std::size_t wants = names.program.functions[name.index].parameters.size();
  if (wants != 0) names.fail(name.position, "expected " + counted(wants) + " of '" + name.text + "', found none");
}

void resolve_call(Resolver& names, Expression& call) {
  for (Expression& operand : call.operands) resolve(names, operand);
  if (found_in(names.program.function_of, names.prefix + call.text, Target::kFunction, call)) {
    const std::size_t wants = names.program.functions[call.index].parameters.size();
    return check_arity(names, call, {wants, wants});
  }
  if (is_builtin(builtin_functions(), Target::kBuiltin, call)) return check_arity(names, call, arity_of_row(call));
  // geometry.area may be written with parentheses.
  if (call.operands.empty() && is_builtin(shape_values(), Target::kShape, call)) return;
  names.fail(call.position, "nothing defines the function '" + call.text + "'");
}

// `text` holds the names of the locals, each followed by a semicolon.
void resolve_with(Resolver& names, Expression& with) {
  const std::size_t outer = names.locals.size();
  with.index = static_cast<std::uint32_t>(outer);
  std::size_t from = 0;
  for (Expression& operand : with.operands) {
    resolve(names, operand);
    const std::size_t end = with.text.find(';', from);
    if (end == std::string::npos) break;
    names.locals.push_back(with.text.substr(from, end - from));
    from = end + 1;
  }
  names.locals.resize(outer);
}

void resolve(Resolver& names, Expression& expression) {
  if (is_share(expression)) names.fail(expression.position, "a share ' of the scope's size cannot stand here");
  switch (expression.kind) {
    case ExpressionKind::kLiteral:
      return;
    case ExpressionKind::kName:
      return resolve_name(names, expression);
    case ExpressionKind::kCall:
      return resolve_call(names, expression);
    case ExpressionKind::kWithLocals:
      return resolve_with(names, expression);
    default:
      for (Expression& operand : expression.operands) resolve(names, operand);
  }
}

const char* word_for(char letter) {
  constexpr std::pair<char, const char*> kWords[] = {
      {'n', "number"}, {'m', "size"}, {'s', "string"}, {'w', "word"}, {'a', "name"}};
  const auto found = std::ranges::find(kWords, letter, &std::pair<char, const char*>::first);
  return found == std::end(kWords) ? "value" : found->second;
}

std::string calls_of(const OperationRow& row) {
  std::string calls;
  for (const std::string& signature : signatures_of(row)) {
    std::string inside;
    for (const char letter : signature) inside += (inside.empty() ? "" : ", ") + std::string(word_for(letter));
    calls += (calls.empty() ? "" : " or ") + std::string(row.name) + "(" + inside + ")";
  }
  return calls;
}

// The first argument of set(): an attribute or a material value.
void resolve_settable(Resolver& names, Expression& name) {
  if (name.kind != ExpressionKind::kName)
    return names.fail(name.position, "expected the name of an attribute or material value");
  name.target = Target::kWord;
  name.index = ~0u;
  if (is_material_value(name.text)) return;
  const auto found = names.program.attribute_of.find(names.prefix + name.text);
  if (found == names.program.attribute_of.end())
    return names.fail(name.position, "expected an attribute or material value, found '" + name.text + "'");
  if (names.program.attributes[found->second].is_const)
    return names.fail(name.position, "'" + name.text + "' is a constant; only attributes can be set");
  names.program.attributes[found->second].is_set = true;
  name.index = found->second;
}

void resolve_arguments(Resolver& names, Statement& statement, const std::string& signature) {
  for (std::size_t i = 0; i < statement.arguments.size(); ++i) {
    const char letter = i < signature.size() ? signature[i] : 'v';
    if (letter == 'w') {
      statement.arguments[i].target = Target::kWord;
    } else if (letter == 'a') {
      resolve_settable(names, statement.arguments[i]);
    } else {
      const bool share = is_share(statement.arguments[i]);
      resolve(names, share ? statement.arguments[i].operands[0] : statement.arguments[i]);
    }
  }
}

void resolve_selectors(Resolver& names, std::vector<Selector>& selectors, SelectorKind kind) {
  for (Selector& selector : selectors) {
    if (selector.size == SizeKind::kRepeat) {
      if (kind != SelectorKind::kSizes) names.fail(selector.position, "expected a component, found a repeated group");
      resolve_selectors(names, selector.nested, kind);
      continue;
    }
    const bool is_word = kind == SelectorKind::kParts && selector.key.kind == ExpressionKind::kName;
    if (is_word) {
      selector.key.target = Target::kWord;
    } else {
      resolve(names, selector.key);
    }
    resolve(names, selector.body);
  }
}

void check_selectors(Resolver& names, const Statement& statement, const OperationRow& row) {
  const bool wants = row.selectors != SelectorKind::kNone;
  if (statement.has_selectors == wants) return;
  names.fail(statement.position, wants ? "expected '{' with selectors behind '" + statement.name + "'"
                                       : "'" + statement.name + "' takes no selectors");
}

void resolve_operation(Resolver& names, Statement& statement, int row_index) {
  const OperationRow& row = operation_table()[static_cast<std::size_t>(row_index)];
  statement.kind = StatementKind::kOperation;
  statement.index = static_cast<std::uint32_t>(row_index);
  const std::optional<std::string> signature = fitting_signature(row, statement.arguments);
  if (!signature) {
    const std::string words = *row.words ? "; words:" + std::string(row.words) : "";
    return names.fail(statement.position, "expected " + calls_of(row) + words);
  }
  check_selectors(names, statement, row);
  resolve_arguments(names, statement, *signature);
  resolve_selectors(names, statement.selectors, row.selectors);
}

void resolve_successor(Resolver& names, Statement& statement) {
  statement.kind = StatementKind::kSuccessor;
  for (Expression& argument : statement.arguments) resolve(names, argument);
  if (statement.has_selectors)
    return names.fail(statement.position, "there is no operation '" + statement.name + "' with selectors");
  const auto found = names.program.rule_of.find(names.prefix + statement.name);
  if (found == names.program.rule_of.end()) {
    if (statement.has_arguments)
      names.fail(statement.position, "there is no operation or rule '" + statement.name + "'");
    return;
  }
  statement.index = found->second;
  const std::size_t wants = names.program.rules[found->second].parameters.size();
  if (wants != statement.arguments.size())
    names.fail(statement.position, "expected " + counted(wants) + " of the rule '" + statement.name + "', found " +
                                       std::to_string(statement.arguments.size()));
}

void resolve(Resolver& names, Statement& statement) {
  if (statement.kind == StatementKind::kPush || statement.kind == StatementKind::kPop) return;
  if (statement.kind == StatementKind::kBlock) return resolve(names, statement.block.front());
  const bool is_rule = names.program.rule_of.contains(names.prefix + statement.name);
  const int row = is_rule ? -1 : operation_of(statement.name);
  if (row >= 0) return resolve_operation(names, statement, row);
  resolve_successor(names, statement);
}

void resolve(Resolver& names, Body& body) {
  body.number = names.program.bodies++;
  const std::size_t outer = names.locals.size();
  for (Local& local : body.locals) {
    resolve(names, local.value);
    local.slot = static_cast<std::uint32_t>(names.locals.size());
    names.locals.push_back(local.name);
  }
  for (Statement& statement : body.statements) resolve(names, statement);
  for (Branch& branch : body.branches) {
    if (!branch.is_else) resolve(names, branch.test);
    resolve(names, branch.body);
  }
  names.locals.resize(outer);
}

// The prefix of a name: "window." for "window.Frame", "" for "Frame".
std::string prefix_of(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? "" : name.substr(0, dot + 1);
}

Resolver resolver_for(Program& program, const std::string& name, const std::vector<Local>& parameters) {
  Resolver names{program, prefix_of(name)};
  for (const Local& parameter : parameters) names.locals.push_back(parameter.name);
  return names;
}

}  // namespace

std::optional<Error> resolve(Program& program) {
  for (Attribute& attribute : program.attributes) {
    Resolver names = resolver_for(program, attribute.name, {});
    resolve(names, attribute.value);
    if (names.failed) return names.failed;
  }
  for (Function& function : program.functions) {
    Resolver names = resolver_for(program, function.name, function.parameters);
    resolve(names, function.value);
    if (names.failed) return names.failed;
  }
  for (Rule& rule : program.rules) {
    Resolver names = resolver_for(program, rule.name, rule.parameters);
    names.within = " (in rule " + rule.name + ")";
    resolve(names, rule.body);
    if (names.failed) return names.failed;
  }
  return {};
}

}  // namespace citykiln::grammars
