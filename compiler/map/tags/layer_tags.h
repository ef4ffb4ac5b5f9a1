// Tags that explain why one way lies above another, for diagnoses of two ways.
#pragma once

#include <map>
#include <string>

#include "compiler/contract/findings/report.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// Tags of elements as text, such as "tunnel=yes layer=-2".
using LayerTags = std::map<OsmId, std::string>;

/// Returns, for every way named by a diagnosis of two objects, its tags bridge, tunnel, layer, level, covered, indoor,
/// location, incline and maxheight, in this order. The text is empty if it has none of these. Elements that are not
/// ways of the extract are left out. Bytes that are not UTF-8 become U+FFFD. O(log n) per diagnosis.
LayerTags layer_tags_of(const source::OsmData& osm, const Report& report);

}  // namespace citykiln::map
