// Checks and repairs texts in UTF-8, the encoding of names in maps, manifests and outputs.
#pragma once

#include <string>
#include <string_view>

namespace citykiln {

/// True if a text is valid UTF-8 (RFC 3629): no overlong forms, no surrogates, nothing beyond U+10FFFF. O(n).
bool is_utf8(std::string_view text);

/// Returns the text with U+FFFD in place of each byte that belongs to no valid character. Valid texts do not change.
/// O(n).
std::string to_valid_utf8(std::string_view text);

}  // namespace citykiln
