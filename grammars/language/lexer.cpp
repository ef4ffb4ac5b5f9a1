#include "grammars/language/lexer.h"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace citykiln::grammars {
namespace {

// Longer signs first, because the first match is taken.
constexpr std::array kSigns = {"-->", "==", "!=", "<=", ">=", "&&", "||", ":=", "(", ")", "{", "}", "[", "]", "|", "*",
                               "/",   "+",  "-",  "%",  "~",  "'",  "<",  ">",  "!", ",", ":", "=", ".", "@", ";"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool starts_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$'; }
bool continues_name(char c) { return starts_name(c) || is_digit(c); }

struct Lexer {
  std::string_view text;
  std::string_view file;
  std::uint32_t file_index = 0;
  std::size_t at = 0;
  std::uint32_t line = 1;
  std::size_t line_start = 0;
  std::vector<Token> tokens;
  std::optional<Error> failed;

  char peek(std::size_t ahead = 0) const { return at + ahead < text.size() ? text[at + ahead] : '\0'; }
  TextPosition position() const { return {file_index, line, static_cast<std::uint32_t>(at - line_start + 1)}; }
  bool starts_with(std::string_view word) const { return text.substr(at, word.size()) == word; }
  void fail(TextPosition where, std::string message) { failed = Error{position_text(file, where), std::move(message)}; }

  void step() {
    if (text[at++] == '\n') {
      ++line;
      line_start = at;
    }
  }

  void skip_comment() {
    const TextPosition start = position();
    while (at < text.size() && !starts_with("*/")) step();
    if (at == text.size()) return fail(start, "expected */ that ends the comment, found the end of the file");
    at += 2;
  }

  void skip_space() {
    while (at < text.size() && !failed) {
      if (starts_with("//") || peek() == '#') {
        while (at < text.size() && peek() != '\n') step();
      } else if (starts_with("/*")) {
        skip_comment();
      } else if (peek() == ' ' || peek() == '\t' || peek() == '\r' || peek() == '\n') {
        step();
      } else {
        return;
      }
    }
  }

  void take_name() {
    Token token{TokenKind::kName, {}, 0, position()};
    // A dot followed by a letter belongs to the name; "Wall." is a name and a dot.
    while (continues_name(peek()) || (peek() == '.' && starts_name(peek(1)))) token.text += text[at++];
    tokens.push_back(std::move(token));
  }

  void take_number() {
    Token token{TokenKind::kNumber, {}, 0, position()};
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), token.number);
    if (error != std::errc() || !std::isfinite(token.number))
      return fail(token.position, "expected a number that a double can hold");
    token.text = std::string(text.data() + at, end);
    at += token.text.size();
    tokens.push_back(std::move(token));
  }

  void take_string() {
    Token token{TokenKind::kString, {}, 0, position()};
    ++at;
    while (at < text.size() && peek() != '"' && peek() != '\n') {
      if (peek() == '\\' && (peek(1) == '"' || peek(1) == '\\')) ++at;
      token.text += text[at++];
    }
    if (peek() != '"') return fail(token.position, "expected \" that ends the string, found the end of the line");
    ++at;
    tokens.push_back(std::move(token));
  }

  void take_sign() {
    for (const char* sign : kSigns) {
      if (!starts_with(sign)) continue;
      tokens.push_back({TokenKind::kSign, sign, 0, position()});
      at += std::string_view(sign).size();
      return;
    }
    const bool printable = peek() > ' ' && peek() < 0x7f;
    fail(position(), printable ? fmt::format("no token begins with '{}'", peek()) : "no token begins with this byte");
  }

  void take_token() {
    if (starts_name(peek())) return take_name();
    if (is_digit(peek()) || (peek() == '.' && is_digit(peek(1)))) return take_number();
    if (peek() == '"') return take_string();
    take_sign();
  }
};

}  // namespace

std::string position_text(std::string_view file, TextPosition position) {
  return fmt::format("{}:{}:{}", file, position.line, position.column);
}

Result<std::vector<Token>> tokens_of(std::string_view text, std::string_view file, std::uint32_t file_index) {
  Lexer lexer{text, file, file_index, 0, 1, 0, {}, {}};
  // a byte-order mark of an editor
  if (text.starts_with("\xef\xbb\xbf")) lexer.at = lexer.line_start = 3;
  lexer.skip_space();
  while (lexer.at < text.size() && !lexer.failed) {
    lexer.take_token();
    if (!lexer.failed) lexer.skip_space();
  }
  if (lexer.failed) return *lexer.failed;
  lexer.tokens.push_back({TokenKind::kEnd, "", 0, lexer.position()});
  return std::move(lexer.tokens);
}

}  // namespace citykiln::grammars
