#include "compiler/regions/region_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <osmium/osm/node.hpp>
#include <osmium/osm/relation.hpp>
#include <osmium/osm/way.hpp>
#include <vector>

#include "compiler/regions/area_tags.h"
#include "compiler/source/closing_ring.h"

namespace citykiln::regions {
namespace {

using Objects = std::span<const osmium::OSMObject* const>;

Vec2 place_of(osmium::Location location) { return {location.lon(), location.lat()}; }

/// Measures the share of a box that an area covers, by the crossings of its outline with parallels.
class SampledArea {
 public:
  explicit SampledArea(const Box2& box) : box_(box) {}

  void add(const osmium::Way& way) {
    Vec2 last;
    bool has_last = false;
    for (const osmium::NodeRef& node : way.nodes()) {
      if (!node.location().valid()) continue;
      const Vec2 at = place_of(node.location());
      if (has_last) add_edge(last, at);
      last = at, has_last = true;
    }
  }

  /// Returns the share of the box inside the area, by the even-odd rule. A crossing without a partner is left out.
  double share() {
    double inside = 0;
    for (std::vector<double>& row : crossings_) {
      std::ranges::sort(row);
      for (std::size_t i = 1; i < row.size(); i += 2)
        inside += std::max(0.0, std::min(row[i], box_.max.x) - std::max(row[i - 1], box_.min.x));
    }
    return inside / (box_.width() * kRows);
  }

 private:
  static constexpr int kRows = 64;

  // rows lie in the middles of equal strips
  double row_of(double y) const { return (y - box_.min.y) / box_.height() * kRows - 0.5; }

  void add_edge(Vec2 a, Vec2 b) {
    if (a.y > b.y) std::swap(a, b);
    const double first = std::max(0.0, std::ceil(row_of(a.y))), end = std::min<double>(kRows, std::ceil(row_of(b.y)));
    for (double row = first; row < end; ++row) {
      const double t = (row - row_of(a.y)) / (row_of(b.y) - row_of(a.y));
      crossings_[static_cast<std::size_t>(row)].push_back(a.x + t * (b.x - a.x));
    }
  }

  Box2 box_;
  std::array<std::vector<double>, kRows> crossings_;
};

const osmium::Way* way_of(Objects sorted, osmium::object_id_type id) {
  const auto is_before = [&](const osmium::OSMObject* object) {
    return object->type() < osmium::item_type::way || (object->type() == osmium::item_type::way && object->id() < id);
  };
  const auto found = std::ranges::partition_point(sorted, is_before);
  const bool is_there = found != sorted.end() && (*found)->type() == osmium::item_type::way && (*found)->id() == id;
  return is_there ? static_cast<const osmium::Way*>(*found) : nullptr;
}

/// Returns the ways of an area's outline; none for a way that is not closed.
std::vector<const osmium::Way*> outline_of(const osmium::OSMObject& object, Objects sorted) {
  std::vector<const osmium::Way*> outline;
  if (object.type() == osmium::item_type::way) {
    const auto& way = static_cast<const osmium::Way&>(object);
    if (way.is_closed()) outline.push_back(&way);
  } else {
    const auto& relation = static_cast<const osmium::Relation&>(object);
    const bool is_closed = source::has_closing_rings(relation);
    for (const osmium::RelationMember& member : relation.members())
      if (member.type() == osmium::item_type::way && source::is_closing_ring(member) == is_closed)
        if (const osmium::Way* way = way_of(sorted, member.ref())) outline.push_back(way);
  }
  return outline;
}

void count_plants(const osmium::OSMObject& object, Objects sorted, const Box2& own_deg, double own_m2,
                  RegionFile& file) {
  const PlantDensity density = plant_density(object.tags());
  if (density.trees_per_m2 == 0 && density.plantings_per_m2 == 0) return;
  SampledArea area(own_deg);
  for (const osmium::Way* way : outline_of(object, sorted)) area.add(*way);
  const double area_m2 = area.share() * own_m2;
  file.own_trees += static_cast<std::uint64_t>(area_m2 * density.trees_per_m2);
  file.own_plantings += static_cast<std::uint64_t>(area_m2 * density.plantings_per_m2);
}

void count_way(const osmium::Way& way, const Box2& own_deg, RegionFile& file) {
  ++file.ways;
  const bool is_building = describes_building(way.tags()), is_road = way.tags().has_key("highway");
  for (const osmium::NodeRef& node : way.nodes()) {
    ++file.way_nodes;
    if (!node.location().valid() || !own_deg.contains(place_of(node.location()))) continue;
    ++file.own_way_nodes;
    file.own_building_nodes += is_building, file.own_road_nodes += is_road;
  }
}

}  // namespace

RegionFile contents_of(Objects sorted, const Box2& own_deg, double own_m2) {
  RegionFile file;
  for (const osmium::OSMObject* object : sorted) {
    if (object->type() == osmium::item_type::node) {
      ++file.nodes;
      file.own_nodes += own_deg.contains(place_of(static_cast<const osmium::Node*>(object)->location()));
      continue;
    }
    if (object->type() == osmium::item_type::way)
      count_way(static_cast<const osmium::Way&>(*object), own_deg, file);
    else
      ++file.relations;
    count_plants(*object, sorted, own_deg, own_m2, file);
  }
  return file;
}

}  // namespace citykiln::regions
