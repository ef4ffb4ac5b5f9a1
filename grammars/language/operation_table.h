// The table of operations, which CGA calls shape operations: names, arguments, selectors and effects. The functions
// that implement them are in operations/.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grammars/language/syntax.h"

namespace citykiln::grammars {

/// The selectors { … } after an operation: none, sizes (as in split), parts (as in comp), or one body without a key (as
/// in scatter).
enum class SelectorKind : std::uint8_t { kNone, kSizes, kParts, kBody };

/// The part of the current shape that an operation changes. After any change the shape must be passed to a rule, or
/// becomes a terminal.
enum class Alters : std::uint8_t {
  kNothing,
  kAppearance,
  kFrame,  ///< The scope's axes or the orientation of faces, but not the surface.
  kSurface
};

/// The method by which displacement_bound.h bounds the distance that an operation moves a surface.
enum class BoundRule : std::uint8_t {
  kUnbounded,  ///< No bound is known.
  kFixed,      ///< The surface does not move.
  kFixedFace,  ///< A face does not move; no bound is known for a prism.
  kExtrude,
  kTranslate,
  kSplit,
  kComponents,
  kSetback
};

/// A row of operations.inc.
struct OperationRow {
  const char* name;
  /// The signatures, separated by |, with one letter for each argument: n number; m number or, after ', a share of the
  /// scope's size; s string; b bool; v any value; w one of `words`; a the name of an attribute or material value.
  const char* signatures;
  const char* words;  ///< Each word stands between blanks.
  SelectorKind selectors;
  Alters alters;
  BoundRule bound;
  const char* text;  ///< One line of documentation.
};

/// True for an expression such as '0.5, a share of the scope's size.
inline bool is_share(const Expression& e) { return e.kind == ExpressionKind::kUnary && e.op == Operator::kShare; }

/// True if the statement is set() of an attribute of the program rather than of a material value. Names must be
/// resolved.
bool sets_attribute(const Statement& statement);

/// Returns all rows; Statement::index is an index into them.
std::span<const OperationRow> operation_table();
/// Returns the index of the operation of this name, or -1.
int operation_of(const std::string& name);

/// True if `word` is one of `words`, each of which stands between blanks.
bool is_among(std::string_view word, std::string_view words);
/// Returns the signatures of a row, one string each.
std::vector<std::string> signatures_of(const OperationRow& row);
/// Returns the first signature that fits the number of arguments and their words; std::nullopt if none does.
std::optional<std::string> fitting_signature(const OperationRow& row, std::span<const Expression> arguments);

}  // namespace citykiln::grammars
