// Parallel rewriting of a string by a rule set.
#pragma once

#include <vector>

#include "lsystems/derive.h"
#include "lsystems/module_buffer.h"
#include "lsystems/neighbours.h"
#include "lsystems/random_source.h"

namespace citykiln::lsystems {

/// The state that is kept between passes.
struct Rewriter {
  const LSystem& system;
  const RuleSet& set;
  std::vector<Warning>& warnings;
  Neighbours neighbours;
  std::vector<double> slots;        ///< The parameters of a rule with contexts.
  std::vector<std::uint8_t> plain;  ///< By kind: its arity, or kActive if rules or % may rewrite it.
  std::uint64_t work_left = 0;      ///< The remaining part of Limits::work.
};

inline constexpr std::uint8_t kActive = 0xff;

Rewriter rewriter_of(const LSystem& system, const RuleSet& set, std::vector<Warning>& warnings, const Limits& limits);

enum class Rewritten : std::uint8_t { kSame, kChanged, kTooLong, kTooMuchWork };

/// Rewrites `in` into `out`. Returns kTooLong if the result exceeds out.most symbols, and kTooMuchWork if work_left
/// reaches 0; `out` is then incomplete.
/// @param chance  The random numbers of this pass.
Rewritten rewrite(Rewriter& rewriter, const ModuleBuffer& in, const Draw& chance, ModuleBuffer& out);

/// Appends a successor. Returns false if it does not fit.
bool write_successor(Rewriter& rewriter, const Successor& successor, const double* slots, RandomSource& random,
                     ModuleBuffer& out);

/// Counts a warning. Keeps at most kMostWarnings different ones; all others are counted as one without position.
void add_warning(std::vector<Warning>& warnings, TextPosition place, const char* message);
inline constexpr std::size_t kMostWarnings = 100;

}  // namespace citykiln::lsystems
