#include "compiler/source/areas/assemble_areas.h"

// GCC 12 reports a false read past the end for the user name that follows an osmium::OSMObject in memory
#pragma GCC diagnostic ignored "-Wstringop-overread"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <exception>
#include <osmium/area/assembler.hpp>
#include <osmium/builder/osm_object_builder.hpp>
#include <osmium/osm/area.hpp>
#include <set>
#include <utility>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/mathematics.h"
#include "compiler/source/areas/bodies.h"
#include "compiler/source/areas/mended_rings.h"
#include "compiler/source/closing_ring.h"

namespace citykiln::source {
namespace {

// candidates per task: enough to hide the cost of scheduling; relations take longer and vary more
constexpr std::size_t kAreaWaysPerSlot = 256;
constexpr std::size_t kAreaRelationsPerSlot = 1;

struct Candidate {
  const osmium::Way* way = nullptr;
  const osmium::Relation* relation = nullptr;
};

// The areas of one task; their ranges index the task's own vectors.
struct Slot : AssembledAreas {
  std::vector<OsmId> without_body, mended;
  std::vector<std::pair<OsmId, double>> closed;  // with the share of the member ways that is there
  std::vector<Diagnosis> failures;
};

OsmId id_of_candidate(const Candidate& candidate) {
  return candidate.way ? OsmId{OsmType::kWay, candidate.way->id()}
                       : OsmId{OsmType::kRelation, candidate.relation->id()};
}

bool has_description(const osmium::TagList& tags) {
  return std::any_of(tags.begin(), tags.end(), [](const osmium::Tag& tag) { return is_descriptive(tag.key()); });
}

bool is_candidate(const osmium::Way& way) {
  constexpr std::size_t kNodesOfATriangle = 4;  // the first node is repeated at the end
  if (way.nodes().size() < kNodesOfATriangle || way.tags().has_tag("area", "no") || !has_description(way.tags()))
    return false;
  if (way.ends_have_same_id()) return true;
  const osmium::Location first = way.nodes().front().location();
  return first.valid() && first == way.nodes().back().location();
}

bool is_area_relation(const osmium::Relation& relation) {
  const char* type = relation.tags().get_value_by_key("type", "");
  return std::strcmp(type, "multipolygon") == 0 || std::strcmp(type, "boundary") == 0;
}

bool is_candidate(const osmium::Relation& relation) {
  if (!is_area_relation(relation)) return false;
  return std::any_of(relation.members().begin(), relation.members().end(),
                     [](const osmium::RelationMember& member) { return member.type() == osmium::item_type::way; });
}

bool has_missing_nodes(const osmium::Way& way) {
  return std::any_of(way.nodes().begin(), way.nodes().end(),
                     [](const osmium::NodeRef& node_ref) { return !node_ref.location().valid(); });
}

// A copy of the closed way without its missing nodes, closed again.
const osmium::Way& close_around_gaps(const osmium::Way& way, osmium::memory::Buffer& buffer) {
  {
    osmium::builder::WayBuilder builder(buffer);
    builder.set_id(way.id());
    osmium::builder::WayNodeListBuilder nodes(builder);
    const osmium::NodeRef* first = nullptr;
    const osmium::NodeRef* last = nullptr;
    for (const osmium::NodeRef& node_ref : way.nodes()) {
      if (!node_ref.location().valid()) continue;
      nodes.add_node_ref(node_ref);
      if (!first) first = &node_ref;
      last = &node_ref;
    }
    if (first && first->location() != last->location()) nodes.add_node_ref(*first);
  }
  return buffer.get<osmium::Way>(buffer.commit());
}

osmium::area::AssemblerConfig assembler_config() {
  osmium::area::AssemblerConfig config;
  config.create_empty_areas = false;
  config.ignore_invalid_locations = true;
  return config;
}

// Input copies for elements with gaps, and the assembler's output. Two buffers, because a buffer moves its contents
// when it grows. The assembler keeps a reference to its configuration.
struct Workspace {
  osmium::area::AssemblerConfig config = assembler_config();
  osmium::memory::Buffer mended{16 * 1024};
  osmium::memory::Buffer areas{64 * 1024};
};

// A relation whose way members are all present.
struct Members {
  const osmium::Relation* relation = nullptr;
  std::vector<const osmium::Way*> ways;
  bool is_complete = true;
};

const osmium::Way* find_osmium_way(const Elements& elements, std::int64_t id) {
  const auto found = std::lower_bound(elements.ways.begin(), elements.ways.end(), id,
                                      [](const osmium::Way* way, std::int64_t wanted) { return way->id() < wanted; });
  return found != elements.ways.end() && (*found)->id() == id ? *found : nullptr;
}

// True for members that make the area: the rings of one that was closed along the box, else all.
bool makes_area(const osmium::RelationMember& member, bool is_closed) {
  return member.type() == osmium::item_type::way && is_closing_ring(member) == is_closed;
}

// A copy of the relation without way members that are missing from the extract, and without those that make no area:
// the assembler requires every member.
const osmium::Relation& without_absent(const osmium::Relation& relation, const Elements& elements,
                                       osmium::memory::Buffer& buffer) {
  const bool is_closed = has_closing_rings(relation);
  {
    osmium::builder::RelationBuilder builder(buffer);
    builder.set_id(relation.id());
    osmium::builder::RelationMemberListBuilder members(builder);
    for (const osmium::RelationMember& member : relation.members()) {
      if (!makes_area(member, is_closed) || !find_osmium_way(elements, member.ref())) continue;
      members.add_member(member.type(), member.ref(), member.role());
    }
  }
  return buffer.get<osmium::Relation>(buffer.commit());
}

Members find_members(const osmium::Relation& relation, const Elements& elements, osmium::memory::Buffer& buffer) {
  Members members;
  members.relation = &relation;
  const bool is_closed = has_closing_rings(relation);
  for (const osmium::RelationMember& member : relation.members()) {
    if (!makes_area(member, is_closed)) continue;
    const osmium::Way* way = find_osmium_way(elements, member.ref());
    if (way) members.ways.push_back(way);
    if (!way) members.is_complete = false;
  }
  if (!members.is_complete || is_closed) members.relation = &without_absent(relation, elements, buffer);
  return members;
}

using Segment = std::pair<osmium::Location, osmium::Location>;

Segment segment(osmium::Location a, osmium::Location b) { return a < b ? Segment{a, b} : Segment{b, a}; }

// Segments of the members with role inner. If their outer ring is missing they must not become an outer ring.
std::set<Segment> segments_of_inner_members(const Members& members) {
  std::set<Segment> segments;
  auto way = members.ways.begin();
  for (const osmium::RelationMember& member : members.relation->members()) {
    const osmium::WayNodeList& nodes = (*way++)->nodes();
    if (std::strcmp(member.role(), "inner") != 0) continue;
    for (std::size_t i = 1; i < nodes.size(); ++i)
      segments.insert(segment(nodes[i - 1].location(), nodes[i].location()));
  }
  return segments;
}

Location location_of_ref(const osmium::NodeRef& node_ref) { return {node_ref.location().x(), node_ref.location().y()}; }

// The orientation at the westernmost point of a simple ring. Exact: longitudes differ by less than 2^32 and latitudes
// by less than 2^31, so the products stay below 2^63.
bool is_counter_clockwise(std::span<const Location> ring) {
  const Location west = ring.front(), before = ring.back(), after = ring[1];
  const auto dx1 = std::int64_t{after.lon_e7} - west.lon_e7, dy1 = std::int64_t{after.lat_e7} - west.lat_e7;
  const auto dx2 = std::int64_t{before.lon_e7} - west.lon_e7, dy2 = std::int64_t{before.lat_e7} - west.lat_e7;
  return dx1 * dy2 > dy1 * dx2;
}

void add_area_ring(const osmium::NodeRefList& nodes, std::uint32_t part, bool is_outer, Slot& slot) {
  AreaRing ring{{static_cast<std::uint32_t>(slot.ring_points.size()), 0}, part, is_outer};
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) slot.ring_points.push_back(location_of_ref(nodes[i]));
  ring.points.count = static_cast<std::uint32_t>(slot.ring_points.size()) - ring.points.first;
  const auto begin = slot.ring_points.begin() + ring.points.first;
  std::rotate(begin, std::min_element(begin, slot.ring_points.end()), slot.ring_points.end());
  if (is_counter_clockwise({begin, slot.ring_points.end()}) != is_outer)
    std::reverse(begin + 1, slot.ring_points.end());
  slot.rings.push_back(ring);
}

bool is_made_of(const osmium::NodeRefList& ring, const std::set<Segment>& segments) {
  return segments.contains(segment(ring[0].location(), ring[1].location()));
}

// Copies the rings of an assembled area, except outer rings made of `not_outer`. Returns false if no ring remains.
bool add_area(const osmium::Area& assembled, OsmId from, const std::set<Segment>& not_outer, Slot& slot) {
  Area area;
  area.from = from;
  area.rings.first = static_cast<std::uint32_t>(slot.rings.size());
  std::uint32_t part = 0;
  for (const osmium::OuterRing& outer : assembled.outer_rings()) {
    if (is_made_of(outer, not_outer)) continue;
    add_area_ring(outer, part, true, slot);
    for (const osmium::InnerRing& inner : assembled.inner_rings(outer)) add_area_ring(inner, part, false, slot);
    ++part;
  }
  area.rings.count = static_cast<std::uint32_t>(slot.rings.size()) - area.rings.first;
  if (area.rings.count == 0) return false;
  slot.areas.push_back(area);
  return true;
}

bool assemble_way(const osmium::Way& way, Workspace& space, Slot& slot) {
  const osmium::Way& whole = has_missing_nodes(way) ? close_around_gaps(way, space.mended) : way;
  osmium::area::Assembler assembler(space.config);
  if (!assembler(whole, space.areas)) return false;
  return add_area(space.areas.get<osmium::Area>(0), {OsmType::kWay, way.id()}, {}, slot);
}

// True if a way is a member twice, as outer and as inner ring, say. It counts once.
bool has_way_twice(const Members& members) {
  std::vector<const osmium::Way*> ways = members.ways;
  std::ranges::sort(ways);
  return std::ranges::adjacent_find(ways) != ways.end();
}

bool assemble_relation(const osmium::Relation& relation, const Elements& elements, Workspace& space, Slot& slot) {
  const Members members = find_members(relation, elements, space.mended);
  if (members.ways.empty()) return false;
  std::set<Segment> not_outer;
  if (!members.is_complete) not_outer = segments_of_inner_members(members);
  osmium::area::Assembler assembler(space.config);
  if (!assembler(*members.relation, members.ways, space.areas)) return false;
  const OsmId id{OsmType::kRelation, relation.id()};
  if (!add_area(space.areas.get<osmium::Area>(0), id, not_outer, slot)) return false;
  if (has_way_twice(members)) slot.mended.push_back(id);
  return true;
}

std::vector<Location> places_of_way(const osmium::Way& way) {
  std::vector<Location> places;
  for (const osmium::NodeRef& node_ref : way.nodes())
    if (node_ref.location().valid()) places.push_back(location_of_ref(node_ref));
  return places;
}

// The lines of a candidate by their roles. A closed way stays closed around missing nodes.
std::vector<AreaLine> lines_of(const Candidate& candidate, const Elements& elements) {
  std::vector<AreaLine> lines;
  if (candidate.way) {
    lines.push_back({places_of_way(*candidate.way)});
    if (!lines[0].points.empty() && lines[0].points.front() != lines[0].points.back())
      lines[0].points.push_back(lines[0].points.front());
    return lines;
  }
  const bool is_closed = has_closing_rings(*candidate.relation);
  for (const osmium::RelationMember& member : candidate.relation->members()) {
    const osmium::Way* way = makes_area(member, is_closed) ? find_osmium_way(elements, member.ref()) : nullptr;
    if (way) lines.push_back({places_of_way(*way), std::strcmp(member.role(), "inner") == 0});
  }
  return joined_lines(std::move(lines));
}

// Polygons of lines; where holes leave nothing, since they are the outer rings once more, those of the outer rings.
std::vector<MendedPolygon> polygons_with_area(std::vector<AreaLine> lines) {
  std::vector<MendedPolygon> polygons = mended_polygons(lines);
  if (!polygons.empty() || std::erase_if(lines, [](const AreaLine& line) { return line.is_inner; }) == 0)
    return polygons;
  return lines.empty() ? polygons : mended_polygons(lines);
}

// Makes an area of rings that libosmium refuses. Returns false if a line remains open, or no area is left.
bool mend_area(const Candidate& candidate, const Elements& elements, Slot& slot) {
  const std::vector<AreaLine> lines = lines_of(candidate, elements);
  const auto is_open = [](const AreaLine& line) {
    return line.points.size() < 4 || line.points.front() != line.points.back();
  };
  if (std::ranges::any_of(lines, is_open)) return false;
  Area area{id_of_candidate(candidate), {static_cast<std::uint32_t>(slot.rings.size()), 0}, {}};
  std::uint32_t part = 0;
  for (const MendedPolygon& polygon : polygons_with_area(lines)) {
    for (const std::vector<Location>& ring : polygon) {
      const auto first = static_cast<std::uint32_t>(slot.ring_points.size());
      slot.ring_points.insert(slot.ring_points.end(), ring.begin(), ring.end());
      slot.rings.push_back({{first, static_cast<std::uint32_t>(ring.size())}, part, &ring == &polygon.front()});
    }
    ++part;
  }
  area.rings.count = static_cast<std::uint32_t>(slot.rings.size()) - area.rings.first;
  if (part == 0) return false;
  slot.areas.push_back(area);
  slot.mended.push_back(area.from);
  return true;
}

// The share of the member ways that is in the extract; 1 for a way.
double share_of_members(const Candidate& candidate, const Elements& elements) {
  if (!candidate.relation) return 1;
  double all = 0, there = 0;
  for (const osmium::RelationMember& member : candidate.relation->members()) {
    if (!makes_area(member, false)) continue;
    all += 1;
    if (find_osmium_way(elements, member.ref())) there += 1;
  }
  return all > 0 ? there / all : 1;
}

// The tag that says that the candidate is a thing with a body, such as "natural=water"; else "". A boundary has no
// body, whatever else it says.
std::string body_tag_of(const Candidate& candidate) {
  const osmium::TagList& tags = candidate.way ? candidate.way->tags() : candidate.relation->tags();
  if (tags.has_tag("type", "boundary")) return "";
  const auto tag = std::find_if(tags.begin(), tags.end(),
                                [](const osmium::Tag& each) { return has_body(each.key(), each.value()); });
  return tag != tags.end() ? tag_text(tag->key(), tag->value()) : "";
}

// The diagonal of the box around what is there of a candidate, in whole metres.
double across_m(const Candidate& candidate, const Elements& elements) {
  constexpr double kMetresPerStep = 40'007'863.0 / 360 * 1e-7;  // of latitude, by the length of a meridian
  std::vector<Location> places;
  for (const AreaLine& line : lines_of(candidate, elements))
    places.insert(places.end(), line.points.begin(), line.points.end());
  if (places.empty()) return 0;
  const auto [west, east] = std::ranges::minmax(places, {}, &Location::lon_e7);
  const auto [south, north] = std::ranges::minmax(places, {}, &Location::lat_e7);
  const double wide = (east.lon_deg() - west.lon_deg()) * 1e7 * cosine((south.lat_deg() + north.lat_deg()) / 2);
  const double deep = (north.lat_deg() - south.lat_deg()) * 1e7;
  return std::round(std::sqrt(wide * wide + deep * deep) * kMetresPerStep);
}

void add_failure(const Candidate& candidate, const Elements& elements, Slot& slot) {
  const OsmId id = id_of_candidate(candidate);
  const std::string tag = body_tag_of(candidate);
  const double share = share_of_members(candidate, elements);
  if (tag.empty())
    slot.without_body.push_back(id);
  else if (share < 1)
    slot.failures.push_back({Code::kIncompleteArea, id, share, {}, {}, tag});
  else
    slot.failures.push_back({Code::kBrokenArea, id, across_m(candidate, elements), {}, {}, tag});
}

bool assemble(const Candidate& candidate, const Elements& elements, Workspace& space, Slot& slot) {
  space.mended.clear();
  space.areas.clear();
  try {
    return candidate.way ? assemble_way(*candidate.way, space, slot)
                         : assemble_relation(*candidate.relation, elements, space, slot);
  } catch (const std::exception&) {
    return false;
  }
}

Slot assemble_slot(std::span<const Candidate> candidates, const Elements& elements) {
  Slot slot;
  Workspace space;
  for (const Candidate& candidate : candidates) {
    if (!assemble(candidate, elements, space, slot) && !mend_area(candidate, elements, slot))
      add_failure(candidate, elements, slot);
    else if (candidate.relation && has_closing_rings(*candidate.relation))
      slot.closed.emplace_back(id_of_candidate(candidate), share_of_members(candidate, elements));
  }
  return slot;
}

void append_slot(const Slot& slot, AssembledAreas& all) {
  const auto first_ring = static_cast<std::uint32_t>(all.rings.size());
  const auto first_point = static_cast<std::uint32_t>(all.ring_points.size());
  for (Area area : slot.areas) {
    area.rings.first += first_ring;
    all.areas.push_back(area);
  }
  for (AreaRing ring : slot.rings) {
    ring.points.first += first_point;
    all.rings.push_back(ring);
  }
  all.ring_points.insert(all.ring_points.end(), slot.ring_points.begin(), slot.ring_points.end());
}

struct Candidates {
  std::vector<Candidate> relations, ways;
};

const osmium::Relation* find_osmium_relation(const Elements& elements, std::int64_t id) {
  const auto found = std::ranges::lower_bound(elements.relations, id, {},
                                              [](const osmium::Relation* relation) { return relation->id(); });
  return found != elements.relations.end() && (*found)->id() == id ? *found : nullptr;
}

// The area of a member that is a relation: an island in a lake, say. Null for other members.
const osmium::Relation* nested_area(const osmium::RelationMember& member, const osmium::Relation& relation,
                                    const Elements& elements) {
  if (member.type() != osmium::item_type::relation || member.ref() == relation.id()) return nullptr;
  const osmium::Relation* nested = find_osmium_relation(elements, member.ref());
  return nested != nullptr && is_area_relation(*nested) ? nested : nullptr;
}

bool holds_areas(const osmium::Relation& relation, const Elements& elements) {
  return relation.tags().has_tag("type", "multipolygon") &&
         std::ranges::any_of(relation.members(), [&](const osmium::RelationMember& member) {
           return nested_area(member, relation, elements) != nullptr;
         });
}

// Adds a copy of the relation in which the ways of areas that are members stand for these. Holes of an inner area are
// parts of the relation.
void add_with_nested_ways(const osmium::Relation& relation, const Elements& elements, osmium::memory::Buffer& buffer) {
  {
    osmium::builder::RelationBuilder builder(buffer);
    builder.set_id(relation.id());
    {
      osmium::builder::TagListBuilder list(builder);
      for (const osmium::Tag& tag : relation.tags()) list.add_tag(tag);
    }
    osmium::builder::RelationMemberListBuilder members(builder);
    for (const osmium::RelationMember& member : relation.members()) {
      const osmium::Relation* nested = nested_area(member, relation, elements);
      if (nested == nullptr) {
        members.add_member(member.type(), member.ref(), member.role());
        continue;
      }
      const bool is_inner = std::strcmp(member.role(), "inner") == 0;
      for (const osmium::RelationMember& way : nested->members())
        if (way.type() == osmium::item_type::way && !is_closing_ring(way))
          members.add_member(way.type(), way.ref(),
                             is_inner == (std::strcmp(way.role(), "inner") == 0) ? "outer" : "inner");
    }
  }
  buffer.commit();
}

// Copies of the relations that have areas as members.
osmium::memory::Buffer relations_with_nested_ways(const Elements& elements) {
  osmium::memory::Buffer buffer(64 * 1024, osmium::memory::Buffer::auto_grow::yes);
  for (const osmium::Relation* relation : elements.relations)
    if (holds_areas(*relation, elements)) add_with_nested_ways(*relation, elements, buffer);
  return buffer;
}

/// @param nested  relations_with_nested_ways(); it must live as long as the candidates.
Candidates find_candidates(const Elements& elements, const osmium::memory::Buffer& nested) {
  Candidates candidates;
  for (const osmium::Way* way : elements.ways) {
    if (is_candidate(*way)) candidates.ways.push_back({.way = way});
  }
  auto copy = nested.cbegin<osmium::Relation>();
  for (const osmium::Relation* relation : elements.relations) {
    if (copy != nested.cend<osmium::Relation>() && copy->id() == relation->id()) relation = &*copy++;
    if (is_candidate(*relation)) candidates.relations.push_back({.relation = relation});
  }
  return candidates;
}

// Cuts the candidates into spans of at most `size`.
void cut_into_spans(const std::vector<Candidate>& candidates, std::size_t size,
                    std::vector<std::span<const Candidate>>& pieces) {
  for (std::size_t first = 0; first < candidates.size(); first += size) {
    pieces.push_back(std::span(candidates).subspan(first, std::min(size, candidates.size() - first)));
  }
}

}  // namespace

