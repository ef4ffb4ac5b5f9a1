// How deep a JSON text is nested. Functions that read or print JSON by recursion would overflow the stack on texts
// that are nested a hundred thousand times.
#pragma once

#include <string_view>

namespace citykiln {

/// More levels than any file that citykiln reads has.
inline constexpr int kMostJsonLevels = 64;

/// True if objects and arrays of the text are nested more than kMostJsonLevels deep. Takes any bytes. O(text).
bool is_nested_too_deep(std::string_view json);

}  // namespace citykiln
