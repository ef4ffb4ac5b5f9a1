// The state of a recursive descent parse and its first error. After an error the parser is at the end of the file, so
// that all functions return.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "grammars/language/syntax.h"

namespace citykiln::grammars {

/// The state of a parse.
struct Parser {
  std::vector<Token> tokens;  ///< The last token is kEnd.
  std::string file;
  std::size_t at = 0;           ///< The index of the next token.
  int depth = 0;                ///< The depth of nested braces, brackets and calls.
  std::string within;           ///< " (in rule Facade)", for errors; "" outside of definitions.
  std::optional<Error> failed;  ///< The first error.

  /// Returns the token `ahead` positions behind the next one; at the end the last token.
  const Token& peek(std::size_t ahead = 0) const { return tokens[std::min(at + ahead, tokens.size() - 1)]; }
  bool sees(const char* sign) const { return is_sign(peek(), sign); }
  bool sees_name(const char* name) const { return is_name(peek(), name); }
  bool at_end() const { return peek().kind == TokenKind::kEnd; }

  /// Returns the next token and advances, except at kEnd.
  Token take() { return at + 1 < tokens.size() ? tokens[at++] : tokens.back(); }
  /// Advances past the sign if it is the next token. Returns true if it was.
  bool accept(const char* sign);
  /// Advances past the sign, or fails with "expected `sign` `why`, found …". Returns true on success.
  bool expect(const char* sign, const char* why);
  /// Returns the next token, a name, and advances; fails with "expected `what`, found …" if it is no name.
  std::string expect_name(const char* what);
  /// Fails at the next token with "expected `what`, found …". The first error is kept.
  void fail_expected(const std::string& what);
  /// Fails with a message at a position, and the name of the rule there. The first error is kept.
  void fail(TextPosition position, const std::string& message);
};

/// Increases the nesting depth for the lifetime of the object; fails beyond kNestingLimit.
struct Nesting {
  Parser& parser;
  explicit Nesting(Parser& nested);
  ~Nesting() { --parser.depth; }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;
};

/// Parses an expression other than case and p%.
Expression parse_expression(Parser& parser);
/// Parses the value of an attr, const, function or local: with, case … else, p% … else, or an expression.
Expression parse_value(Parser& parser);
/// Parses ( a, b, … ).
std::vector<Expression> parse_arguments(Parser& parser);
/// Parses ( name = value … ) after `with`.
std::vector<Local> parse_locals(Parser& parser);
/// Returns the index of the token after the closing parenthesis for the one at index `from`; the index of the last
/// token if there is none.
std::size_t after_parenthesis(const Parser& parser, std::size_t from);
/// True if "p% :" is next, where p is a number, a name, a call or a parenthesis.
bool begins_chance(const Parser& parser);
/// Parses "p% :" and returns p.
Expression parse_percent(Parser& parser);
/// Parses the code after --> or after the colon of a selector.
Body parse_body(Parser& parser);
/// True if a new rule, function, attr, const, import or annotation is next, which ends the rule before.
bool begins_declaration(const Parser& parser);

}  // namespace citykiln::grammars
