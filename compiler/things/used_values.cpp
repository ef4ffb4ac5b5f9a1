#include "compiler/things/used_values.h"

#include <vector>

#include "grammars/language/builtin.h"

namespace citykiln::things {
namespace {

using namespace grammars;

// Visits each rule, function and attribute once.
class ValueFinder {
 public:
  explicit ValueFinder(const Program& program)
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
    const Attribute& read = program_.attributes[attribute];
    if (!read.is_const) found.attributes.insert(read.name);
    visit(read.value);
  }

  void visit(const Expression& expression) {
    if (expression.target == Target::kAttribute) visit_attribute(expression.index);
    if (expression.target == Target::kFunction) visit_function(expression.index);
    if (expression.target == Target::kBuiltin) found.draws |= is_draw(expression.index);
    found.draws |= expression.kind == ExpressionKind::kChance;
    for (const Expression& operand : expression.operands) visit(operand);
  }

  static bool is_draw(std::uint32_t function) {
    const FunctionKind kind = builtin_functions()[function].kind;
    return kind == FunctionKind::kDraw || kind == FunctionKind::kUniformDraw;
  }

  void visit(const Selector& selector) {
    visit(selector.key);
    for (const Selector& nested : selector.nested) visit(nested);
    visit(selector.body);
  }

  void visit(const Statement& statement) {
    for (const Expression& argument : statement.arguments) visit(argument);
    for (const Selector& selector : statement.selectors) visit(selector);
    for (const Body& block : statement.block) visit(block);
    if (statement.kind == StatementKind::kSuccessor && statement.index != ~0u) visit_rule(statement.index);
  }

  void visit(const Body& body) {
    found.draws |= body.kind == BodyKind::kChance;
    for (const Local& local : body.locals) visit(local.value);
    for (const Statement& statement : body.statements) visit(statement);
    for (const Branch& branch : body.branches) visit(branch.test), visit(branch.body);
  }

  const Program& program_;
  std::vector<bool> attributes_, functions_, rules_;
};

}  // namespace

UsedValues used_values(const Program& program, const std::string& start) {
  ValueFinder finder(program);
  if (const auto rule = program.rule_of.find(start); rule != program.rule_of.end()) finder.visit_rule(rule->second);
  return std::move(finder.found);
}

}  // namespace citykiln::things
