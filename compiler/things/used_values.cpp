#include "compiler/things/used_values.h"

#include <vector>

#include "grammars/language/builtin.h"

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

}  // namespace citykiln::things
