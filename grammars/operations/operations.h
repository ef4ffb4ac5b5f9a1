// Declares the functions of the operations, one for each row of language/operations.inc, which describes them.
#pragma once

#include "grammars/derivation/execution.h"
#include "grammars/language/operation_table.h"

namespace citykiln::grammars {

#define OPERATION(name, function, signatures, words, selectors, alters, bound, text) \
  void function(Execution& execution, const Statement& statement, Arguments arguments);
#include "grammars/language/operations.inc"
#undef OPERATION

/// The size below which sizes are treated as zero: they are invisible, and not safe to divide by.
inline constexpr double kSmallest_m = 1e-6;

/// Returns the word of an argument, or "" if it is not a word.
inline std::string_view word_of(const Argument& argument) {
  return argument.word ? std::string_view(argument.word->text) : std::string_view();
}
/// Returns the i-th argument in metres (or degrees); `otherwise` if there are fewer arguments.
inline double number_or(Arguments arguments, std::size_t i, double otherwise) {
  return i < arguments.size() ? metres(arguments[i]) : otherwise;
}
/// Returns the argument in metres; a relative one is a share of `size_m`.
inline double size_or_share(const Argument& argument, double size_m) {
  return argument.relative ? metres(argument) * size_m : metres(argument);
}

}  // namespace citykiln::grammars
