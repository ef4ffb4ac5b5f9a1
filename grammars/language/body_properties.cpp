#include "grammars/language/body_properties.h"

#include <algorithm>
#include <utility>

#include "grammars/language/operation_table.h"

namespace citykiln::grammars {
namespace {

using Property = bool Body::*;

bool any_has(const std::vector<Selector>& selectors, Property property) {
  return std::ranges::any_of(selectors, [&](const Selector& selector) {
    return selector.body.*property || any_has(selector.nested, property);
  });
}

// True if a body that the statement leads to has the property.
bool leads_to(const Program& program, const Statement& statement, Property property) {
  if (any_has(statement.selectors, property)) return true;
  if (statement.kind == StatementKind::kBlock) return statement.block.front().*property;
  return statement.kind == StatementKind::kSuccessor && statement.index != ~0u &&
         program.rules[statement.index].body.*property;
}

bool changes_appearance(const Statement& statement) {
  if (statement.kind != StatementKind::kOperation) return false;
  return statement.name == "set" || operation_table()[statement.index].alters == Alters::kAppearance;
}

// Nested selectors belong to splits, whose keys are sizes.
bool depends_on_street(const Statement& statement) {
  return std::ranges::any_of(statement.selectors,
                             [](const Selector& selector) { return selector.key.text.starts_with("street"); });
}

// True if one of the statements `has` the property, or leads to a body with it.
bool may(const Program& program, const Body& body, Property property, bool (*has)(const Statement&)) {
  return std::ranges::any_of(body.statements,
                             [&](const Statement& s) { return has(s) || leads_to(program, s, property); }) ||
         std::ranges::any_of(body.branches, [&](const Branch& branch) { return branch.body.*property; });
}

// A successor that ends here, or that leads to a body with the property.
bool keeps_surface(const Program& program, const Statement& statement) {
  if (statement.kind == StatementKind::kSuccessor && statement.index == ~0u) return statement.name != "NIL";
  return leads_to(program, statement, &Body::keeps_surface);
}

// Statements count up to the first that moves the surface or changes its appearance.
bool keeps_surface(const Program& program, const Body& body) {
  for (const Statement& statement : body.statements) {
    if (keeps_surface(program, statement)) return true;
    if (statement.kind == StatementKind::kOperation && !statement.has_selectors) return false;
  }
  return std::ranges::any_of(body.branches, [](const Branch& branch) { return branch.body.keeps_surface; });
}

bool divides(const Body& body) {
  return std::ranges::any_of(body.statements, &Statement::has_selectors) ||
         std::ranges::any_of(body.branches, [](const Branch& branch) { return branch.body.divides; });
}

// Slots from 63 on share the last bit.
std::uint64_t bit_of(std::size_t slot) { return std::uint64_t{1} << std::min<std::size_t>(slot, 63); }

std::uint64_t slots_in(const Expression& expression) {
  std::uint64_t slots = expression.target == Target::kLocal ? bit_of(expression.index) : 0;
  for (const Expression& operand : expression.operands) slots |= slots_in(operand);
  return slots;
}

std::uint64_t slots_in(const std::vector<Expression>& expressions) {
  std::uint64_t slots = 0;
  for (const Expression& expression : expressions) slots |= slots_in(expression);
  return slots;
}

// Sizes and keys divide a surface but do not move it.
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
    const bool moves = operation_table()[statement.index].alters != Alters::kAppearance;
    return moves ? slots | slots_in(statement.arguments) : slots;
  }
  if (statement.kind != StatementKind::kSuccessor || statement.index == ~0u) return slots;
  const std::uint64_t used = program.rules[statement.index].body.displacement_slots;
  for (std::size_t i = 0; i < statement.arguments.size(); ++i)
    if ((used & bit_of(i)) != 0) slots |= slots_in(statement.arguments[i]);
  return slots;
}

std::uint64_t displacement_slots(const Program& program, const Body& body) {
  std::uint64_t slots = 0;
  for (const Local& local : body.locals) slots |= slots_in(local.value);
  for (const Statement& statement : body.statements) slots |= displacement_slots(program, statement);
  for (const Branch& branch : body.branches) slots |= slots_in(branch.test) | branch.body.displacement_slots;
  return slots;
}

// One pass, inner bodies first. Returns true if a property has changed.
bool update(const Program& program, Body& body);

bool update(const Program& program, std::vector<Selector>& selectors) {
  bool changed = false;
  for (Selector& selector : selectors) {
    changed |= update(program, selector.nested);
    changed |= update(program, selector.body);
  }
  return changed;
}

bool update(const Program& program, Body& body) {
  bool changed = false;
  for (Branch& branch : body.branches) changed |= update(program, branch.body);
  for (Statement& statement : body.statements) {
    changed |= update(program, statement.selectors);
    for (Body& block : statement.block) changed |= update(program, block);
  }
  const auto set = [&](auto& property, auto value) { changed |= std::exchange(property, value) != value; };
  body.divides = divides(body);
  set(body.changes_appearance, may(program, body, &Body::changes_appearance, changes_appearance));
  set(body.depends_on_street, may(program, body, &Body::depends_on_street, depends_on_street));
  set(body.keeps_surface, keeps_surface(program, body));
  set(body.displacement_slots, displacement_slots(program, body));
  return changed;
}

}  // namespace

void analyse_bodies(Program& program) {
  for (bool changed = true; changed;) {
    changed = false;
    for (Rule& rule : program.rules) changed |= update(program, rule.body);
  }
}

const std::string* terminal_of(const Body& body) {
  if (body.kind != BodyKind::kStatements || body.statements.size() != 1 || !body.locals.empty()) return nullptr;
  const Statement& only = body.statements.front();
  const bool is_terminal = only.kind == StatementKind::kSuccessor && only.index == ~0u && only.arguments.empty();
  return is_terminal ? &only.name : nullptr;
}

}  // namespace citykiln::grammars
