#include "grammars/body_marks.h"

#include <algorithm>

#include "grammars/operations/table.h"

namespace citykiln::grammars {
namespace {

bool changes_look(const Program& program, const Statement& statement);

bool any_changes_look(const Program& program, const std::vector<Selector>& selectors) {
  return std::ranges::any_of(selectors, [&](const Selector& selector) {
    return selector.body.changes_look || any_changes_look(program, selector.nested);
  });
}

bool changes_look(const Program& program, const Statement& statement) {
  if (any_changes_look(program, statement.selectors)) return true;
  if (statement.kind == StatementKind::kBlock) return statement.block.front().changes_look;
  if (statement.kind == StatementKind::kSuccessor)
    return statement.index != ~0u && program.rules[statement.index].body.changes_look;
  if (statement.kind != StatementKind::kOperation) return false;
  return statement.name == "set" || operation_table()[statement.index].alters == Alters::kLook;
}

bool changes_look(const Program& program, const Body& body) {
  return std::ranges::any_of(body.statements, [&](const Statement& s) { return changes_look(program, s); }) ||
         std::ranges::any_of(body.branches, [](const Branch& branch) { return branch.body.changes_look; });
}

bool divides(const Body& body) {
  return std::ranges::any_of(body.statements, &Statement::has_selectors) ||
         std::ranges::any_of(body.branches, [](const Branch& branch) { return branch.body.divides; });
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
  body.divides = divides(body);
  const bool changes = changes_look(program, body);
  found |= changes != body.changes_look;
  body.changes_look = changes;
  return found;
}

}  // namespace

void mark_bodies(Program& program) {
  // until nothing is found any more; what goes round in circles changes nothing by that
  for (bool found = true; found;) {
    found = false;
    for (Rule& rule : program.rules) found |= mark(program, rule.body);
  }
}

}  // namespace citykiln::grammars
