// The state of a recursive descent parse and its first error. After an error the parser is at the end of the file, so
// that all functions return.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "grammars/language/syntax.h"

namespace citykiln::grammars {

struct Parser {
  std::vector<Token> tokens;  ///< The last is kEnd.
  std::string file;
  std::size_t at = 0;
  int depth = 0;
  std::optional<Error> failed;

  /// The next token, or a later one; the last token beyond the end.
  const Token& peek(std::size_t ahead = 0) const { return tokens[std::min(at + ahead, tokens.size() - 1)]; }
  bool sees(const char* sign) const { return is_sign(peek(), sign); }
  bool sees_name(const char* name) const { return is_name(peek(), name); }
  bool at_end() const { return peek().kind == TokenKind::kEnd; }

  /// The next token; the parse advances except at kEnd.
  Token take() { return at + 1 < tokens.size() ? tokens[at++] : tokens.back(); }
  /// Takes the sign if it is the next token.
  bool accept(const char* sign);
  /// Takes the sign, or fails with "expected `sign` `why`, found …".
  bool expect(const char* sign, const char* why);
  /// Takes a name, or fails.
  std::string expect_name(const char* what);
  /// Keeps the first error, at the next token: "expected `what`, found …".
  void fail_expected(const std::string& what);
  void fail(TextPosition position, const std::string& message);
};

/// Counts the nesting depth in its scope; fails beyond kNestingLimit.
struct Nesting {
  Parser& parser;
  explicit Nesting(Parser& nested);
  ~Nesting() { --parser.depth; }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;
};

/// Parses an expression without case and p%.
Expression parse_expression(Parser& parser);
/// Parses the value of attr, const, a function or a local: with, case … else, p% … else, or an expression.
Expression parse_value(Parser& parser);
/// Parses ( a, b, … ).
std::vector<Expression> parse_arguments(Parser& parser);
/// Parses ( name = value … ) after `with`.
std::vector<Local> parse_locals(Parser& parser);
/// The index of the token after the parenthesis that opens at index `from`; of the last token if it is never closed.
std::size_t after_parenthesis(const Parser& parser, std::size_t from);
/// True if "p% :" is next, where p is a number, a name, a call or a parenthesis.
bool begins_chance(const Parser& parser);
/// Parses "p% :" and returns p.
Expression parse_percent(Parser& parser);
/// Parses the code after --> or after the colon of a selector.
Body parse_body(Parser& parser);
/// True if a new rule, function, attr, const, import or annotation is next, which ends the rule before it.
bool begins_declaration(const Parser& parser);

}  // namespace citykiln::grammars
