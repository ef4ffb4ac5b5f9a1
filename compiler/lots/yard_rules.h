// The rules of yards: a variant of a row of yards.inc for a lot.
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/contract/random_sequence.h"
#include "compiler/lots/plan_lots.h"

namespace citykiln::lots {

/// The barrier on the border of a lot.
struct BorderRule {
  std::optional<map::BarrierKind> kind;  ///< Empty: nothing.
  double height_m = 0;
};

/// The rule of a yard.
struct YardRule {
  map::LandCoverClass front{}, rear{}, path{}, drive{};
  bool has_drive = false;
  BorderRule street, sides;
  double trees = 0, shrubs = 0;  ///< On 100 m2 of soft ground.
};

/// Returns a rule drawn among the variants of the lot's group and kind, changed by its climate. In deserts and steppes
/// a lawn has a chance of 1/2 to become gravel (in front) or earth (behind the house), and there are half as many trees
/// and shrubs. Nothing for lots of kind kNone.
///
/// @param draw  The random numbers of the lot; indices 0 to 3 are used.
std::optional<YardRule> rule_for(const Lot& lot, const RandomSequence& draw);

/// True for lawn, gravel and earth, on which plants grow.
bool is_planted(map::LandCoverClass surface);

}  // namespace citykiln::lots
