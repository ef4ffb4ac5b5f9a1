// What an expression is worth for a shape.
#pragma once

#include "grammars/derivation/run.h"

namespace citykiln::grammars {

struct Context {
  Run& run;
  const Shape& shape;
  Frame& frame;
  RandomSource& dice;
  int depth = 0;  ///< Expressions in each other, through functions too.
};

/// Total: a value of the wrong kind is a trouble and converted; division by zero and overflow are troubles and 0, or
/// the largest double; expressions deeper than kMostDepth in each other, as of functions that call themselves, are 0.
Value evaluate(const Expression& expression, Context& context);

/// Functions of usual size may call themselves a hundred times; all of it is under 1 MB of stack.
inline constexpr int kMostDepth = 600;

/// The value of an attribute or constant for this shape.
Value attribute_value(std::uint32_t attribute, Context& context);

/// Uniform in [0, 1).
double draw_unit(Context& context);

/// Which branch of a case or of p% shares to take; -1 for none.
int chosen_branch(const Body& body, Context& context);

}  // namespace citykiln::grammars
