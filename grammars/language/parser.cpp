#include "grammars/language/parser.h"

#include <fmt/core.h>

#include "grammars/language/lexer.h"
#include "grammars/language/parse.h"

namespace citykiln::grammars {
namespace {

std::string shown(const Token& token) {
  switch (token.kind) {
    case TokenKind::kEnd:
      return "the end of the file";
    case TokenKind::kString:
      return fmt::format("\"{}\"", token.text.substr(0, 40));
    default:
      return fmt::format("'{}'", token.text.substr(0, 40));
  }
}

}  // namespace

bool Parser::accept(const char* sign) {
  if (!sees(sign)) return false;
  take();
  return true;
}

bool Parser::expect(const char* sign, const char* why) {
  if (accept(sign)) return true;
  fail_expected(fmt::format("'{}' {}", sign, why));
  return false;
}

std::string Parser::expect_name(const char* what) {
  if (peek().kind == TokenKind::kName) return take().text;
  fail_expected(what);
  return {};
}

void Parser::fail_expected(const std::string& what) {
  fail(peek().position, fmt::format("expected {}, found {}", what, shown(peek())));
}

void Parser::fail(TextPosition position, const std::string& message) {
  if (!failed) failed = Error{position_text(file, position), message + within};
  at = tokens.size() - 1;
}

Nesting::Nesting(Parser& nested) : parser(nested) {
  if (++parser.depth > kNestingLimit)
    parser.fail(parser.peek().position, fmt::format("nested deeper than {}", kNestingLimit));
}

}  // namespace citykiln::grammars
