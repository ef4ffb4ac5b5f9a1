// The state of the .lsys reader: position, first error, and the part of the L-system that is read already. An error
// moves the position to the end of the text, so that all functions in progress return. A slot is the place of a
// parameter of the current rule.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/contract/result.h"
#include "lsystems/lsystem.h"

namespace citykiln::lsystems {

/// Returns a position as "file:line:column".
std::string position_name(std::string_view file, TextPosition place);

/// The state of the reader.
struct Reader {
  std::string_view text;  ///< Comments are replaced by spaces.
  std::string file;
  std::size_t at = 0, end = 0;  ///< The position, and the end of the current statement.
  std::vector<std::size_t> line_starts;
  std::optional<Error> failed;

  LSystem system;
  std::map<std::pair<std::string, int>, Kind> kind_of;
  std::map<std::string, double, std::less<>> constants;  ///< The values of #define.
  std::map<std::string, double, std::less<>> given;      ///< The caller's values, which replace constants.
  std::vector<std::string> long_names;                   ///< The names declared by `module`, longest first.
  std::vector<std::string> slots;                        ///< The parameters of the current rule.
  int depth = 0;                                         ///< The depth of nested parentheses.
  int draws = 0;                                         ///< The number of random draws in the current rule.
  bool may_draw = false;                                 ///< Random draws are allowed.
  bool may_query = true;                                 ///< Queries are allowed: everywhere but in interpretations.

  char peek(std::size_t ahead = 0) const { return at + ahead < end ? text[at + ahead] : '\0'; }
  bool starts_with(std::string_view word) const { return text.substr(at, end - at).substr(0, word.size()) == word; }
  bool done() const { return at >= end; }
  void skip_space();
  /// Skips space, and the word if it is next. Returns true if the word was next.
  bool accept(std::string_view word);
  /// Skips the word and returns true, or fails with "expected 'word' why, found …".
  bool expect(std::string_view word, std::string_view why);

  TextPosition place() const { return position_at(at); }
  TextPosition position_at(std::size_t byte) const;
  /// Fails here with "expected `what`, found …". Keeps the first error.
  void fail_expected(std::string_view what);
  void fail(TextPosition where, std::string message);
};

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
inline bool is_name_letter(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

/// Skips space and a name, and returns it; "" if there is none.
std::string take_name(Reader& reader);
/// True if -> or --> is next.
bool at_arrow(const Reader& reader);

/// Reads an expression of parameters, constants, numbers and functions.
Value read_value(Reader& reader);
/// Reads a constant expression.
double read_constant(Reader& reader, std::string_view what);

/// Reads modules with parameter expressions, up to a position where no module begins.
Successor read_successor(Reader& reader);
/// Reads modules with parameter names, which become slots.
std::vector<Kind> read_pattern(Reader& reader);
/// Skips space and a module's name, and returns it; "" if there is none.
std::string take_module_name(Reader& reader);
/// Returns the kind of a name and arity, and adds it if it is new.
Kind kind_named(Reader& reader, const std::string& name, std::size_t arity);

/// Reads a production and appends it to `set`.
void read_rule(Reader& reader, RuleSet& set, bool contexts_allowed);

}  // namespace citykiln::lsystems
