#include "grammars/language/builtin.h"

#include <algorithm>

namespace citykiln::grammars {
namespace {

constexpr BuiltinRow kBuiltinFunctions[] = {
#define FUNCTION(name, arguments, kind, computes, text) {name, arguments, kind, text},
#include "grammars/language/functions.inc"
#undef FUNCTION
};

constexpr BuiltinRow kShapeValues[] = {
#define SHAPE_VALUE(name, depends_on, computes, text) {name, "", FunctionKind::kPure, text},
#include "grammars/language/shape_values.inc"
#undef SHAPE_VALUE
};

constexpr std::string_view kMaterialValues[] = {
#define MATERIAL_TEXT(name, member) name,
#define MATERIAL_NUMBER(name, member) name,
#include "grammars/language/material_values.inc"
#undef MATERIAL_TEXT
#undef MATERIAL_NUMBER
};

}  // namespace

std::span<const BuiltinRow> builtin_functions() { return kBuiltinFunctions; }
std::span<const BuiltinRow> shape_values() { return kShapeValues; }

int row_of(std::span<const BuiltinRow> rows, std::string_view name) {
  const auto row = std::ranges::find(rows, name, &BuiltinRow::name);
  return row == rows.end() ? -1 : static_cast<int>(row - rows.begin());
}

bool is_material_value(std::string_view name) {
  return std::ranges::find(kMaterialValues, name) != std::end(kMaterialValues);
}

Arity arity_of(std::string_view arguments) {
  const std::size_t slash = arguments.find('/');
  if (slash == std::string_view::npos) return {arguments.size(), arguments.size()};
  return {slash, arguments.size() - 1};
}

}  // namespace citykiln::grammars
