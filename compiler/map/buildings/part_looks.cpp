#include "compiler/map/buildings/part_looks.h"

#include <algorithm>
#include <map>
#include <optional>

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

}  // namespace citykiln::map
