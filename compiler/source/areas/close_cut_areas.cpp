#include "compiler/source/areas/close_cut_areas.h"

// GCC 12 reports a false read past the end for the user name that follows an osmium::OSMObject in memory
#pragma GCC diagnostic ignored "-Wstringop-overread"

#include <algorithm>
#include <array>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <osmium/builder/osm_object_builder.hpp>
#include <utility>

#include "compiler/source/areas/bodies.h"
#include "compiler/source/closing_ring.h"

namespace citykiln::source {
namespace {

struct EvidenceRow {
  const char* key;
  const char* value;
  std::array<int, 5> votes;  // by CutAreaKind
};

constexpr EvidenceRow kEvidence[] = {
#define EVIDENCE(key, value, river, standing, built_up, cover, park) \
  {key, value, {river, standing, built_up, cover, park}},
#include "compiler/source/areas/area_evidence.inc"
#undef EVIDENCE
};

bool has_value(const osmium::TagList& tags, const char* key, std::initializer_list<const char*> values) {
  const char* value = tags.get_value_by_key(key);
  return value && std::ranges::any_of(values, [&](const char* v) { return std::strcmp(v, value) == 0; });
}

bool says_yes(const osmium::TagList& tags, const char* key) {
  const char* value = tags.get_value_by_key(key);
  return value && std::strcmp(value, "no") != 0;
}

bool is_body(const osmium::TagList& tags, const char* key) {
  const char* value = tags.get_value_by_key(key);
  return value && has_body(key, value);
}

bool is_row_of(const osmium::TagList& tags, const EvidenceRow& row) {
  const char* value = tags.get_value_by_key(row.key);
  return value && (row.value[0] == '*' || std::strcmp(value, row.value) == 0);
}

}  // namespace

std::optional<CutAreaKind> cut_area_kind(const osmium::TagList& tags) {
  if (!tags.has_tag("type", "multipolygon") || says_yes(tags, "building") || says_yes(tags, "building:part"))
    return std::nullopt;
  if (has_value(tags, "water", {"river", "canal", "stream", "oxbow"}) ||
      has_value(tags, "waterway", {"riverbank", "river", "canal", "stream"}))
    return CutAreaKind::kRiver;
  if (tags.has_tag("natural", "water") || tags.has_key("water") || tags.has_tag("waterway", "dock") ||
      has_value(tags, "landuse", {"reservoir", "basin", "salt_pond", "aquaculture"}))
    return CutAreaKind::kStanding;
  if (has_value(tags, "landuse", {"residential", "industrial", "commercial", "retail"})) return CutAreaKind::kBuiltUp;
  if (is_body(tags, "landuse") || is_body(tags, "natural")) return CutAreaKind::kCover;
  if (is_body(tags, "leisure")) return CutAreaKind::kPark;
  return std::nullopt;
}

int votes_of(const osmium::TagList& tags, CutAreaKind kind) {
  if (says_yes(tags, "bridge") || says_yes(tags, "tunnel") || tags.has_tag("location", "underground")) return 0;
  const auto row = std::ranges::find_if(kEvidence, [&](const EvidenceRow& each) { return is_row_of(tags, each); });
  return row == std::end(kEvidence) ? 0 : row->votes[static_cast<std::size_t>(kind)];
}

namespace {

// Ways within about 500 m of an area's lines have a vote.
constexpr std::int32_t kNear_e7 = 50000;

// One house can stand in a wood, but not in a lake.
std::int64_t least_votes(CutAreaKind kind) {
  return kind == CutAreaKind::kRiver || kind == CutAreaKind::kStanding ? 1 : 2;
}

Location place_of_ref(const osmium::NodeRef& node) { return {node.location().x(), node.location().y()}; }

// The lines of a way, which ends at a missing node and begins again after it.
void add_lines_of(const osmium::Way& way, bool is_inner, std::vector<AreaLine>& lines) {
  bool continues = false;
  for (const osmium::NodeRef& node : way.nodes()) {
    const bool is_there = node.location().valid();
    if (is_there && !continues) lines.push_back({{}, is_inner});
    if (is_there) lines.back().points.push_back(place_of_ref(node));
    continues = is_there;
  }
}

LocationBox box_near(const CutLines& cut) {
  if (cut.lines.empty()) return cut.box;
  LocationBox box{cut.box.high, cut.box.low};
  for (const std::vector<AreaLine>* kind : {&cut.rings, &cut.lines})
    for (const AreaLine& line : *kind)
      for (const Location at : line.points) {
        box.low = {std::min(box.low.lon_e7, at.lon_e7), std::min(box.low.lat_e7, at.lat_e7)};
        box.high = {std::max(box.high.lon_e7, at.lon_e7), std::max(box.high.lat_e7, at.lat_e7)};
      }
  return {{box.low.lon_e7 - kNear_e7, box.low.lat_e7 - kNear_e7},
          {box.high.lon_e7 + kNear_e7, box.high.lat_e7 + kNear_e7}};
}

void add_ring_way(std::int64_t id, const AreaLine& ring, osmium::memory::Buffer& buffer) {
  {
    osmium::builder::WayBuilder builder(buffer);
    builder.set_id(id);
    osmium::builder::WayNodeListBuilder nodes(builder);
    for (const Location at : ring.points)
      nodes.add_node_ref(osmium::NodeRef(0, osmium::Location{at.lon_e7, at.lat_e7}));
  }
  buffer.commit();
}

void add_relation_with(const osmium::Relation& relation, std::span<const AreaLine> rings, std::int64_t first_ring,
                       osmium::memory::Buffer& buffer) {
  {
    osmium::builder::RelationBuilder builder(buffer);
    builder.set_id(relation.id());
    builder.set_version(relation.version());
    {
      osmium::builder::TagListBuilder list(builder);
      for (const osmium::Tag& tag : relation.tags()) list.add_tag(tag);
    }
    osmium::builder::RelationMemberListBuilder members(builder);
    for (const osmium::RelationMember& member : relation.members())
      members.add_member(member.type(), member.ref(), member.role());
    for (const AreaLine& ring : rings)
      members.add_member(osmium::item_type::way, first_ring++, ring.is_inner ? "inner" : "outer");
  }
  buffer.commit();
}

template <typename Pointer>
Pointer element_with(const std::vector<Pointer>& elements, std::int64_t id) {
  const auto found = std::ranges::lower_bound(elements, id, {}, [](Pointer element) { return element->id(); });
  return found != elements.end() && (*found)->id() == id ? *found : nullptr;
}

std::vector<CutArea> find_cut_areas(const Elements& elements, const LocationBox& box) {
  std::vector<CutArea> areas;
  for (const osmium::Relation* relation : elements.relations) {
    if (!cut_area_kind(relation->tags())) continue;
    std::vector<const osmium::Way*> ways;
    for (const osmium::RelationMember& member : relation->members())
      ways.push_back(member.type() == osmium::item_type::way ? element_with(elements.ways, member.ref()) : nullptr);
    if (std::optional<CutArea> area = cut_area_of(*relation, ways, box)) areas.push_back(std::move(*area));
  }
  return areas;
}

// Replaces relations by their closed copies, and adds the rings.
void adopt(osmium::memory::Buffer& closed, Elements& elements) {
  for (osmium::OSMObject& object : closed.select<osmium::OSMObject>()) {
    if (object.type() == osmium::item_type::way) {
      elements.ways.push_back(static_cast<osmium::Way*>(&object));
      continue;
    }
    const auto place = std::ranges::lower_bound(elements.relations, object.id(), {},
                                                [](const osmium::Relation* each) { return each->id(); });
    *place = static_cast<const osmium::Relation*>(&object);
  }
}

}  // namespace

std::optional<CutArea> cut_area_of(const osmium::Relation& relation, std::span<const osmium::Way* const> ways,
                                   const LocationBox& box) {
  const std::optional<CutAreaKind> kind = cut_area_kind(relation.tags());
  if (!kind || std::ranges::none_of(ways, [](const osmium::Way* way) { return way != nullptr; })) return std::nullopt;
  std::vector<AreaLine> lines;
  std::size_t i = 0;
  for (const osmium::RelationMember& member : relation.members())
    if (const osmium::Way* way = ways[i++]) add_lines_of(*way, std::strcmp(member.role(), "inner") == 0, lines);
  std::optional<CutLines> cut = cut_at_box(std::move(lines), box);
  if (!cut) return std::nullopt;
  const PartsOfBox parts(*cut);
  const PartVotes votes = *kind == CutAreaKind::kRiver ? votes_of_river(*cut) : PartVotes{};
  const LocationBox near = box_near(*cut);
  return CutArea{&relation, *kind, std::move(*cut), parts, near, votes};
}

void add_evidence(const osmium::Way& way, CutArea& area) {
  std::optional<bool> is_odd;
  int weight = 0;
  for (const osmium::NodeRef& node : way.nodes()) {
    if (!node.location().valid()) continue;
    const Location at = place_of_ref(node);
    if (!is_strictly_inside(area.near, at) || !is_strictly_inside(area.lines.box, at)) continue;
    if (weight == 0) weight = votes_of(way.tags(), area.kind);
    if (weight == 0) return;
    if (area.parts.is_vertex(at)) continue;
    const bool odd_here = area.parts.is_odd(at);
    if (is_odd && *is_odd != odd_here) return;
    is_odd = odd_here;
  }
  if (is_odd) add_vote(area.votes, *is_odd, weight);
}

bool add_closed(const CutArea& area, std::int64_t& next_ring, osmium::memory::Buffer& buffer) {
  const std::optional<std::vector<AreaLine>> rings =
      close_along_box(area.lines, area.parts, area.votes, least_votes(area.kind));
  if (!rings || rings->empty()) return false;
  add_relation_with(*area.relation, *rings, next_ring, buffer);
  for (const AreaLine& ring : *rings) add_ring_way(next_ring++, ring, buffer);
  return true;
}

void close_cut_areas(Elements& elements, const LonLatBox& box, std::vector<osmium::memory::Buffer>& buffers) {
  const std::optional<LocationBox> steps = location_box(box);
  if (!steps) return;
  std::vector<CutArea> areas = find_cut_areas(elements, *steps);
  if (areas.empty()) return;
  for (const osmium::Way* way : elements.ways) {
    if (way->tags().empty()) continue;
    for (CutArea& area : areas) add_evidence(*way, area);
  }
  osmium::memory::Buffer closed(64 * 1024, osmium::memory::Buffer::auto_grow::yes);
  std::int64_t next_ring = kFirstClosingRing;
  for (const CutArea& area : areas) add_closed(area, next_ring, closed);
  if (closed.committed() == 0) return;
  adopt(closed, elements);
  buffers.push_back(std::move(closed));
}

}  // namespace citykiln::source
