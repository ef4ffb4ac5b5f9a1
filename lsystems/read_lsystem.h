// From the text of a .lsys file to a system that can be derived.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "compiler/contract/result.h"
#include "lsystems/lsystem.h"

namespace citykiln::lsystems {

/// Reads the notation of "The Algorithmic Beauty of Plants" (lsystems/README.md).
///
/// @param file   For messages.
/// @param given  Take the place of #define's values of these names: height, age …; others are not looked at.
/// Guarantees: brackets [ ] of the axiom and of every successor are balanced, so they are in every string derived.
/// Errors: the first place where the text can go on in no way, and what was expected there, in one line; texts beyond
/// kTextLimit. Method: recursive descent, no deeper than kNestingLimit. O(n log n).
Result<LSystem> read_lsystem(std::string_view text, std::string_view file,
                             const std::map<std::string, double, std::less<>>& given = {});

inline constexpr std::size_t kTextLimit = 4u << 20;  ///< Bytes: a thousand times our largest.
inline constexpr int kNestingLimit = 64;             ///< Parentheses in each other.
inline constexpr std::size_t kArityLimit = 16;       ///< Parameters of a module.
inline constexpr int kDepthLimit = 64;               ///< `maximum depth` of decomposition and interpretation.

}  // namespace citykiln::lsystems
