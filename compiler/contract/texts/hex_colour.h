// Colours as texts.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace citykiln {

/// Returns a colour as "#rrggbb", in small letters; "" without a colour.
inline std::string hex_colour(const std::optional<std::array<std::uint8_t, 3>>& colour) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  if (!colour) return "";
  std::string text = "#";
  for (const std::uint8_t value : *colour) text += kDigits[value >> 4], text += kDigits[value & 15];
  return text;
}

}  // namespace citykiln
