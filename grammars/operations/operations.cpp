#include "grammars/operations/operations.h"

#include <cassert>
#include <iterator>

namespace citykiln::grammars {
namespace {

constexpr OperationFunction kOperationFunctions[] = {
#define OPERATION(name, function, signatures, words, selectors, alters, bound, text) function,
#include "grammars/language/operations.inc"
#undef OPERATION
};

}  // namespace

OperationFunction operation_function(std::uint32_t row) {
  assert(row < std::size(kOperationFunctions));
  return kOperationFunctions[row];
}

}  // namespace citykiln::grammars
