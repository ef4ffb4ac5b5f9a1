// Finds an administrative area of a map by its name.
#pragma once

#include <string>

#include "compiler/contract/result.h"
#include "compiler/source/outline.h"
#include "compiler/spec.h"

namespace citykiln {

/// Returns the polygons, in degrees, of an administrative area of a map file: of the one relation with
/// boundary=administrative whose `name`, `name:en` or id ("r1124039") equals `name`.
///
/// Errors, each with candidates: no such area, several, or one whose boundary is not complete in the map; those of
/// source::read_osm(). Cost: that of reading the map.
Result<source::Outline> find_area(const std::string& map_path, const std::string& name, int threads);

/// Returns the area by the data of a map, as find_area().
Result<source::Outline> find_area(const source::OsmData& osm, const std::string& map_path, const std::string& name);

/// Makes the area of a spec its clip (clip_to()). Does nothing without one. Errors: those of find_area(); a clip is
/// given too.
Result<Done> resolve_area(CompileSpec& spec);

}  // namespace citykiln
