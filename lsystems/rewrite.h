// Parallel rewriting of a string by a rule set.
#pragma once

#include <vector>

#include "lsystems/derive.h"
#include "lsystems/module_buffer.h"
#include "lsystems/neighbours.h"
#include "lsystems/random_source.h"

namespace citykiln::lsystems {

/// The state that is kept between passes. A pass rewrites the whole string once.
struct Rewriter {
  const LSystem& system;
  const RuleSet& set;
  std::vector<Warning>& warnings;
  Neighbours neighbours;
  std::vector<double> slots;  ///< The parameters of a rule with contexts.
  /// By kind: its arity if modules of the kind are only copied; kActive if rules or % may change them.
  std::vector<std::uint8_t> plain;
  std::uint64_t work_left = 0;  ///< The remaining part of Limits::work.
};

inline constexpr std::uint8_t kActive = 0xff;

/// Returns the state before the first pass of a rule set.
Rewriter rewriter_of(const LSystem& system, const RuleSet& set, std::vector<Warning>& warnings, const Limits& limits);

/// The outcome of a pass.
enum class Rewritten : std::uint8_t { kSame, kChanged, kTooLong, kTooMuchWork };

/// Rewrites `in` into `out`. Returns kTooLong if the result exceeds out.most symbols, and kTooMuchWork if work_left
/// reaches 0; `out` is then incomplete.
/// @param chance  The random numbers of this pass.
Rewritten rewrite(Rewriter& rewriter, const ModuleBuffer& in, const RandomSequence& chance, ModuleBuffer& out);

/// Appends a successor to `out`. Returns false if the successor exceeds out.most symbols.
bool write_successor(Rewriter& rewriter, const Successor& successor, const double* slots, RandomSource& random,
                     ModuleBuffer& out);

/// Adds a warning, or counts it again. Keeps at most kMostWarnings different warnings; all others are counted as one
/// warning without position.
void add_warning(std::vector<Warning>& warnings, TextPosition place, const char* message);
inline constexpr std::size_t kMostWarnings = 100;

}  // namespace citykiln::lsystems
