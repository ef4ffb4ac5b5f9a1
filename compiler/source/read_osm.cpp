// Decodes the file once into memory, sorts the elements, looks up node places, flattens tags and assembles areas.
#include "compiler/source/read_osm.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/source/across_180.h"
#include "compiler/source/areas/assemble_areas.h"
#include "compiler/source/areas/close_cut_areas.h"
#include "compiler/source/areas/old_style_multipolygons.h"
#include "compiler/source/closing_ring.h"
#include "compiler/source/format/decode_osm.h"
#include "compiler/source/format/unique_strings.h"
#include "compiler/source/order_elements.h"
#include "compiler/source/pending_elements.h"

namespace citykiln::source {
namespace {

osmium::Location place_of_element(const osmium::Way& way) {
  for (const osmium::NodeRef& node : way.nodes())
    if (node.location().valid()) return node.location();
  return osmium::Location{};
}

osmium::Location place_of_element(const osmium::Relation& relation, const std::vector<osmium::Way*>& ways) {
  for (const osmium::RelationMember& member : relation.members()) {
    if (member.type() != osmium::item_type::way) continue;
    const auto found =
        std::ranges::lower_bound(ways, member.ref(), {}, [](const osmium::Way* way) { return way->id(); });
    if (found == ways.end() || (*found)->id() != member.ref()) continue;
    if (const osmium::Location place = place_of_element(**found); place.valid()) return place;
  }
  return osmium::Location{};
}

// Returns the ids of the elements whose place `owns` accepts, sorted. The place of a way is its first node with a
// location; the place of a relation is the place of its first member way that has one. Elements without a place are
// never included. O(n log n).
// @param elements  Ways must hold the locations of their nodes.
std::vector<OsmId> owned_elements(const Elements& elements, const OwnsPlace& owns) {
  std::vector<OsmId> owned;
  const auto add = [&](OsmId id, osmium::Location place) {
    if (place.valid() && owns(place.lon(), place.lat())) owned.push_back(id);
  };
  for (const osmium::Node* node : elements.nodes) add({OsmType::kNode, node->id()}, node->location());
  for (const osmium::Way* way : elements.ways)
    if (!is_closing_ring(*way)) add({OsmType::kWay, way->id()}, place_of_element(*way));
  for (const osmium::Relation* relation : elements.relations)
    add({OsmType::kRelation, relation->id()}, place_of_element(*relation, elements.ways));
  std::ranges::sort(owned);
  return owned;
}

std::uint32_t size_of(const auto& vector) { return static_cast<std::uint32_t>(vector.size()); }

Location location_of(osmium::Location place) { return {place.x(), place.y()}; }

Range add_element_tags(const osmium::TagList& tags, UniqueStrings& strings, OsmData& data) {
  const Range run{size_of(data.tags), static_cast<std::uint32_t>(tags.size())};
  for (const osmium::Tag& tag : tags)
    data.tags.push_back({strings.number_of(tag.key()), strings.number_of(tag.value())});
  return run;
}

LonLatBox box_of_nodes(const std::vector<const osmium::Node*>& nodes) {
  if (nodes.empty()) return {};
  Location low = location_of(nodes.front()->location()), high = low;
  for (const osmium::Node* node : nodes) {
    const Location at = location_of(node->location());
    low = {std::min(low.lon_e7, at.lon_e7), std::min(low.lat_e7, at.lat_e7)};
    high = {std::max(high.lon_e7, at.lon_e7), std::max(high.lat_e7, at.lat_e7)};
  }
  return {low.lon_deg(), low.lat_deg(), high.lon_deg(), high.lat_deg()};
}

void add_nodes(const Elements& elements, PendingElements& pending, UniqueStrings& strings, OsmData& data) {
  data.node_box = box_of_nodes(elements.nodes);
  for (const osmium::Node* node : elements.nodes) {
    if (!node->tags().empty())
      data.nodes.push_back({node->id(), location_of(node->location()), add_element_tags(node->tags(), strings, data)});
    pending.done(*node);
  }
}

void add_way(const osmium::Way& way, UniqueStrings& strings, OsmData& data, Report& report) {
  Range nodes{size_of(data.way_nodes), 0};
  for (const osmium::NodeRef& node_ref : way.nodes()) {
    if (node_ref.location().valid()) data.way_nodes.push_back({node_ref.ref(), location_of(node_ref.location())});
  }
  nodes.count = size_of(data.way_nodes) - nodes.first;
  const std::size_t missing = way.nodes().size() - nodes.count;
  if (missing > 0) report.add(Code::kMissingNode, {OsmType::kWay, way.id()}, static_cast<double>(missing));
  if (nodes.count < 2) {
    data.way_nodes.resize(nodes.first);
    report.drop(report.account("source", "way"), Code::kWayTooShort, {OsmType::kWay, way.id()});
    return;
  }
  data.ways.push_back({way.id(), nodes, add_element_tags(way.tags(), strings, data)});
}

void add_ways(const Elements& elements, PendingElements& pending, UniqueStrings& strings, OsmData& data,
              Report& report) {
  std::size_t most_nodes = 0;
  for (const osmium::Way* way : elements.ways) most_nodes += way->nodes().size();
  data.way_nodes.reserve(most_nodes);
  data.ways.reserve(elements.ways.size());
  for (const osmium::Way* way : elements.ways) {
    if (!is_closing_ring(*way)) add_way(*way, strings, data, report);
    pending.done(*way);
  }
  Account& account = report.account("source", "way");
  for (const Way& way : data.ways) account.out += report.counts({OsmType::kWay, way.id});
}

template <typename Pointer>
bool contains(const std::vector<Pointer>& elements, std::int64_t id) {
  const auto found = std::lower_bound(elements.begin(), elements.end(), id,
                                      [](Pointer element, std::int64_t wanted) { return element->id() < wanted; });
  return found != elements.end() && (*found)->id() == id;
}

bool contains(const Elements& elements, OsmId id) {
  if (id.type == OsmType::kNode) return contains(elements.nodes, id.id);
  if (id.type == OsmType::kWay) return contains(elements.ways, id.id);
  return contains(elements.relations, id.id);
}

OsmId id_of_member(const osmium::RelationMember& member) {
  const OsmType type = member.type() == osmium::item_type::node  ? OsmType::kNode
                       : member.type() == osmium::item_type::way ? OsmType::kWay
                                                                 : OsmType::kRelation;
  return {type, member.ref()};
}

void add_relations(const Elements& elements, bool has_nodes, UniqueStrings& strings, OsmData& data, Report& report) {
  Account& account = report.account("source", "relation");
  for (const osmium::Relation* relation : elements.relations) {
    const OsmId id{OsmType::kRelation, relation->id()};
    if (relation->tags().empty()) {
      report.drop(account, Code::kRelationWithoutTags, id);
      continue;
    }
    Range members{size_of(data.members), 0};
    std::size_t missing = 0;
    for (const osmium::RelationMember& member : relation->members()) {
      if (is_closing_ring(member)) continue;
      data.members.push_back({id_of_member(member), strings.number_of(member.role())});
      if (has_nodes || member.type() == osmium::item_type::way) missing += !contains(elements, id_of_member(member));
    }
    members.count = size_of(data.members) - members.first;
    // a route or boundary is no area that would be incomplete
    if (missing > 0 && relation->tags().has_tag("type", "multipolygon"))
      report.add(Code::kMissingMember, id, static_cast<double>(missing));
    data.relations.push_back({relation->id(), members, add_element_tags(relation->tags(), strings, data)});
  }
  for (const Relation& relation : data.relations) account.out += report.counts({OsmType::kRelation, relation.id});
}

void sort_run(Range run, OsmData& data) {
  const auto first = data.tags.begin() + run.first;
  std::sort(first, first + run.count,
            [](const Tag& a, const Tag& b) { return a.key != b.key ? a.key < b.key : a.value < b.value; });
}

// Renumbers keys, values and roles in alphabetical order, then sorts each element's tags.
void sort_strings(const UniqueStrings& strings, OsmData& data) {
  data.strings = strings.sorted();
  const std::vector<std::uint32_t> places = strings.places_in_sorted();
  for (Tag& tag : data.tags) tag = {places[tag.key], places[tag.value]};
  for (Member& member : data.members) member.role = places[member.role];
  for (const Node& node : data.nodes) sort_run(node.tags, data);
  for (const Way& way : data.ways) sort_run(way.tags, data);
  for (const Relation& relation : data.relations) sort_run(relation.tags, data);
}

// The relation's tags without `type`, which states how the relation is built, not what it describes.
Range tags_without_type(Range tags, OsmData& data) {
  Range run{size_of(data.tags), 0};
  for (std::uint32_t i = 0; i < tags.count; ++i) {
    const Tag tag = data.tags[tags.first + i];
    if (data.strings[tag.key] != "type") data.tags.push_back(tag);
  }
  run.count = size_of(data.tags) - run.first;
  return run;
}

// Gives each area the tags of its element, by one walk over two sorted vectors per kind.
void tag_areas(OsmData& data) {
  auto way = data.ways.begin();
  auto relation = data.relations.begin();
  for (Area& area : data.areas) {
    if (area.from.type == OsmType::kWay) {
      while (way->id != area.from.id) ++way;
      area.tags = way->tags;
    } else {
      while (relation->id != area.from.id) ++relation;
      area.tags = tags_without_type(relation->tags, data);
    }
  }
}

// Converts all elements except areas, and frees the buffers. Relations come first, since they look up members in the
// buffers.
OsmData flatten(const Elements& elements, bool has_nodes, PendingElements pending, Report& report) {
  OsmData data;
  UniqueStrings strings;
  add_relations(elements, has_nodes, strings, data, report);
  add_nodes(elements, pending, strings, data);
  add_ways(elements, pending, strings, data, report);
  sort_strings(strings, data);
  return data;
}

void add_areas(AssembledAreas&& areas, OsmData& data) {
  data.areas = std::move(areas.areas);
  data.rings = std::move(areas.rings);
  data.ring_points = std::move(areas.ring_points);
  tag_areas(data);
}

// Limits the report to the owned elements, and starts the accounts with their numbers.
void limit(Report& report, const Elements& elements, const std::vector<OsmId>& owned) {
  report.limit_to(owned);
  Account &nodes = report.account("source", "node"), &ways = report.account("source", "way"),
          &relations = report.account("source", "relation");
  for (const osmium::Node* node : elements.nodes) nodes.in += report.counts({OsmType::kNode, node->id()});
  nodes.out = nodes.in;
  for (const osmium::Way* way : elements.ways) ways.in += report.counts({OsmType::kWay, way->id()});
  for (const osmium::Relation* relation : elements.relations)
    relations.in += report.counts({OsmType::kRelation, relation->id()});
}

// The error of a map whose ways and relations have no places, as Overpass gives it for `out center`, `out ids` and
// queries that do not ask for nodes. One or two such ways may be a fault of the map.
std::optional<Error> without_places(const std::string& path, const Elements& elements) {
  constexpr std::size_t kFewest = 3;
  const auto has_place = [](const osmium::Way* way) {
    return std::ranges::any_of(way->nodes(), [](const osmium::NodeRef& node) { return node.location().valid(); });
  };
  const std::size_t lines = elements.ways.size() + elements.relations.size();
  if ((elements.nodes.empty() ? lines : elements.ways.size()) < kFewest) return std::nullopt;
  if (std::ranges::any_of(elements.ways, has_place)) return std::nullopt;
  return Error{path,
               fmt::format("none of its {} ways has a place, because their nodes are missing: an answer of Overpass "
                           "with `out center` or without its nodes? End the query with (._;>;); out body; or with out "
                           "geom;",
                           elements.ways.size())};
}

}  // namespace

Result<OsmData> read_osm(const std::string& path, int threads, Report& report, const OwnsPlace& owns) {
  Result<DecodedOsm> decoded = decode_osm(path, threads);
  if (!decoded) return decoded.error();
  Report of_all, area_report;
  Elements elements = order_elements(decoded->buffers, threads, owns ? of_all : report);
  if (!decoded->has_places_in_ways) locate_way_nodes(elements, threads);
  if (const auto error = without_places(path, elements)) return *error;
  if (!decoded->is_of_region)
    close_cut_areas(elements, decoded->header_box.value_or(box_of_nodes(elements.nodes)), decoded->buffers);
  if (owns) {
    const std::vector<OsmId> owned = owned_elements(elements, owns);
    limit(report, elements, owned);
    area_report.limit_to(owned);
  }

  // areas first: they are assembled from the buffers, which the copy frees
  const bool is_across = is_across_180(elements);
  if (is_across) turn_half(elements);
  AssembledAreas areas = assemble_areas(elements, threads, area_report);
  if (is_across) turn_half(elements), turn_half(areas.ring_points);
  OsmData data = flatten(elements, !decoded->has_places_in_ways, PendingElements(decoded->buffers, elements), report);
  report.append(area_report);
  add_areas(std::move(areas), data);
  data.file_name = std::filesystem::path(path).filename().string();
  data.header_box = decoded->header_box;
  merge_old_style_multipolygons(data, report);
  join_across_180(data);
  return data;
}

}  // namespace citykiln::source
