#include "compiler/edits/added_elements.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "compiler/edits/edited_areas.h"
#include "compiler/edits/edited_tags.h"
#include "compiler/edits/new_element_id.h"

namespace citykiln::edits {
namespace {

using source::OsmData;
using NamedNodes = std::map<std::int64_t, source::Location>;

// The places of the nodes that points of new elements name, as far as the map has them. O(nodes) if there are any.
NamedNodes named_nodes(const OsmData& map, const Edits& edits) {
  std::set<std::int64_t> wanted;
  for (const Edit& edit : edits.lines)
    if (edit.added)
      for (const NewPoint& point : edit.added->points)
        if (point.node) wanted.insert(*point.node);
  NamedNodes named;
  if (wanted.empty()) return named;
  for (const source::Node& node : map.nodes)
    if (wanted.contains(node.id)) named.emplace(node.id, node.at);
  for (const source::NodeRef& node : map.way_nodes)
    if (wanted.contains(node.id)) named.emplace(node.id, node.at);
  return named;
}

std::optional<source::NodeRef> node_at(const NewPoint& point, const NamedNodes& named) {
  if (!point.node) return source::NodeRef{new_node_id(point.at), point.at};
  const auto found = named.find(*point.node);
  return found == named.end() ? std::nullopt : std::optional(source::NodeRef{found->first, found->second});
}

template <typename Object>
bool has_id(const std::vector<Object>& sorted, std::int64_t id) {
  const auto found = std::ranges::lower_bound(sorted, id, {}, &Object::id);
  return found != sorted.end() && found->id == id;
}

template <typename Object>
void merge_by_id(std::vector<Object>& sorted, std::vector<Object>&& added) {
  const auto old_count = static_cast<std::ptrdiff_t>(sorted.size());
  std::ranges::sort(added, {}, &Object::id);
  std::ranges::move(added, std::back_inserter(sorted));
  std::ranges::inplace_merge(sorted, sorted.begin() + old_count, {}, &Object::id);
}

source::Way way_of(OsmData& map, const NewElement& added, const NamedNodes& named) {
  const source::Range nodes{static_cast<std::uint32_t>(map.way_nodes.size()),
                            static_cast<std::uint32_t>(added.points.size() + (added.is_area ? 1 : 0))};
  for (const NewPoint& point : added.points) map.way_nodes.push_back(*node_at(point, named));
  if (added.is_area) map.way_nodes.push_back(map.way_nodes[nodes.first]);
  return {added.id.id, nodes, add_tags(map, added.tags)};
}

}  // namespace

std::vector<AddedElement> elements_to_add(const OsmData& map, const Edits& edits) {
  std::vector<AddedElement> added;
  const NamedNodes named = named_nodes(map, edits);
  for (std::uint32_t line = 0; line < edits.lines.size(); ++line) {
    if (!edits.lines[line].added) continue;
    const NewElement& element = *edits.lines[line].added;
    const auto has_place = [&](const NewPoint& point) { return node_at(point, named).has_value(); };
    const bool is_taken =
        element.id.type == OsmType::kNode ? has_id(map.nodes, element.id.id) : has_id(map.ways, element.id.id);
    if (is_taken || !std::ranges::all_of(element.points, has_place)) continue;
    added.push_back({element.id, node_at(element.points.front(), named)->at, line});
  }
  return added;
}

void add_elements(OsmData& map, const Edits& edits, const std::vector<AddedElement>& added, Report& report) {
  if (added.empty()) return;
  const NamedNodes named = named_nodes(map, edits);
  const std::size_t old_areas = map.areas.size();
  std::vector<source::Node> nodes;
  std::vector<source::Way> ways;
  for (const AddedElement& each : added) {
    const NewElement& element = *edits.lines[each.line].added;
    if (element.id.type == OsmType::kNode) {
      nodes.push_back({element.id.id, each.at, add_tags(map, element.tags)});
      continue;
    }
    ways.push_back(way_of(map, element, named));
    if (describes_area(map, ways.back())) append_area(map, ways.back(), report);
  }
  merge_by_id(map.nodes, std::move(nodes)), merge_by_id(map.ways, std::move(ways));
  sort_areas(map, old_areas);
}

}  // namespace citykiln::edits
