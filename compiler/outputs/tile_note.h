// The entry of a finished tile in a run's journal, the list of tiles written up to now. If an interrupted run is
// continued, the tile is reused and reported from this entry.
#pragma once

#include <optional>
#include <string>

#include "compiler/contract/findings/report.h"
#include "compiler/outputs/run_report.h"

namespace citykiln::outputs {

/// A written tile, and the diagnoses made while it was baked.
struct TileNote {
  WrittenTile tile;
  Report diagnosed;
};

/// Returns the note as one line of JSON. tile_note(text_of(note)) gives the same record, diagnoses and accounts.
std::string text_of(const TileNote& note);
/// Reads a note; empty if the text is not one.
std::optional<TileNote> tile_note(const std::string& text);

}  // namespace citykiln::outputs
