// Neighbours of modules in a bracketed string, and matching of contexts.
//
//      A B [ C D ] E        the left neighbour of C and of E is B: a branch's first module follows the module that the
//                           branch grows from; the right neighbour of B is E, and [C D] is a branch at B
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lsystems/lsystem.h"

namespace citykiln::lsystems {

/// The position of a neighbour that does not exist.
inline constexpr std::uint32_t kNowhere = ~0u;

/// The positions of neighbours in a string with balanced brackets; kNowhere: none. Ignored modules are skipped.
struct Neighbours {
  std::vector<std::uint32_t> left;    ///< The left neighbour of each module.
  std::vector<std::uint32_t> axis;    ///< The first module at or after each position on the same branch.
  std::vector<std::uint32_t> branch;  ///< The first [ at or after each position and before that first module (`axis`).
  std::vector<std::uint32_t> close;   ///< The matching ] of each [.
  std::vector<std::uint32_t> value;   ///< The first value of each module.
};

/// Fills `neighbours`, reusing its memory. O(n).
void find_neighbours(const LSystem& system, std::span<const Kind> kinds, Neighbours& neighbours);

/// True if the rule's contexts match at module `at`. If so, `slots` gets the parameters of contexts and module.
///
/// The left context is a path towards the root. The right context follows the branch; brackets in it match any branch
/// that begins there, in order; at most kBranchScan are tried. O(length of the contexts) without brackets; each nested
/// bracket multiplies that by up to kBranchScan.
bool contexts_fit(const LSystem& system, const Rule& rule, std::span<const Kind> kinds, std::span<const double> values,
                  const Neighbours& neighbours, std::uint32_t at, double* slots);

inline constexpr int kBranchScan = 64;

}  // namespace citykiln::lsystems
