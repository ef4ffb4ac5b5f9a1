// UTF-8: the encoding of names in maps, manifests and outputs.
#pragma once

#include <string>
#include <string_view>

namespace citykiln {

/// Whether a text is valid UTF-8 (RFC 3629): no overlong forms, no surrogates, nothing beyond U+10FFFF. O(n).
bool is_utf8(std::string_view text);

/// The text with U+FFFD for each byte that belongs to no valid character; valid texts stay as they are. O(n).
std::string to_valid_utf8(std::string_view text);

}  // namespace citykiln
