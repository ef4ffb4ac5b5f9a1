// Names and tags of the map's elements. No recipe depends on them; outputs have them so that objects can be looked up.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/map/tag_list.h"

namespace citykiln::source {
struct OsmData;
}

namespace citykiln::map {

struct Features;

/// Names are cut to this length; the longest in OSM have 255 characters.
inline constexpr std::size_t kMostNameBytes = 1024;

/// The texts of one OSM element, valid UTF-8.
struct ElementText {
  OsmId id;
  std::string name{};  ///< name=*; a building part without one has the name of its outline. Empty: no name.
  TagList tags{};      ///< All tags, sorted by key; empty if tags are not kept.
  bool operator==(const ElementText&) const = default;
};

/// Returns the texts of the elements of all features, sorted by id; elements without texts are left out. Bytes that are
/// not UTF-8 become U+FFFD. O(n log n).
std::vector<ElementText> element_texts(const source::OsmData& osm, const Features& features, bool keeps_tags);

/// The text of an element, or null. O(log n).
/// @param texts  Sorted by id.
const ElementText* find_text(std::span<const ElementText> texts, OsmId id);

}  // namespace citykiln::map
