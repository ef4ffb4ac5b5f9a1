// RPForest's files (Rudzki 2020), as one more notation: its .lsys (own symbols and productions), .honda (Honda's trees)
// and .family (the book's simple leaves) become the same system in ours.
#pragma once

#include <string>
#include <string_view>

#include "compiler/contract/result.h"
#include "lsystems/lsystem.h"

namespace citykiln::lsystems {

/// Whether it is one of RPForest's files: by the name's end, and of .lsys by its first word, which no file of ours has.
bool is_rpforest(std::string_view text, std::string_view file);

/// What such a file says, written in our notation: a name and its values after each other, in any order.
///
/// .lsys: N, Axiom, `Prod X > F[+X]…`, TurnAngle (or Angle), PitchAngle, RollAngle, Height, InitRadius; also the oldest
/// form, five values without names. .honda: R1 R2 A0 A2 D Wr. .family: Delta LA RA LB RB PD. ConeBasePoints and
/// Material mean nothing here. Height scales the plant; RPForest's own values stand where a file has none. Errors: a
/// name that RPForest does not know, a value that is no number, an N or angle or axiom that is missing.
Result<std::string> rpforest_to_lsystem_text(std::string_view text, std::string_view file);

/// rpforest_to_lsystem_text, read.
Result<LSystem> read_rpforest(std::string_view text, std::string_view file);

}  // namespace citykiln::lsystems
