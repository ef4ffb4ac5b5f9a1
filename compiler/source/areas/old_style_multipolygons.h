// Converts multipolygons of the old style, whose tags are on their outer ways. OpenStreetMap had them until 2017, and
// some extracts still do.
#pragma once

#include "compiler/contract/findings/report.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// True if two elements say that they are the same thing: with one tag of a visible thing in common (both
/// natural=water), both buildings, or both water or both wood in other words.
bool are_one_thing(const OsmData& data, Range one, Range two);

/// Gives each multipolygon relation without descriptive tags the tags that all its outer ways share. Removes from
/// data.areas the closed ways whose area the multipolygon already holds: outer rings without tags of their own, and
/// inner rings with the tags of the multipolygon. They count as merged in the account "source/area".
///
/// So do closed outer ways that are one thing with the multipolygon by its own tags. The multipolygon is built; if it
/// has one outer way, it takes those of its tags whose keys it does not have.
/// @param data  Tagged areas, ways and relations, all sorted.
void merge_old_style_multipolygons(OsmData& data, Report& report);

}  // namespace citykiln::source
