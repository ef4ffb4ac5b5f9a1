// Watches the elements of an extract that is cut for those that edits change. The edits themselves are made when the
// files of the regions are read.
#pragma once

#include <cstdint>
#include <map>
#include <osmium/osm/node.hpp>
#include <osmium/osm/relation.hpp>
#include <osmium/osm/way.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/edits/edit.h"

namespace citykiln::regions {

/// The kind of an element after the edits: that of its tags, or something else, such as an area or water.
enum class EditedAs : std::uint8_t { kSame, kOther, kCoastline };

/// The lines of a file of edits, and which of them fit an element that was seen. The places of a relation are not known
/// here: it fits box= and near= everywhere, so that a line with these that fits no other element is not reported.
class EditWatch {
 public:
  /// @param edits  Null: none. Must outlive the watch.
  explicit EditWatch(const edits::Edits* edits);

  /// Sees an element. Ways must hold the locations of their nodes. O(tags) searches in the keys of the filters.
  void see(const osmium::Node& node);
  EditedAs see(const osmium::Way& way);
  EditedAs see(const osmium::Relation& relation);

  /// Returns for each line: true if an element fits it, or all nodes of a new element have been seen.
  std::vector<bool> had_effect() const;

 private:
  template <typename Element>
  EditedAs see_element(const Element& element, const osmium::TagList& tags);
  void see_node_id(std::int64_t id);

  const edits::Edits* edits_;
  std::map<std::string, std::vector<std::uint32_t>, std::less<>> by_key_;
  std::map<OsmId, std::vector<std::uint32_t>> by_id_;
  std::vector<std::uint32_t> others_;                 // lines without an id and a key
  std::set<std::int64_t> wanted_nodes_, seen_nodes_;  // of new elements
  std::vector<bool> fitted_;
};

}  // namespace citykiln::regions
