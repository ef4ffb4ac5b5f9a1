// One step: every module of a string at once.
#pragma once

#include <vector>

#include "lsystems/derive.h"
#include "lsystems/dice.h"
#include "lsystems/neighbours.h"
#include "lsystems/stream.h"

namespace citykiln::lsystems {

/// What rewriting keeps from step to step.
struct Rewriter {
  const LSystem& system;
  const RuleSet& set;
  std::vector<Trouble>& troubles;
  Neighbours neighbours;
  std::vector<double> slots;        ///< Of a rule with contexts.
  std::vector<std::uint8_t> plain;  ///< Of each kind: its arity, or kActive where a rule or % may want it.
};

inline constexpr std::uint8_t kActive = 0xff;

Rewriter rewriter_of(const LSystem& system, const RuleSet& set, std::vector<Trouble>& troubles);

enum class Rewritten : std::uint8_t { kSame, kChanged, kTooLong };

/// Writes into `out`, up to out.most symbols; then it is kTooLong and `out` is of no use.
/// @param chance  Of this step.
Rewritten rewrite(Rewriter& rewriter, const Stream& in, const Draw& chance, Stream& out);

/// Writes a successor: the axiom.
bool write_successor(Rewriter& rewriter, const Successor& successor, const double* slots, Dice& dice, Stream& out);

void note(std::vector<Trouble>& troubles, Place place, const char* message);

}  // namespace citykiln::lsystems
