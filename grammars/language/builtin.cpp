#include "grammars/language/builtin.h"

namespace citykiln::grammars {
namespace {

constexpr BuiltinRow kFunctions[] = {
#define FUNCTION(name, arguments, computes, text) {name, arguments, text},
#include "grammars/language/functions.inc"
#undef FUNCTION
};

constexpr BuiltinRow kShapeValues[] = {
#define SHAPE_VALUE(name, told_of, computes, text) {name, "", text},
#include "grammars/language/shape_values.inc"
#undef SHAPE_VALUE
};

constexpr const char* kLookValues[] = {
#define MATERIAL_TEXT(name, member) name,
#define MATERIAL_NUMBER(name, member) name,
#include "grammars/language/material_values.inc"
#undef MATERIAL_TEXT
#undef MATERIAL_NUMBER
};

}  // namespace

std::span<const BuiltinRow> builtin_functions() { return kFunctions; }
std::span<const BuiltinRow> shape_values() { return kShapeValues; }

int row_of(std::span<const BuiltinRow> rows, std::string_view name) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (name == rows[i].name) return static_cast<int>(i);
  return -1;
}

bool is_look_value(std::string_view name) {
  for (const char* known : kLookValues)
    if (name == known) return true;
  return false;
}

Arity arity_of(std::string_view arguments) {
  const std::size_t slash = arguments.find('/');
  if (slash == std::string_view::npos) return {arguments.size(), arguments.size()};
  return {slash, arguments.size() - 1};
}

}  // namespace citykiln::grammars
