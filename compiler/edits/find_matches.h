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
/// what another one changes or adds. A node without tags is tested only by filters that list its id, not negated.
///
/// Cost: filters are indexed by the ids, or else by the key of the first tag, that they require. An element is tested
/// by the filters found by its id and its keys, and by every filter that requires neither. O(nodes of ways) more if a
/// filter lists a node that has no tags.
std::vector<Match> find_matches(const source::OsmData& map, const Edits& edits);

}  // namespace citykiln::edits
