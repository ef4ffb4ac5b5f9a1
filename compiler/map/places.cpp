#include "compiler/map/places.h"

#include <algorithm>
#include <optional>
#include <set>

namespace citykiln::map {
namespace {

LonLat lonlat_of(source::Location at) { return {at.lon_deg(), at.lat_deg()}; }

template <typename Element>
const Element* with_id(const std::vector<Element>& elements, std::int64_t id) {
  const auto found = std::ranges::lower_bound(elements, id, {}, &Element::id);
  return found != elements.end() && found->id == id ? &*found : nullptr;
}

std::optional<LonLat> centre_of(const source::OsmData& osm, const source::Area& area) {
  if (area.rings.count == 0) return std::nullopt;
  const auto points = osm.points_of(osm.rings_of(area).front());
  if (points.empty()) return std::nullopt;
  const auto [west, east] = std::ranges::minmax(points, {}, &source::Location::lon_e7);
  const auto [south, north] = std::ranges::minmax(points, {}, &source::Location::lat_e7);
  return LonLat{(west.lon_deg() + east.lon_deg()) / 2, (south.lat_deg() + north.lat_deg()) / 2};
}

std::optional<LonLat> place_of_object(const source::OsmData& osm, OsmId object) {
  if (object.type == OsmType::kNode) {
    const source::Node* node = with_id(osm.nodes, object.id);
    return node != nullptr ? std::optional(lonlat_of(node->at)) : std::nullopt;
  }
  if (object.type == OsmType::kWay) {
    const source::Way* way = with_id(osm.ways, object.id);
    if (way != nullptr && way->nodes.count > 0) return lonlat_of(osm.nodes_of(*way)[way->nodes.count / 2].at);
  }
  const auto area = std::ranges::lower_bound(osm.areas, object, {}, &source::Area::from);
  if (area != osm.areas.end() && area->from == object) return centre_of(osm, *area);
  return std::nullopt;
}

/// The place of the first member that has one. Members that are relations are not followed.
std::optional<LonLat> place_of_members(const source::OsmData& osm, const source::Relation& relation) {
  for (std::uint32_t i = 0; i < relation.members.count; ++i) {
    const OsmId member = osm.members[relation.members.first + i].object;
    if (const auto at = place_of_object(osm, member)) return at;
  }
  return std::nullopt;
}

void grow(Box2& box, const source::OsmData& osm, const Plane& plane, OsmId object) {
  if (object.type == OsmType::kNode) {
    if (const source::Node* node = with_id(osm.nodes, object.id)) box.grow(plane.forward(lonlat_of(node->at)));
  } else if (object.type == OsmType::kWay) {
    const source::Way* way = with_id(osm.ways, object.id);
    if (way == nullptr) return;
    for (const source::NodeRef& node : osm.nodes_of(*way)) box.grow(plane.forward(lonlat_of(node.at)));
  }
}

}  // namespace

Box2 box_of_element(const source::OsmData& osm, const Plane& plane, OsmId object) {
  Box2 box;
  grow(box, osm, plane, object);
  const source::Relation* relation = object.type == OsmType::kRelation ? with_id(osm.relations, object.id) : nullptr;
  if (relation == nullptr) return box;
  for (const source::Member& member : std::span(osm.members).subspan(relation->members.first, relation->members.count))
    grow(box, osm, plane, member.object);
  return box;
}

void remove_diagnoses_outside(const source::OsmData& osm, const Plane& plane, const Box2& extent, Report& report) {
  report.remove_diagnoses_if([&](const Diagnosis& diagnosis) {
    // a box can touch the extent that its element does not reach
    if (diagnosis.code == Code::kOutsideBounds) return true;
    if (diagnosis.object.type == OsmType::kNone || diagnosis.code == Code::kStrayNode) return false;
    const Box2 box = box_of_element(osm, plane, diagnosis.object);
    return box.min.x <= box.max.x && !box.touches(extent);
  });
}

Places places_of(const source::OsmData& osm, const Report& report) {
  std::set<OsmId> named;
  for (const Diagnosis& diagnosis : report.diagnoses()) named.insert(diagnosis.object);
  Places places;
  for (const OsmId object : named) {
    std::optional<LonLat> at = place_of_object(osm, object);
    const source::Relation* relation =
        !at && object.type == OsmType::kRelation ? with_id(osm.relations, object.id) : nullptr;
    if (relation != nullptr) at = place_of_members(osm, *relation);
    if (at) places.emplace(object, *at);
  }
  return places;
}

Places places_of_ways_and_areas(const source::OsmData& osm) {
  Places places;
  const auto add = [&](OsmId object) {
    if (const auto at = place_of_object(osm, object)) places.emplace_hint(places.end(), object, *at);
  };
  for (const source::Way& way : osm.ways) add({OsmType::kWay, way.id});
  for (const source::Area& area : osm.areas) add(area.from);
  return places;
}

}  // namespace citykiln::map
