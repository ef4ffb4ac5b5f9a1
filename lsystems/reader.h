// The state of a reading: where it stands, its first error, and the system so far. After an error it stands at the end
// of the text, so that everything under way returns.
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

/// "file:line:column".
std::string position_name(std::string_view file, TextPosition place);

struct Reader {
  std::string_view text;  ///< Comments are blank already.
  std::string file;
  std::size_t at = 0, end = 0;  ///< Of the statement that is read: nothing looks beyond `end`.
  std::vector<std::size_t> line_starts;
  std::optional<Error> failed;

  LSystem system;
  std::map<std::pair<std::string, int>, Kind> kind_of;
  std::map<std::string, double, std::less<>> constants;  ///< Of #define.
  std::map<std::string, double, std::less<>> given;      ///< By the caller: take the place of constants.
  std::vector<std::string> long_names;                   ///< Of `module`, longest first.
  std::vector<std::string> slots;                        ///< Parameters of the rule that is read.
  int depth = 0;                                         ///< Parentheses in each other.
  int dice = 0;                                          ///< Thrown by the rule that is read.
  bool may_draw = false;                                 ///< RandomSource.
  bool may_query = true;                                 ///< ?-modules: not in interpretations.

  char peek(std::size_t ahead = 0) const { return at + ahead < end ? text[at + ahead] : '\0'; }
  bool starts_with(std::string_view word) const { return text.substr(at, end - at).substr(0, word.size()) == word; }
  bool done() const { return at >= end; }
  void skip_space();
  /// Takes the word if it is next, after space.
  bool accept(std::string_view word);
  /// Takes the word, or fails with "expected `word` `why`, found …".
  bool expect(std::string_view word, std::string_view why);

  TextPosition place() const { return position_at(at); }
  TextPosition position_at(std::size_t byte) const;
  /// Notes the first error, here: "expected `what`, found …".
  void fail_expected(std::string_view what);
  void fail(TextPosition where, std::string message);
};

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
inline bool is_name_letter(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

/// The name that stands here ("" for none), after space.
std::string take_name(Reader& reader);
/// True at -> or -->.
bool at_arrow(const Reader& reader);

/// An expression, up to where it cannot go on. Parameters of the rule, constants, numbers and functions.
Value read_value(Reader& reader);
/// An expression whose value is known when the file is read.
double read_constant(Reader& reader, std::string_view what);

/// Modules with numbers, up to where no module begins.
Successor read_successor(Reader& reader);
/// Modules with names for their parameters, which become slots.
std::vector<Kind> read_pattern(Reader& reader);
/// A module's name ("" where none begins).
std::string take_module_name(Reader& reader);
/// The kind of a name and number of parameters, a new one if need be.
Kind kind_named(Reader& reader, const std::string& name, std::size_t arity);

/// A production, with its arrow somewhere in the statement; goes into `set`.
void read_rule(Reader& reader, RuleSet& set, bool contexts_allowed);

}  // namespace citykiln::lsystems
