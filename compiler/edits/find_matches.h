// Finds the elements of a map that the lines of a file of edits mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/edits/edit.h"
#include "compiler/source/osm_data.h"

namespace citykiln::edits {

/// An element that at least one line means.
struct Match {
  OsmId id;
  /// Its index in the nodes, ways or relations of the map; kNoTags for a node without tags, which only ways have.
  std::size_t index = 0;
  std::vector<std::uint32_t> lines{};  ///< Indices in Edits::lines, increasing.
};
inline constexpr std::size_t kNoTags = static_cast<std::size_t>(-1);

/// Returns the elements that fit the filters of edits, sorted by id. Filters see the map as it was read: no line sees
/// what another one changes or adds. Nodes without tags fit filters that begin with their id only.
///
/// Cost: a search for the tags of each element in the keys of filters, then a test of each filter that names one of its
/// keys or its id; a test of every filter without an id and a key. O(nodes of ways) if an id is that of a node without
/// tags.
std::vector<Match> find_matches(const source::OsmData& map, const Edits& edits);

}  // namespace citykiln::edits
