// The built-in functions and shape values of expressions, by name.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace citykiln::grammars {

/// What the value of a built-in function depends on.
enum class FunctionKind : std::uint8_t {
  kPure,         ///< Its arguments alone.
  kUniformDraw,  ///< A uniform random number between bounds given by its arguments.
  kDraw,         ///< A random number.
  kSurroundings  ///< What stands near the shape.
};

/// What a shape value depends on: the shape alone, its position, or its place in a split or comp.
enum class DependsOn : std::uint8_t { kShape, kPosition, kSplit, kComp };

struct BuiltinRow {
  const char* name;
  const char* arguments;  ///< As in functions.inc; "" for shape values.
  FunctionKind kind;      ///< kPure for shape values.
  const char* text;
};

std::span<const BuiltinRow> builtin_functions();
std::span<const BuiltinRow> shape_values();
/// The index of the row of this name, or -1.
int row_of(std::span<const BuiltinRow> rows, std::string_view name);
/// True if `name` is a value of the material: material.name, material.color.r …
bool is_material_value(std::string_view name);

/// The least and the greatest number of arguments.
struct Arity {
  std::size_t least = 0, most = 0;
};
/// @param arguments  As in functions.inc.
Arity arity_of(std::string_view arguments);

}  // namespace citykiln::grammars
