// One step: every module of a string at once.
#pragma once

#include <vector>

#include "lsystems/derive.h"
#include "lsystems/module_buffer.h"
#include "lsystems/neighbours.h"
#include "lsystems/random_source.h"

namespace citykiln::lsystems {

/// What rewriting keeps from step to step.
struct Rewriter {
  const LSystem& system;
  const RuleSet& set;
  std::vector<Warning>& warnings;
  Neighbours neighbours;
  std::vector<double> slots;        ///< Of a rule with contexts.
  std::vector<std::uint8_t> plain;  ///< Of each kind: its arity, or kActive where a rule or % may want it.
  std::uint64_t work_left = 0;      ///< Limits::work, counted down.
};

inline constexpr std::uint8_t kActive = 0xff;

Rewriter rewriter_of(const LSystem& system, const RuleSet& set, std::vector<Warning>& warnings, const Limits& limits);

enum class Rewritten : std::uint8_t { kSame, kChanged, kTooLong, kTooMuchWork };

/// Writes into `out`, up to out.most symbols; then it is kTooLong and `out` is of no use. So it is where work_left is
/// used up.
/// @param chance  Of this step.
Rewritten rewrite(Rewriter& rewriter, const ModuleBuffer& in, const Draw& chance, ModuleBuffer& out);

/// Writes a successor: the axiom.
bool write_successor(Rewriter& rewriter, const Successor& successor, const double* slots, RandomSource& dice,
                     ModuleBuffer& out);

/// Counts a trouble; at most kMostWarnings different ones, the others together without place.
void add_warning(std::vector<Warning>& warnings, TextPosition place, const char* message);
inline constexpr std::size_t kMostWarnings = 100;

}  // namespace citykiln::lsystems
