#include "compiler/edits/find_matches.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>

#include "compiler/contract/erase_repeated.h"
#include "compiler/edits/fits.h"

namespace citykiln::edits {
namespace {

using source::OsmData;

template <typename Object>
const Object* object_with_id(const std::vector<Object>& sorted, std::int64_t id) {
  const auto found = std::ranges::lower_bound(sorted, id, {}, &Object::id);
  return found != sorted.end() && found->id == id ? &*found : nullptr;
}

// An element of OsmData, as fits.h needs it.
class MapElement {
 public:
  MapElement(const OsmData& map, const source::Node& node)
      : map_(map), id_{OsmType::kNode, node.id}, tags_(node.tags), place_(node.at) {}
  MapElement(const OsmData& map, const source::Way& way) : map_(map), id_{OsmType::kWay, way.id}, tags_(way.tags) {
    nodes_ = map.nodes_of(way);
  }
  MapElement(const OsmData& map, const source::Relation& relation)
      : map_(map), id_{OsmType::kRelation, relation.id}, tags_(relation.tags) {
    members_ = std::span(map.members).subspan(relation.members.first, relation.members.count);
  }
  MapElement(const OsmData& map, const source::NodeRef& untagged)
      : map_(map), id_{OsmType::kNode, untagged.id}, place_(untagged.at) {}

  OsmId id() const { return id_; }
  bool is_area() const {
    if (id_.type == OsmType::kWay) return nodes_.size() >= 4 && nodes_.front().id == nodes_.back().id;
    const auto type = id_.type == OsmType::kRelation ? value_of("type") : std::nullopt;
    return type && (*type == "multipolygon" || *type == "boundary");
  }
  std::optional<std::string_view> value_of(std::string_view key) const {
    for (const source::Tag& tag : map_.tags_of(tags_))
      if (map_.strings[tag.key] == key) return map_.strings[tag.value];
    return std::nullopt;
  }
  template <typename IsWanted>
  bool any_place(IsWanted is_wanted) const {
    if (id_.type == OsmType::kNode) return is_wanted(place_);
    const auto has_wanted = [&](std::span<const source::NodeRef> nodes) {
      return std::ranges::any_of(nodes, [&](const source::NodeRef& node) { return is_wanted(node.at); });
    };
    return has_wanted(nodes_) || std::ranges::any_of(members_, [&](const source::Member& member) {
             if (member.object.type != OsmType::kWay) return false;
             const source::Way* way = object_with_id(map_.ways, member.object.id);
             return way != nullptr && has_wanted(map_.nodes_of(*way));
           });
  }

 private:
  const OsmData& map_;
  OsmId id_;
  source::Range tags_{};
  source::Location place_{};
  std::span<const source::NodeRef> nodes_{};
  std::span<const source::Member> members_{};
};

// A condition that a filter is looked up by: its ids, else the key of its first tag that must be there, else nothing.
const Condition* anchor_of(const Filter& filter, ConditionKind kind) {
  const auto found = std::ranges::find_if(
      filter, [&](const Condition& condition) { return condition.kind == kind && !condition.is_negated; });
  return found == filter.end() ? nullptr : &*found;
}

// The lines by what their filters are looked up by. Sorted.
struct LineIndex {
  std::vector<std::pair<OsmId, std::uint32_t>> by_id;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> by_key;  // number of the key in OsmData::strings
  std::vector<std::uint32_t> others;
};

LineIndex index_lines(const OsmData& map, const Edits& edits) {
  LineIndex index;
  for (std::uint32_t line = 0; line < edits.lines.size(); ++line) {
    const Filter& filter = edits.lines[line].filter;
    if (filter.empty()) continue;
    if (const Condition* ids = anchor_of(filter, ConditionKind::kIds)) {
      for (const OsmId id : ids->ids) index.by_id.emplace_back(id, line);
    } else if (const Condition* tag = anchor_of(filter, ConditionKind::kTag)) {
      const auto key = std::ranges::lower_bound(map.strings, tag->key);
      if (key != map.strings.end() && *key == tag->key)
        index.by_key.emplace_back(static_cast<std::uint32_t>(key - map.strings.begin()), line);
    } else {
      index.others.push_back(line);
    }
  }
  std::ranges::sort(index.by_id), std::ranges::sort(index.by_key);
  return index;
}

template <typename Key>
void add_lines(const std::vector<std::pair<Key, std::uint32_t>>& index, Key wanted, std::vector<std::uint32_t>& lines) {
  auto found = std::lower_bound(index.begin(), index.end(), std::pair(wanted, std::uint32_t{0}));
  for (; found != index.end() && found->first == wanted; ++found) lines.push_back(found->second);
}

class Finder {
 public:
  Finder(const OsmData& map, const Edits& edits) : map_(map), edits_(edits), index_(index_lines(map, edits)) {}

  std::vector<Match> all() {
    add_all(map_.nodes), add_nodes_without_tags(), add_all(map_.ways), add_all(map_.relations);
    std::ranges::sort(matches_, {}, &Match::id);
    return std::move(matches_);
  }

 private:
  template <typename Object>
  void add_all(const std::vector<Object>& objects) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      lines_ = index_.others;
      for (const source::Tag& tag : map_.tags_of(objects[i].tags)) add_lines(index_.by_key, tag.key, lines_);
      add_element(MapElement(map_, objects[i]), i);
    }
  }

  void add_element(const MapElement& element, std::size_t index) {
    if (!index_.by_id.empty()) add_lines(index_.by_id, element.id(), lines_);
    std::erase_if(lines_, [&](std::uint32_t line) { return !fits(edits_.lines[line], element); });
    if (lines_.empty()) return;
    sort_unique(lines_);
    matches_.push_back({element.id(), index, lines_});
  }

  void add_nodes_without_tags() {
    std::set<std::int64_t> wanted;
    for (const auto& [id, line] : index_.by_id)
      if (id.type == OsmType::kNode && object_with_id(map_.nodes, id.id) == nullptr) wanted.insert(id.id);
    if (wanted.empty()) return;
    for (const source::NodeRef& node : map_.way_nodes) {
      if (wanted.erase(node.id) == 0) continue;
      lines_.clear();
      add_element(MapElement(map_, node), kNoTags);
    }
  }

  const OsmData& map_;
  const Edits& edits_;
  LineIndex index_;
  std::vector<std::uint32_t> lines_;  // of the current element
  std::vector<Match> matches_;
};

}  // namespace

std::vector<Match> find_matches(const OsmData& map, const Edits& edits) { return Finder(map, edits).all(); }

}  // namespace citykiln::edits
