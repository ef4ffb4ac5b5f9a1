// The table of operations: names, arguments, selectors; what CGA calls shape operations.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grammars/language/syntax.h"

namespace citykiln::grammars {

struct Execution;
struct Argument;

enum class SelectorKind : std::uint8_t { kNone, kSizes, kParts };

/// What an operation changes of the current shape. Where it changes anything, the shape needs a successor or is a
/// terminal.
enum class Alters : std::uint8_t {
  kNothing,
  kLook,
  kFrame,  ///< The scope's axes or the faces' sides; the surface stays where it is.
  kSurface
};

struct OperationRow {
  const char* name;
  /// Ways to call it, between |: a letter an argument. n number, m number or, with ' before it, a share of the scope's
  /// size, s string, v any value, w one of `words`, a the name of an attribute or material value.
  const char* signatures;
  const char* words;  ///< Between blanks.
  SelectorKind selectors;
  Alters alters;
  void (*run)(Execution&, const Statement&, std::span<const Argument>);
  const char* text;  ///< For README.
};

/// '0.5: of the scope's size.
inline bool is_share(const Expression& e) { return e.kind == ExpressionKind::kUnary && e.text == "'"; }

std::span<const OperationRow> operation_table();
/// The row of this name, or -1.
int operation_of(const std::string& name);

/// True if `word` is one of `words`, which stand between blanks.
bool is_among(std::string_view word, std::string_view words);
/// The first signature that these arguments fit: their number, and words where words are asked for.
std::string fitting_signature(const OperationRow& row, std::span<const Expression> arguments, bool& found);

}  // namespace citykiln::grammars
