#include "compiler/source/owned_elements.h"

#include <algorithm>

#include "compiler/source/closing_ring.h"

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

}  // namespace

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

}  // namespace citykiln::source
