// What stands left and right of a module in a string with branches.
//
//      A B [ C D ] E        left of C and of E is B: a branch's first module follows what the branch grows from, and a
//                           branch is passed over; right of B is E, and the branch [C D] may be matched too
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lsystems/lsystem.h"

namespace citykiln::lsystems {

inline constexpr std::uint32_t kNowhere = ~0u;

/// Of one string; brackets are balanced. Ignored modules are nobody's neighbours.
struct Neighbours {
  std::vector<std::uint32_t> left;    ///< Of each module.
  std::vector<std::uint32_t> axis;    ///< Of each place, and the end: the next module there or behind, on this branch.
  std::vector<std::uint32_t> branch;  ///< Of each place, and the end: the next [ there or behind, before that module.
  std::vector<std::uint32_t> close;   ///< Of each [.
  std::vector<std::uint32_t> value;   ///< Of each module: where its numbers begin.
};

/// Fills `neighbours`, whose memory is used again. O(n), no chance.
void find_neighbours(const LSystem& system, std::span<const Kind> kinds, Neighbours& neighbours);

/// Whether the rule's contexts stand about module `at`; then `slots` are their numbers and the module's own.
///
/// The left context is a path towards the root. The right context goes along the branch; [ ] in it match any branch
/// that begins there so, tried in order, at most kBranchScan of them. O(length of the contexts).
bool contexts_fit(const LSystem& system, const Rule& rule, std::span<const Kind> kinds, std::span<const double> values,
                  const Neighbours& neighbours, std::uint32_t at, double* slots);

inline constexpr int kBranchScan = 64;

}  // namespace citykiln::lsystems
