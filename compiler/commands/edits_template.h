// Writes a file of edits for what `check` and `compile` have found, in which all lines are comments.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "compiler/outputs/findings.h"
#include "compiler/scene/scene.h"
#include "compiler/verify/worst_places.h"

namespace citykiln::commands {

/// Returns the text of a file of edits (edits/edits.md): for each place a comment with its element, its position and
/// its size, then a line with the likely mend (mends.inc) behind "#". Without changes the file has no edits. Kinds of
/// places that no edit of the map mends have comments alone; those of single meshes are left out.
/// @param kinds     The result of verify::worst_places(), with all places.
/// @param findings  Diagnoses in mends.inc that are not among the kinds are added.
/// @param run       The folder of the run, for the comment at the top.
std::string edits_template(std::span<const verify::PlacesOfKind> kinds, std::span<const outputs::Finding> findings,
                           const map::Plane& plane, std::string_view run);

/// Returns the edit for one place without "#"; "" if mends.inc has no row for its kind, or it has no element.
std::string likely_mend(std::string_view kind, const verify::WorstPlace& place);

}  // namespace citykiln::commands
