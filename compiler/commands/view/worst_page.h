// Writes a page of the places of a run with the largest errors: index.html, with pictures.
#pragma once

#include <span>
#include <string>

#include "compiler/contract/result.h"
#include "compiler/stage_timer.h"
#include "compiler/verify/check_tile.h"
#include "compiler/verify/worst_places.h"

namespace citykiln::commands {

/// Writes FOLDER/index.html and FOLDER/pictures/*.png, and makes the folder if needed. Texts of the map are escaped.
/// Tags are quoted if the manifest has them (compile --tags). Errors: files that cannot be written.
Result<Done> write_worst_page(const verify::LoadedRun& run, std::span<const verify::PlacesOfKind> kinds,
                              const std::string& folder, int threads, const OnProgress& on_progress);

/// True if a place gets a picture: it has a position inside the extent, and its size is unusual for its kind. Outside
/// the extent there is nothing to see.
bool needs_picture(const Box2& extent, const verify::WorstPlace& place);

/// Returns the text with the five special characters of HTML escaped and without control characters.
std::string html_text(std::string_view text);

}  // namespace citykiln::commands
