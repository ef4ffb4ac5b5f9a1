// The words of a rule file.
#pragma once

#include <cstdint>
#include <string>

namespace citykiln::grammars {

/// A character of a rule file.
struct TextPosition {
  std::uint32_t file = 0;    ///< Into Program::files.
  std::uint32_t line = 0;    ///< From 1.
  std::uint32_t column = 0;  ///< From 1, in bytes.
};

enum class TokenKind : std::uint8_t { kName, kNumber, kString, kSign, kEnd };

struct Token {
  TokenKind kind = TokenKind::kEnd;
  std::string text;   ///< As written; of a string, what it stands for. A name may hold dots: scope.sx, window.Frame.
  double number = 0;  ///< Of a number.
  TextPosition place;
};

inline bool is_sign(const Token& token, const char* sign) {
  return token.kind == TokenKind::kSign && token.text == sign;
}
inline bool is_name(const Token& token, const char* name) {
  return token.kind == TokenKind::kName && token.text == name;
}

}  // namespace citykiln::grammars
