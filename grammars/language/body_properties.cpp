#include "grammars/language/body_properties.h"

#include <algorithm>

#include "grammars/operations/table.h"

namespace citykiln::grammars {
namespace {

bool any_has(const std::vector<Selector>& selectors, bool Body::*mark) {
  return std::ranges::any_of(
      selectors, [&](const Selector& selector) { return selector.body.*mark || any_has(selector.nested, mark); });
}

// a body that the statement may come to has the mark
bool comes_to(const Program& program, const Statement& statement, bool Body::*mark) {
  if (any_has(statement.selectors, mark)) return true;
  if (statement.kind == StatementKind::kBlock) return statement.block.front().*mark;
  return statement.kind == StatementKind::kSuccessor && statement.index != ~0u &&
         program.rules[statement.index].body.*mark;
}

bool changes_appearance(const Statement& statement) {
  if (statement.kind != StatementKind::kOperation) return false;
  return statement.name == "set" || operation_table()[statement.index].alters == Alters::kLook;
}

// nested selectors are of splits, which have sizes
bool depends_on_street(const Statement& statement) {
  return std::ranges::any_of(statement.selectors,
                             [](const Selector& selector) { return selector.key.text.starts_with("street"); });
}

// the body has the mark if a statement itself `has` it, or something that it may come to
bool may(const Program& program, const Body& body, bool Body::*mark, bool (*has)(const Statement&)) {
  return std::ranges::any_of(body.statements,
                             [&](const Statement& s) { return has(s) || comes_to(program, s, mark); }) ||
         std::ranges::any_of(body.branches, [&](const Branch& branch) { return branch.body.*mark; });
}

bool divides(const Body& body) {
  return std::ranges::any_of(body.statements, &Statement::has_selectors) ||
         std::ranges::any_of(body.branches, [](const Branch& branch) { return branch.body.divides; });
}

// slots beyond share the last bit
std::uint64_t bit_of(std::size_t slot) { return std::uint64_t{1} << std::min<std::size_t>(slot, 63); }

std::uint64_t locals_in(const Expression& expression) {
  std::uint64_t slots = expression.target == Target::kLocal ? bit_of(expression.index) : 0;
  for (const Expression& operand : expression.operands) slots |= locals_in(operand);
  return slots;
}

std::uint64_t locals_in(const std::vector<Expression>& expressions) {
  std::uint64_t slots = 0;
  for (const Expression& expression : expressions) slots |= locals_in(expression);
  return slots;
}

// sizes and keys divide a surface, but do not move it
std::uint64_t displacement_slots(const std::vector<Selector>& selectors) {
  std::uint64_t slots = 0;
  for (const Selector& selector : selectors)
    slots |= displacement_slots(selector.nested) | selector.body.displacement_slots;
  return slots;
}

std::uint64_t displacement_slots(const Program& program, const Statement& statement) {
  std::uint64_t slots = displacement_slots(statement.selectors);
  for (const Body& block : statement.block) slots |= block.displacement_slots;
  if (statement.kind == StatementKind::kOperation) {
    const bool moves = operation_table()[statement.index].alters != Alters::kLook;
    return moves ? slots | locals_in(statement.arguments) : slots;
  }
  if (statement.kind != StatementKind::kSuccessor || statement.index == ~0u) return slots;
  const std::uint64_t asked = program.rules[statement.index].body.displacement_slots;
  for (std::size_t i = 0; i < statement.arguments.size(); ++i)
    if ((asked & bit_of(i)) != 0) slots |= locals_in(statement.arguments[i]);
  return slots;
}

std::uint64_t displacement_slots(const Program& program, const Body& body) {
  std::uint64_t slots = 0;
  for (const Local& local : body.locals) slots |= locals_in(local.value);
  for (const Statement& statement : body.statements) slots |= displacement_slots(program, statement);
  for (const Branch& branch : body.branches) slots |= locals_in(branch.test) | branch.body.displacement_slots;
  return slots;
}

// Inner bodies first; true if anything was found that was not known.
bool mark(const Program& program, Body& body);

bool mark(const Program& program, std::vector<Selector>& selectors) {
  bool found = false;
  for (Selector& selector : selectors) {
    found |= mark(program, selector.nested);
    found |= mark(program, selector.body);
  }
  return found;
}

bool mark(const Program& program, Body& body) {
  bool found = false;
  for (Branch& branch : body.branches) found |= mark(program, branch.body);
  for (Statement& statement : body.statements) {
    found |= mark(program, statement.selectors);
    for (Body& block : statement.block) found |= mark(program, block);
  }
  const auto keep = [&](auto& mark, auto now) {
    found |= mark != now;
    mark = now;
  };
  body.divides = divides(body);
  keep(body.changes_appearance, may(program, body, &Body::changes_appearance, changes_appearance));
  keep(body.depends_on_street, may(program, body, &Body::depends_on_street, depends_on_street));
  keep(body.displacement_slots, displacement_slots(program, body));
  return found;
}

}  // namespace

void analyse_bodies(Program& program) {
  // until nothing is found any more; what goes round in circles changes nothing by that
  for (bool found = true; found;) {
    found = false;
    for (Rule& rule : program.rules) found |= mark(program, rule.body);
  }
}

const std::string* terminal_of(const Body& body) {
  if (body.kind != BodyKind::kStatements || body.statements.size() != 1 || !body.locals.empty()) return nullptr;
  const Statement& only = body.statements.front();
  const bool is_terminal = only.kind == StatementKind::kSuccessor && only.index == ~0u && only.arguments.empty();
  return is_terminal ? &only.name : nullptr;
}

}  // namespace citykiln::grammars
