#include "grammars/language/constant.h"

#include <algorithm>

#include "grammars/language/builtin.h"

namespace citykiln::grammars {
namespace {

bool is_constant_name(const Program& program, const Expression& name) {
  switch (name.target) {
    case Target::kAttribute:
      return !program.attributes[name.index].is_set;
    case Target::kFunction:
      return program.functions[name.index].is_constant;
    case Target::kBuiltin:
      return builtin_functions()[name.index].kind == FunctionKind::kPure;
    default:
      return false;
  }
}

bool is_constant(const Program& program, const Expression& expression) {
  switch (expression.kind) {
    case ExpressionKind::kName:
    case ExpressionKind::kCall:
      if (!is_constant_name(program, expression)) return false;
      break;
    case ExpressionKind::kChance:
    case ExpressionKind::kWithLocals:
      return false;
    default:
      break;
  }
  return std::ranges::all_of(expression.operands, [&](const Expression& e) { return is_constant(program, e); });
}

}  // namespace

void mark_constants(Program& program) {
  for (bool changed = true; changed;) {
    changed = false;
    for (Function& function : program.functions) {
      if (function.is_constant || !function.parameters.empty() || !is_constant(program, function.value)) continue;
      function.is_constant = changed = true;
    }
  }
}

}  // namespace citykiln::grammars
