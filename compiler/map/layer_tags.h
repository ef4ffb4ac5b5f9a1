// The tags by which a reader sees why one way lies above another.
#pragma once

#include <map>
#include <string>

#include "compiler/contract/report.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// Tags by element, such as "tunnel=yes layer=-2".
using LayerTags = std::map<OsmId, std::string>;

/// Returns the tags about height of every way that a diagnosis of two objects names: bridge, tunnel, layer, level,
/// covered, indoor, location, incline, maxheight, in this order. Ways without any have an empty text; elements that are
/// no ways of the extract have none. Bytes that are not UTF-8 become U+FFFD. O(log n) a diagnosis.
LayerTags layer_tags_of(const source::OsmData& osm, const Report& report);

}  // namespace citykiln::map
