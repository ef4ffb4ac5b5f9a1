// The functions and shape values that expressions know, by name.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace citykiln::grammars {

struct BuiltinRow {
  const char* name;
  const char* arguments;  ///< As in functions.inc; unused for shape values.
  const char* text;
};

/// What a shape value tells of: the shape itself, the place where it stands, or what a split or comp gave it.
enum class DependsOn : std::uint8_t { kItself, kPlace, kSplit, kComp };

std::span<const BuiltinRow> builtin_functions();
std::span<const BuiltinRow> shape_values();
/// The row of this name, or -1.
int row_of(std::span<const BuiltinRow> rows, std::string_view name);
/// True if `name` is a value of the material: material.name, material.color.r …
bool is_look_value(std::string_view name);

/// How many arguments `arguments` asks for at least, and at most.
struct Arity {
  std::size_t least = 0, most = 0;
};
Arity arity_of(std::string_view arguments);

}  // namespace citykiln::grammars
