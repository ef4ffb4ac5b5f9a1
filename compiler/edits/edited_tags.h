// Changes the tags of elements.
#pragma once

#include <span>
#include <string>
#include <utility>

#include "compiler/edits/edit.h"
#include "compiler/edits/find_matches.h"
#include "compiler/source/osm_data.h"

namespace citykiln::edits {

/// True if a line of the match changes tags.
bool changes_tags(const Edits& edits, const Match& match);

/// True if a line of the match drops the element.
bool is_dropped(const Edits& edits, const Match& match);

/// Appends the tags of an element after the changes of these lines, and returns their range. The map has all texts that
/// the edits set (with_strings_of()). O(tags · changes).
source::Range add_changed_tags(source::OsmData& map, source::Range tags, const Edits& edits, const Match& match);

/// Appends these tags, sorted by key; of equal keys the last is kept.
source::Range add_tags(source::OsmData& map, std::span<const std::pair<std::string, std::string>> tags);

}  // namespace citykiln::edits
