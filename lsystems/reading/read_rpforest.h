// Reads the files of RPForest (Rudzki 2020): .lsys in RPForest's notation, .honda (trees by Honda's model), .family
// (the simple leaves of "The Algorithmic Beauty of Plants").
#pragma once

#include <string>
#include <string_view>

#include "compiler/contract/result.h"
#include "lsystems/lsystem.h"

namespace citykiln::lsystems {

/// True if a file is one of RPForest: .honda and .family by the extension, and .lsys if its first word is a name of
/// RPForest, such as N, without ":" or "=" after it, or if it begins with two numbers.
bool is_rpforest(std::string_view text, std::string_view file);

/// Translates a file to the notation of notation.md and reads the translation. Entries are a name and its values, in
/// any order.
///
/// .lsys: N, Axiom, `Prod X > F[+X]…`, TurnAngle (or Angle), PitchAngle, RollAngle, Height, InitRadius; or the oldest
/// form, N, angle, height, axiom and productions without names. .honda: R1 R2 A0 A2 D Wr. .family: Delta LA RA LB RB
/// PD. ConeBasePoints and Material are ignored. Missing values have RPForest's defaults. Height scales the plant.
/// Errors: an unknown name, a value that is not a number, a missing N, axiom or parameter; more than kTextLimit bytes;
/// those of read_lsystem(), at positions of the translation.
Result<LSystem> read_rpforest(std::string_view text, std::string_view file);

}  // namespace citykiln::lsystems
