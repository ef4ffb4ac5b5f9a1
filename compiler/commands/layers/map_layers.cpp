#include "compiler/commands/layers/map_layers.h"

#include <fmt/format.h>

#include "compiler/commands/layers/road_properties.h"
#include "compiler/geometry/polygons/clip_polygon.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/roads/junctions/layers.h"
#include "compiler/roads/roads_on_ground.h"

namespace citykiln::commands {
namespace {

void add_name(Properties& properties, const map::Features& features, ObjectId id) {
  if (const map::ElementText* text = map::find_text(features.texts, id.osm)) properties.add("name", text->name);
}

Layer mapped_roads(const map::Features& features) {
  Layer layer;
  for (const map::Track& track : features.tracks) {
    LayerFeature& road =
        layer.emplace_back(LayerFeature{track.id, class_of(track.surface), GeometryKind::kLine, {{flat(track.axis)}}});
    add_name(road.properties, features, track.id);
    add_section(road.properties, track.section);
    add_surface(road.properties, track.surface);
    add_layer_and_passage(road.properties, track.layer, track.passage);
    road.properties.add("oneway", track.is_oneway), road.properties.add("lit", track.is_lit);
  }
  return layer;
}

// Adds a feature, unless its polygons have no area.
LayerFeature* add_flat_polygons(Layer& layer, ObjectId id, std::string kind, std::span<const Polygon> polygons) {
  if (polygons.empty()) return nullptr;
  return &layer.emplace_back(LayerFeature{id, std::move(kind), GeometryKind::kPolygon, flat(polygons)});
}

Layer mapped_areas(const map::Features& features) {
  Layer layer;
  for (const map::AreaFeature& area : features.areas) {
    const std::vector<Polygon> inside = united_in(copied_rings(area.polygon), features.extent);
    LayerFeature* feature = add_flat_polygons(layer, area.id, class_of(area.surface), inside);
    if (feature == nullptr) continue;
    add_name(feature->properties, features, area.id);
    add_surface(feature->properties, area.surface);
    feature->properties.add("area_m2", area.area_m2);
  }
  return layer;
}

void add_mapped_building(Properties& properties, const map::Footprint& building) {
  properties.add("is_part", building.is_part), properties.add("has_parts", building.has_parts);
  if (building.levels > 0) properties.add("levels", building.levels);
  if (building.has_roof_shape) properties.add("roof", roofs::name_of(building.roof.form));
  if (building.min_height_m > 0) properties.add("min_height_m", building.min_height_m);
  properties.add("height_m", building.height_m);
  if (building.year > 0) properties.add("year", building.year);
  properties.add("shop", building.has_shop);
}

Layer mapped_buildings(const map::Features& features) {
  Layer layer;
  for (const map::Footprint& building : features.footprints) {
    const auto kind = map::word_of(static_cast<map::BuildingClass>(building.building_class));
    LayerFeature* feature =
        add_flat_polygons(layer, building.id, std::string(kind), united(copied_rings(building.polygon)));
    if (feature == nullptr) continue;
    add_name(feature->properties, features, building.id);
    add_mapped_building(feature->properties, building);
  }
  return layer;
}

Layer mapped_plants(const map::Features& features) {
  Layer layer;
  for (const map::PointFeature& point : features.points) {
    if (point.kind != map::PointKind::kTree) continue;
    const char* kind = point.plant_tags.leaves == map::LeafType::kNeedle ? "NeedleLeaved" : "BroadLeaved";
    LayerFeature& plant =
        layer.emplace_back(LayerFeature{point.id, kind, GeometryKind::kPoint, {{flat(std::span(&point.at, 1))}}});
    add_name(plant.properties, features, point.id);
    if (point.height_m > 0) plant.properties.add("height_m", point.height_m);
  }
  return layer;
}

// Adds junction outlines in the order of the junctions, with the ids of their main roads.
void add_junctions(const roads::RoadLayer& network, const map::Features& features, Layer& layer) {
  const auto outlines = roads::outline_junctions(network.junctions, network.roads, 0);
  const auto arms = roads::arms_of(network.junctions, network.roads);
  for (std::size_t j = 0; j < network.junctions.size(); ++j) {
    const roads::Road& main = roads::main_road(network.roads, arms[j]);
    LayerFeature* junction = add_flat_polygons(layer, main.id, class_of(main.surface), outlines[j]);
    if (junction == nullptr) continue;
    add_name(junction->properties, features, main.id);
    add_layer_and_passage(junction->properties, network.layer, network.passage);
  }
}

Layer mapped_junctions(const map::Features& features) {
  Report ignored;
  Layer layer;
  roads::RoadLayer ground;
  ground.roads = roads::roads_on_ground(features, ignored);
  ground.junctions = roads::plan_junctions(ground.roads, ignored);
  add_junctions(ground, features, layer);
  for (const roads::RoadLayer& network : roads::plan_layers(features, ignored)) add_junctions(network, features, layer);
  return layer;
}

}  // namespace

Result<Layer> layer_of(const map::Features& features, const std::string& name) {
  if (name == "roads") return mapped_roads(features);
  if (name == "areas") return mapped_areas(features);
  if (name == "buildings") return mapped_buildings(features);
  if (name == "plants") return mapped_plants(features);
  if (name == "junctions") return mapped_junctions(features);
  return Error{"--layer", fmt::format("expected {}, found \"{}\"", layer_names(), name)};
}

}  // namespace citykiln::commands
