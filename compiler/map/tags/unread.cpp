#include "compiler/map/tags/unread.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "compiler/contract/equal_span.h"
#include "compiler/map/places.h"
#include "compiler/map/tags/read_elements.h"
#include "compiler/source/areas/bodies.h"
#include "compiler/source/areas/old_style_multipolygons.h"

namespace citykiln::map {
namespace {

using WayTags = std::pair<std::int64_t, source::Range>;

// The member ways of multipolygons, with the tags of the area, which can be those of its outer ways. Sorted by id.
std::vector<WayTags> ways_of_multipolygons(const source::OsmData& osm) {
  std::vector<WayTags> ways;
  for (const source::Area& area : osm.areas) {
    if (area.from.type != OsmType::kRelation) continue;
    const auto relation = std::ranges::lower_bound(osm.relations, area.from.id, {}, &source::Relation::id);
    if (relation == osm.relations.end() || relation->id != area.from.id) continue;
    for (const source::Member& member :
         std::span(osm.members).subspan(relation->members.first, relation->members.count))
      if (member.object.type == OsmType::kWay) ways.emplace_back(member.object.id, area.tags);
  }
  std::ranges::sort(ways, {}, &WayTags::first);
  return ways;
}

// The first tag that says that the element is a thing with a body.
const source::Tag* body_tag(const ReadContext& context, source::Range tags) {
  for (const source::Tag& tag : context.osm.tags_of(tags))
    if (source::has_body(context.osm.strings[tag.key], context.osm.strings[tag.value])) return &tag;
  return nullptr;
}

// Nodes of roads and rails that say something about these, such as highway=elevator, are read with them.
bool is_about_a_line(const ReadContext& context, const source::Tag& tag) {
  const std::string& key = context.osm.strings[tag.key];
  return key == "highway" || key == "railway" || key == "waterway";
}

// Parts of buildings may stand out of the outline that they belong to by this much.
constexpr double kBesidePart_m = 2;

std::vector<Footprint> parts_of(const Features& features) {
  std::vector<Footprint> parts;
  std::ranges::copy_if(features.footprints, std::back_inserter(parts), &Footprint::is_part);
  return parts;
}

class UnreadElements {
 public:
  UnreadElements(const ReadContext& context, const Features& features)
      : context_(context),
        read_(read_elements(features, context.report)),
        built_(built_elements(features)),
        parts_(parts_of(features)),
        members_(ways_of_multipolygons(context.osm)) {}

  void visit(OsmId id, source::Range tags) {
    if (tags.count == 0 || std::ranges::binary_search(read_, id)) return;
    const Box2 box = box_of_element(context_.osm, context_.plane, id);
    if (!box.touches(context_.extent)) return;
    account_.in += context_.report.counts(id);
    const source::Tag* tag = body_tag(context_, tags);
    if (tag == nullptr || (id.type == OsmType::kNode && is_about_a_line(context_, *tag)))
      account_.without_body += context_.report.counts(id);
    else if (is_part_of_relation(id, tags) || is_built_by_members(id) || is_built_by_parts(*tag, box))
      account_.merged += context_.report.counts(id);
    else
      drop(id, *tag, distance(box.min, box.max));
  }

  const Account& account() const { return account_; }

 private:
  void drop(OsmId id, const source::Tag& tag, double across_m) {
    const std::string &key = context_.osm.strings[tag.key], &value = context_.osm.strings[tag.value];
    context_.report.drop(account_, {Code::kUnknownKind, id, across_m, {}, {}, tag_text(key, value)});
  }

  // True for a way that says once more what a multipolygon is that it belongs to.
  bool is_part_of_relation(OsmId id, source::Range tags) const {
    if (id.type != OsmType::kWay) return false;
    return std::ranges::any_of(equal_span(members_, id.id, &WayTags::first), [&](const WayTags& way) {
      return source::are_one_thing(context_.osm, tags, way.second);
    });
  }

  // True for a relation that says once more what its members are: the ways of a river, the outline of a building.
  bool is_built_by_members(OsmId id) const {
    if (id.type != OsmType::kRelation) return false;
    const auto relation = std::ranges::lower_bound(context_.osm.relations, id.id, {}, &source::Relation::id);
    return std::ranges::any_of(
        std::span(context_.osm.members).subspan(relation->members.first, relation->members.count),
        [&](const source::Member& member) { return std::ranges::binary_search(built_, member.object); });
  }

  // True for a tower, or another work, in whose box parts of buildings make most of it.
  bool is_built_by_parts(const source::Tag& tag, const Box2& box) const {
    if (context_.osm.strings[tag.key] != "man_made") return false;
    const Box2 about = box.widened(kBesidePart_m);
    const double area_m2 = box.width() * box.height();
    double parts_m2 = 0;
    bool has_parts = false;
    for (const Footprint& part : parts_) {
      const Box2 part_box = box_of(part.polygon.outer);
      if (!about.contains(part_box.min) || !about.contains(part_box.max)) {
        has_parts = has_parts || (area_m2 == 0 && contains(part.polygon, box.min));
        continue;
      }
      has_parts = true, parts_m2 += std::abs(signed_area_m2(part.polygon.outer));
    }
    return has_parts && parts_m2 >= area_m2 / 2;
  }

  const ReadContext& context_;
  std::vector<OsmId> read_;
  std::vector<OsmId> built_;
  std::vector<Footprint> parts_;
  std::vector<WayTags> members_;
  Account account_;
};

}  // namespace

void diagnose_unread(const ReadContext& context, const Features& features) {
  UnreadElements unread(context, features);
  for (const source::Node& node : context.osm.nodes) unread.visit({OsmType::kNode, node.id}, node.tags);
  for (const source::Way& way : context.osm.ways)
    if (context.tag(way.tags, "natural") != "coastline") unread.visit({OsmType::kWay, way.id}, way.tags);
  for (const source::Relation& relation : context.osm.relations)
    if (context.tag(relation.tags, "boundary").empty()) unread.visit({OsmType::kRelation, relation.id}, relation.tags);
  context.report.account("map", "unread") = unread.account();
}

}  // namespace citykiln::map