bool is_descriptive(std::string_view key) {
  // the list of libosmium's AssemblerLegacy, including the test keys of osm-testdata
  constexpr std::array<std::string_view, 6> kSayNothing = {"type",       "source",  "note",
                                                           "created_by", "test:id", "test:section"};
  return std::find(kSayNothing.begin(), kSayNothing.end(), key) == kSayNothing.end();
}

AssembledAreas assemble_areas(const Elements& elements, int threads, Report& report) {
  AssembledAreas all;
  const osmium::memory::Buffer nested = relations_with_nested_ways(elements);
  const Candidates candidates = find_candidates(elements, nested);
  // relations first, because one relation can take as long as all ways together
  std::vector<std::span<const Candidate>> pieces;
  cut_into_spans(candidates.relations, kAreaRelationsPerSlot, pieces);
  const std::size_t relation_slots = pieces.size();
  cut_into_spans(candidates.ways, kAreaWaysPerSlot, pieces);
  std::vector<Slot> slots =
      for_each_slot<Slot>(pieces.size(), threads, [&](std::size_t i) { return assemble_slot(pieces[i], elements); });

  Account& account = report.account("source", "area");
  for (const std::vector<Candidate>* kind : {&candidates.ways, &candidates.relations})
    for (const Candidate& candidate : *kind) account.in += report.counts(id_of_candidate(candidate));
  std::rotate(slots.begin(), slots.begin() + static_cast<std::ptrdiff_t>(relation_slots), slots.end());
  for (const Slot& slot : slots) {
    append_slot(slot, all);
    for (const OsmId id : slot.mended) report.add(Code::kAreaMended, id);
    for (const auto& [id, share] : slot.closed) report.add(Code::kAreaClosed, id, share);
    for (const Diagnosis& failure : slot.failures) report.drop(account, failure);
    for (const OsmId id : slot.without_body) account.without_body += report.counts(id);
  }
  for (const Area& area : all.areas) account.out += report.counts(area.from);
  return all;
}

}  // namespace citykiln::source
