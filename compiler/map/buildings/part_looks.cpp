#include "compiler/map/buildings/part_looks.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/buildings/building_tags.h"
#include "compiler/map/buildings/part_outlines.h"

namespace citykiln::map {
namespace {

bool is_class(const Footprint& footprint, BuildingClass building) {
  return footprint.building_class == static_cast<std::uint8_t>(building);
}

// Takes one surface's colour and material where they are not said.
void complete_surface(const std::optional<Srgb>& whole_colour, const std::optional<materials::Material>& whole_material,
                      std::optional<Srgb>& colour, std::optional<materials::Material>& material) {
  if (material) return;
  material = whole_material;
  if (!colour) colour = whole_colour;
}

void complete_look(const Footprint& whole, Footprint& part) {
  if (is_class(part, BuildingClass::kPlain) && !whole.is_open && !is_class(whole, BuildingClass::kSteps)) {
    part.building_class = whole.building_class;
    part.has_shop |= whole.has_shop && part.min_height_m == 0;
  }
  if (part.year == 0) part.year = whole.year;
  complete_surface(whole.wall_colour, whole.wall_material, part.wall_colour, part.wall_material);
  complete_surface(whole.roof_colour, whole.roof_material, part.roof_colour, part.roof_material);
}

// A relation of type=building.
struct BuildingRelation {
  std::vector<OsmId> members;
  std::optional<Footprint> tagged;  // what its own tags say, if they describe a building
};

std::vector<BuildingRelation> relations_of(const ReadContext& context) {
  std::vector<BuildingRelation> relations;
  for (const source::Relation& relation : context.osm.relations) {
    if (context.tag(relation.tags, "type") != "building") continue;
    BuildingRelation building;
    for (std::uint32_t i = 0; i < relation.members.count; ++i)
      building.members.push_back(context.osm.members[relation.members.first + i].object);
    const BuildingValue value = building_value(context, relation.tags);
    const std::string_view text = value.text.empty() ? "yes" : value.text;
    building.tagged = read_building_tags(context, {OsmType::kRelation, relation.id}, relation.tags, text, 0);
    relations.push_back(std::move(building));
  }
  return relations;
}

// The footprints of each element.
std::multimap<OsmId, std::size_t> by_element(const std::vector<Footprint>& footprints) {
  std::multimap<OsmId, std::size_t> found;
  for (std::size_t i = 0; i < footprints.size(); ++i) found.emplace(footprints[i].id.osm, i);
  return found;
}

// The footprints of a relation's members.
std::vector<std::size_t> footprints_of(const BuildingRelation& relation,
                                       const std::multimap<OsmId, std::size_t>& by_id) {
  std::vector<std::size_t> found;
  for (const OsmId member : relation.members) {
    const auto [first, last] = by_id.equal_range(member);
    for (auto each = first; each != last; ++each) found.push_back(each->second);
  }
  return found;
}

// ---- parts unlike their outline
// --------------------------------------------------------------------------------------

bool has_any_tag(const ReadContext& context, source::Range tags, std::initializer_list<std::string_view> keys) {
  return std::ranges::any_of(keys, [&](std::string_view key) { return !context.tag(tags, key).empty(); });
}

bool is_unlike(const std::optional<Srgb>& colour, const std::optional<materials::Material>& material,
               const std::optional<Srgb>& whole_colour, const std::optional<materials::Material>& whole_material) {
  return colour != whole_colour || material != whole_material;
}

bool is_unlike_outline(const ReadContext& context, source::Range tags, const Footprint& part, const Footprint& whole) {
  const bool says_no_use = building_class_of(building_value(context, tags).text) == BuildingClass::kPlain;
  const bool has_use = !whole.is_open && !is_class(whole, BuildingClass::kSteps);
  if (says_no_use && has_use && part.building_class != whole.building_class) return true;
  if (!has_any_tag(context, tags, {"building:colour", "building:color", "building:material"}) &&
      is_unlike(part.wall_colour, part.wall_material, whole.wall_colour, whole.wall_material))
    return true;
  return !has_any_tag(context, tags, {"roof:colour", "roof:color", "roof:material"}) &&
         is_unlike(part.roof_colour, part.roof_material, whole.roof_colour, whole.roof_material);
}

}  // namespace

void complete_looks(const ReadContext& context, std::vector<Footprint>& footprints,
                    std::span<const std::uint32_t> outlines) {
  const std::vector<Footprint> as_tagged = footprints;
  const auto is_completed = [&](std::size_t i) {
    return footprints[i].is_part && !is_class(as_tagged[i], BuildingClass::kSteps);
  };
  const std::vector<BuildingRelation> relations = relations_of(context);
  const auto by_id = by_element(footprints);
  for (const BuildingRelation& relation : relations) {
    const std::vector<std::size_t> members = footprints_of(relation, by_id);
    const auto whole = std::ranges::find_if(members, [&](std::size_t i) { return !footprints[i].is_part; });
    for (const std::size_t i : members)
      if (whole != members.end() && is_completed(i)) complete_look(as_tagged[*whole], footprints[i]);
  }
  for (std::size_t i = 0; i < outlines.size(); ++i)
    if (outlines[i] != kNoOutline && is_completed(i)) complete_look(as_tagged[outlines[i]], footprints[i]);
  for (const BuildingRelation& relation : relations)
    for (const std::size_t i : footprints_of(relation, by_id))
      if (!footprints[i].is_part || is_completed(i)) complete_look(*relation.tagged, footprints[i]);
}

void diagnose_unlike_parts(const ReadContext& context, std::span<const Footprint> footprints) {
  std::map<OsmId, source::Range> tags;
  for (const source::Area& area : context.osm.areas) tags.emplace(area.from, area.tags);
  std::set<OsmId> in_relations;
  for (const BuildingRelation& relation : relations_of(context))
    in_relations.insert(relation.members.begin(), relation.members.end());
  std::map<ObjectId, const Footprint*> by_id;
  for (const Footprint& footprint : footprints) by_id.emplace(footprint.id, &footprint);
  for (const Footprint& part : footprints) {
    if (!part.is_part || !part.outline || is_class(part, BuildingClass::kSteps)) continue;
    const auto whole = by_id.find(*part.outline);
    const auto own = tags.find(part.id.osm);
    if (whole == by_id.end() || own == tags.end() || in_relations.contains(part.id.osm)) continue;
    if (is_unlike_outline(context, own->second, part, *whole->second))
      context.report.add(Code::kPartUnlikeOutline, part.id.osm);
  }
}

}  // namespace citykiln::map
