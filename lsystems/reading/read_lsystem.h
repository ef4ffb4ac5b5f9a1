// Reads .lsys files.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "compiler/contract/result.h"
#include "lsystems/lsystem.h"

namespace citykiln::lsystems {

/// Compiles a text in the notation of lsystems/notation.md.
///
/// @param file  The name of the file in error messages.
/// @param given  Values that replace the values of #define lines, by name; names without a #define are ignored.
///
/// Guarantees: brackets are balanced in the axiom, in every successor, and so in every derived string.
/// Errors: the first position where the text is invalid, with the text that was expected; a text longer than
/// kTextLimit. Method: recursive descent to a depth of kNestingLimit. O(n log n).
Result<LSystem> read_lsystem(std::string_view text, std::string_view file,
                             const std::map<std::string, double, std::less<>>& given = {});

inline constexpr std::size_t kTextLimit = 4u << 20;  ///< Bytes; a thousand times the largest shipped file.
inline constexpr int kNestingLimit = 64;             ///< Nested parentheses.
inline constexpr std::size_t kArityLimit = 16;       ///< Parameters of a module.
inline constexpr int kDepthLimit = 64;               ///< The largest `maximum depth`.

}  // namespace citykiln::lsystems
