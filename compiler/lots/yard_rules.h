// The rules of yards: a variant of a row of yards.inc for a lot.
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/contract/random_sequence.h"
#include "compiler/lots/recipe.h"
#include "compiler/map/features.h"

namespace citykiln::lots {

/// The barrier on the border of a lot.
struct BorderRule {
  std::optional<map::BarrierKind> kind;  ///< Empty: nothing.
  double height_m = 0;
  map::FenceKind fence = map::FenceKind::kAny;
};

/// Houses of towns with a smaller setback have no garden before them, in metres.
inline constexpr double kTownSetback_m = 6;
/// How far a paved front of a town reaches behind the nearest wall: the depth of usual recesses, in metres.
inline constexpr double kRecess_m = 3;

/// The rule of a yard.
struct YardRule {
  map::LandCoverClass front{}, rear{}, path{}, drive{};
  double front_m = 0;  ///< The depth of the front, from the border to the street; a little of it lies below the house.
  /// True for houses of towns near a street: the ground before them is paved as pavements are, up to the last recess.
  bool is_paved_front = false;
  bool has_drive = false;
  BorderRule street, sides;
  double trees = 0, shrubs = 0;  ///< The mean number on 100 m2 of soft ground (is_planted()).
};

/// Returns the rule of a barrier at a place.
inline const BorderRule& border_at(const YardRule& rule, BorderPlace place) {
  return place == BorderPlace::kElsewhere ? rule.sides : rule.street;
}

/// Returns the random numbers of a yard. rule_of() uses indices 0 to 3, plants those from 16 on.
RandomSequence draws_of(const Yard& yard, std::uint64_t seed);

/// Returns a rule drawn among the variants of the yard's country group and kind, changed by its climate. In deserts and
/// steppes a lawn has a chance of 1/2 to become gravel (in front) or earth (behind the house), and there are half as
/// many trees and shrubs. Nothing for lots of kind kNone.
///
/// Fronts of houses in closed rows of blocks, and of apartment houses, shops and public buildings with a setback below
/// kTownSetback_m, are paved whatever the row says.
std::optional<YardRule> rule_of(const Yard& yard, std::uint64_t seed);

/// True for lawn, gravel and earth, on which plants grow.
bool is_planted(map::LandCoverClass surface);

}  // namespace citykiln::lots
