// Evaluates expressions of CGA rules for a shape: attributes, conditions, random choices. A slot is the place of a
// parameter or local of a rule.
#pragma once

#include "grammars/derivation/execution.h"

namespace citykiln::grammars {

/// The state that an expression reads and changes: the derivation, its shape, the values of parameters and locals, and
/// the source of random numbers.
struct Context {
  Run& run;
  const Shape& shape;
  Slots& slots;
  RandomSource& random;
  int depth = 0;  ///< The depth of nested expressions, including calls of functions.
};

/// Returns the context of a node that is being derived. The context refers to `execution`.
inline Context context_of(Execution& execution) {
  return {execution.run, execution.shape, execution.slots, execution.random};
}

/// Returns the value of an expression. Converts a value of the wrong kind, with a warning. Division by zero gives 0 and
/// overflow the largest double, with a warning. Expressions nested deeper than kMostDepth, as in functions that call
/// themselves, give 0.
Value evaluate(const Expression& expression, Context& context);

/// The greatest depth of nested expressions. Functions of usual size may call themselves a hundred times, within 1 MB
/// of stack.
inline constexpr int kMostDepth = 600;

/// Returns the value of an attribute or constant for this shape.
/// @param attribute  An index into Program::attributes.
Value attribute_value(std::uint32_t attribute, Context& context);

/// Draws a random number, uniform in [0, 1), from the context's source.
double draw_unit(Context& context);

/// Returns the index in Body::branches of the branch that a case or a list of percentages selects; -1 for none.
/// @param body  A body of kind kCase or kChance.
int chosen_branch(const Body& body, Context& context);

}  // namespace citykiln::grammars
