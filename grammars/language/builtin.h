// The built-in functions and shape values of expressions, by name.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace citykiln::grammars {

/// The kind of a built-in function, by the data on which its value depends.
enum class FunctionKind : std::uint8_t {
  kPure,         ///< Depends on its arguments only.
  kUniformDraw,  ///< A uniform random number between bounds given by its arguments.
  kDraw,         ///< A random number.
  kSurroundings  ///< A query about the surroundings of the shape (derivation/context_query.h).
};

/// The data on which a shape value depends: the shape alone, its position, or its number in a split or comp.
enum class DependsOn : std::uint8_t { kShape, kPosition, kSplit, kComp };

/// A row of functions.inc or shape_values.inc.
struct BuiltinRow {
  const char* name;
  const char* arguments;  ///< The column of functions.inc; "" for shape values.
  FunctionKind kind;      ///< kPure for shape values.
  const char* text;       ///< One line of documentation.
};

std::span<const BuiltinRow> builtin_functions();
std::span<const BuiltinRow> shape_values();
/// Returns the index of the row of this name, or -1.
int row_of(std::span<const BuiltinRow> rows, std::string_view name);
/// True if `name` is a value of the material: material.name, material.color.r …
bool is_material_value(std::string_view name);

/// The least and the greatest number of arguments.
struct Arity {
  std::size_t least = 0, most = 0;
};
/// Returns the arity of a function.
/// @param arguments  BuiltinRow::arguments.
Arity arity_of(std::string_view arguments);

}  // namespace citykiln::grammars
