// One function an operation; what each does is told in operations.inc.
#pragma once

#include <span>

#include "grammars/derivation/run.h"
#include "grammars/operations/table.h"

namespace citykiln::grammars {

using Arguments = std::span<const Argument>;

#define OPERATION(name, function, signatures, words, selectors, alters, text) \
  void function(Execution& execution, const Statement& statement, Arguments arguments);
#include "grammars/operations/operations.inc"
#undef OPERATION

/// Less than this is not built: neither seen nor safe to divide by.
inline constexpr double kSmallest_m = 1e-6;

/// The word of an argument, or "" if it is none.
inline std::string_view word_of(const Argument& argument) {
  return argument.word ? std::string_view(argument.word->text) : std::string_view();
}
/// The i-th argument in metres (or degrees); `otherwise` where there are fewer.
inline double number_or(Arguments arguments, std::size_t i, double otherwise) {
  return i < arguments.size() ? metres(arguments[i]) : otherwise;
}

}  // namespace citykiln::grammars
