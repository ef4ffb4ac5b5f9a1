// The tokens of a rule file and their positions.
#pragma once

#include <cstdint>
#include <string>

namespace citykiln::grammars {

/// The position of a character in a rule file.
struct TextPosition {
  std::uint32_t file = 0;    ///< Index into Program::files.
  std::uint32_t line = 0;    ///< From 1.
  std::uint32_t column = 0;  ///< From 1, in bytes.
};

enum class TokenKind : std::uint8_t { kName, kNumber, kString, kSign, kEnd };

struct Token {
  TokenKind kind = TokenKind::kEnd;
  std::string text;   ///< The text as written; for a string its unescaped value. A name may contain dots: scope.sx.
  double number = 0;  ///< The value of a kNumber.
  TextPosition position;
};

inline bool is_sign(const Token& token, const char* sign) {
  return token.kind == TokenKind::kSign && token.text == sign;
}
inline bool is_name(const Token& token, const char* name) {
  return token.kind == TokenKind::kName && token.text == name;
}

}  // namespace citykiln::grammars
