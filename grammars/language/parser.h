// The state of a parse: where it stands, and its first error. After an error the parser stands at the end of the file,
// so that everything under way returns.
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

  const Token& peek(std::size_t ahead = 0) const { return tokens[std::min(at + ahead, tokens.size() - 1)]; }
  bool sees(const char* sign) const { return is_sign(peek(), sign); }
  bool sees_name(const char* name) const { return is_name(peek(), name); }
  bool at_end() const { return peek().kind == TokenKind::kEnd; }

  Token take() { return at + 1 < tokens.size() ? tokens[at++] : tokens.back(); }
  /// Takes the sign if it is next.
  bool accept(const char* sign);
  /// Takes the sign, or fails with "expected `sign` `why`, found …".
  bool expect(const char* sign, const char* why);
  /// Takes a name, or fails.
  std::string expect_name(const char* what);
  /// Notes the first error, at the next word: "expected `what`, found …".
  void fail_expected(const std::string& what);
  void fail(TextPosition place, const std::string& message);
};

/// Counts how deep a parse is nested; fails beyond kNestingLimit.
struct Nesting {
  Parser& parser;
  explicit Nesting(Parser& nested);
  ~Nesting() { --parser.depth; }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;
};

/// An expression without case and p%.
Expression parse_expression(Parser& parser);
/// The value of attr, const, a function or a local: with, case … else, p% … else, or an expression.
Expression parse_value(Parser& parser);
/// ( a, b, … )
std::vector<Expression> parse_arguments(Parser& parser);
/// ( name = value … ) behind `with`.
std::vector<Local> parse_locals(Parser& parser);
/// True where a number, a name or a parenthesis begins "p% :".
bool begins_chance(const Parser& parser);
/// The per cent of "p% :" up to its colon.
Expression parse_percent(Parser& parser);
/// What stands behind --> or a selector's colon.
Body parse_body(Parser& parser);
/// True where a new rule, function, attr, const, import or annotation begins, so that the rule before it ends.
bool begins_declaration(const Parser& parser);

}  // namespace citykiln::grammars
