// Evaluates expressions for a shape.
#pragma once

#include "grammars/derivation/run.h"

namespace citykiln::grammars {

struct Context {
  Run& run;
  const Shape& shape;
  Slots& slots;
  RandomSource& random;
  int depth = 0;  ///< Nested expressions, through functions too.
};

inline Context context_of(Execution& execution) {
  return {execution.run, execution.shape, execution.slots, execution.random};
}

/// The value of an expression. A value of the wrong kind is converted with a warning. Division by zero gives 0 and
/// overflow the largest double, with a warning. Expressions nested deeper than kMostDepth, as in functions that call
/// themselves, give 0.
Value evaluate(const Expression& expression, Context& context);

/// The greatest depth of nested expressions: functions of usual size may call themselves a hundred times, within 1 MB
/// of stack.
inline constexpr int kMostDepth = 600;

/// The value of an attribute or constant for this shape.
/// @param attribute  Index into Program::attributes.
Value attribute_value(std::uint32_t attribute, Context& context);

/// A random number, uniform in [0, 1).
double draw_unit(Context& context);

/// The branch that a case or a list of percentages selects; -1 for none.
/// @param body  Of kind kCase or kChance.
int chosen_branch(const Body& body, Context& context);

}  // namespace citykiln::grammars
