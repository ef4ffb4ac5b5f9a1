#include "grammars/language/constant.h"

#include <algorithm>

#include "grammars/operations/table.h"

namespace citykiln::grammars {
namespace {

constexpr const char* kOfShapesOrDice = " rand p inside overlaps touches has_entrance ";

bool is_constant(const Program& program, const Expression& expression);

bool is_constant_name(const Program& program, const Expression& name) {
  switch (name.target) {
    case Target::kAttribute:
      return !program.attributes[name.index].is_set;
    case Target::kFunction:
      return program.functions[name.index].is_constant;
    case Target::kBuiltin:
      return !is_among(name.text, kOfShapesOrDice);
    default:
      return false;
  }
}

bool is_constant(const Program& program, const Expression& expression) {
  const auto all = [&] {
    return std::all_of(expression.operands.begin(), expression.operands.end(),
                       [&](const Expression& operand) { return is_constant(program, operand); });
  };
  switch (expression.kind) {
    case ExpressionKind::kLiteral:
      return true;
    case ExpressionKind::kName:
    case ExpressionKind::kCall:
      return is_constant_name(program, expression) && all();
    case ExpressionKind::kUnary:
    case ExpressionKind::kBinary:
    case ExpressionKind::kCase:
      return all();
    default:
      return false;
  }
}

}  // namespace

void mark_constants(Program& program) {
  // until nothing is found any more; what goes round in circles never is
  for (bool found = true; found;) {
    found = false;
    for (Function& function : program.functions) {
      if (function.is_constant || !function.parameters.empty() || !is_constant(program, function.value)) continue;
      function.is_constant = found = true;
    }
  }
}

}  // namespace citykiln::grammars
