// What a run keeps about a whole tile in its journal, so that a later run that takes the tile over reports the same.
#pragma once

#include <optional>
#include <string>

#include "compiler/contract/report.h"
#include "compiler/verify/run_report.h"

namespace citykiln::verify {

/// A written tile, and what was diagnosed while it was baked.
struct TileNote {
  WrittenTile tile;
  Report diagnosed;
};

/// The note as one line of JSON; from_text(text_of(note)) gives the same record, diagnoses and accounts.
std::string text_of(const TileNote& note);
/// Nothing if the text is not such a note.
std::optional<TileNote> tile_note(const std::string& text);

}  // namespace citykiln::verify
