// Adds texts to those of a map.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/edits/edit.h"
#include "compiler/source/osm_data.h"

namespace citykiln::edits {

/// Returns the map with the keys and values that edits set among its strings, which stay sorted; tags and roles are
/// numbered anew. O(edits · log strings), and O(strings + tags) if a text is new.
source::OsmData with_strings_of(const Edits& edits, source::OsmData map);

/// Returns the index of a text, which must be one of the map's strings. O(log strings).
std::uint32_t number_of(const source::OsmData& map, std::string_view text);

}  // namespace citykiln::edits
