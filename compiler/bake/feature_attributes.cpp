#include "compiler/bake/feature_attributes.h"

#include <algorithm>
#include <array>

#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/land_cover_class.h"
#include "compiler/things/contact_masts.h"

namespace citykiln::bake {
namespace {

// The attributes while recipes add to them.
struct Table {
  std::span<const OsmId> features;
  std::vector<FeatureAttributes> rows;

  void add(OsmId id, std::string_view kind, double height_m = 0, Assumptions assumed = kNoAssumptions) {
    const auto found = std::ranges::lower_bound(features, id);
    if (found == features.end() || *found != id) return;
    FeatureAttributes& row = rows[static_cast<std::size_t>(found - features.begin())];
    if (row.kind.empty()) row.kind = kind;
    row.height_m = std::max(row.height_m, static_cast<float>(height_m));
    row.assumed |= assumed;
  }
};

template <typename Road>
void add_roads(Table& table, const std::vector<Road>& roads) {
  for (const Road& road : roads) table.add(road.id.osm, map::values_of(road.surface).name, 0, road.assumed);
}

template <typename Object>
void add_covers(Table& table, const std::vector<Object>& objects) {
  for (const Object& object : objects) table.add(object.id.osm, map::values_of(object.surface).name);
}

// Yards have the id of a building, which may be in another chunk.
Assumptions assumption_of(const ground::LandCoverPolygon& surface) {
  return surface.id.part >= map::kDerivedPart ? bit_of(Assumption::kYards) : kNoAssumptions;
}

void add_buildings(Table& table, const std::vector<buildings::Building>& buildings) {
  for (const buildings::Building& b : buildings)
    table.add(b.id.osm, map::word_of(static_cast<map::BuildingClass>(b.building_class)),
              b.top_m - (b.stands_on_ground ? b.floor_m : b.bottom_m), b.assumed);
}

template <typename Plant>
void add_plants(Table& table, const std::vector<Plant>& plants, const plants::SpeciesTable& species) {
  for (const Plant& plant : plants)
    if (plant.id.part >= map::kDerivedPart)
      table.add(plant.id.osm, "", 0, bit_of(Assumption::kYards));  // of a building
    else
      table.add(plant.id.osm, name_of(species, plant.species_mix), plant.height_m);
}

std::string_view class_of_thing(const ThingClasses& classes, const std::string& kind) {
  const auto found = classes.find(kind);
  return found == classes.end() ? std::string_view(kind) : std::string_view(found->second);
}

void add_texts(Table& table, std::span<const map::ElementText> texts) {
  for (std::size_t i = 0; i < table.features.size(); ++i) {
    const map::ElementText* text = map::find_text(texts, table.features[i]);
    if (text != nullptr) table.rows[i].name = text->name, table.rows[i].tags = text->tags;
  }
}

}  // namespace

std::vector<FeatureAttributes> attributes_of(const scene::Chunk& chunk, std::span<const OsmId> features,
                                             const ThingClasses& classes, const plants::SpeciesTable& species) {
  Table table{features, std::vector<FeatureAttributes>(features.size())};
  add_buildings(table, chunk.buildings);
  add_roads(table, chunk.bridges), add_roads(table, chunk.tunnels), add_roads(table, chunk.roads);
  add_covers(table, chunk.watercourses), add_covers(table, chunk.landforms);
  for (const props::Barrier& b : chunk.barriers)
    if (b.kind == map::BarrierKind::kRailing)
      table.add(b.id.osm, "", 0, bit_of(Assumption::kRailings));  // of an element that is walked on
    else if (b.id.part >= map::kDerivedPart)
      table.add(b.id.osm, "", 0, bit_of(Assumption::kYards));  // of a building
    else
      table.add(b.id.osm, map::name_of(b.kind), b.height_m);
  add_plants(table, chunk.trees, species), add_plants(table, chunk.tree_rows, species);
  for (const props::Lamp& lamp : chunk.lamps) table.add(lamp.id.osm, "StreetLamp", lamp.height_m);
  // equipment of a sports field belongs to the field's area
  for (const things::Thing& thing : chunk.things)
    if (things::is_contact_kind(thing.form.kind) && thing.id.part >= map::kDerivedPart)
      table.add(thing.id.osm, "", 0, bit_of(Assumption::kMasts));  // of the track
    else if (thing.id.part < map::kDerivedPart)
      table.add(thing.id.osm, class_of_thing(classes, thing.form.kind), thing.form.height_m);
  for (const wires::WireSpan& span : chunk.wire_spans) {
    if (span.id.part >= map::kDerivedPart) {
      table.add(span.id.osm, "", 0, bit_of(Assumption::kMasts));
      continue;
    }
    const bool is_aerialway = span.wires.front().kind == wires::WireKind::kCable;
    table.add(span.id.osm, is_aerialway ? "Aerialway" : "PowerLine", span.above_m);
  }
  for (const ground::LandCoverPolygon& surface : chunk.surfaces)
    table.add(surface.id.osm, map::values_of(surface.surface).name, 0, assumption_of(surface));
  add_texts(table, chunk.texts);
  return std::move(table.rows);
}

}  // namespace citykiln::bake
