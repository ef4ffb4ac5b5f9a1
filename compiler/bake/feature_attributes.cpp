#include "compiler/bake/feature_attributes.h"

#include <algorithm>
#include <string_view>

#include "compiler/contract/derived_id.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/land_cover_class.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/scene/kinds.h"

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

std::string_view class_of_thing(const ThingClasses& classes, const std::string& kind) {
  const auto found = classes.find(kind);
  return found == classes.end() ? std::string_view(kind) : std::string_view(found->second);
}

// Adds what recipes say of their elements. A derived recipe only marks its element as assumed.
struct Describer {
  Table& table;
  const ThingClasses& classes;
  const plants::SpeciesTable& species;

  void add(const buildings::Building& b) {
    table.add(b.id.osm, map::word_of(static_cast<map::BuildingClass>(b.building_class)),
              b.top_m - (b.stands_on_ground ? b.floor_m : b.bottom_m), b.assumed);
  }
  void add(const roads::Road& road) { table.add(road.id.osm, map::values_of(road.surface).name, 0, road.assumed); }
  void add(const roads::Strip& strip) { table.add(strip.id.osm, map::values_of(strip.surface).name); }
  void add(const props::Barrier& b) {
    if (b.kind == map::BarrierKind::kRailing)
      table.add(b.id.osm, "", 0, bit_of(Assumption::kRailings));  // of an element that is walked on
    else if (is_of_roadside(b.id))
      table.add(b.id.osm, "", 0, bit_of(Assumption::kRoadsides));  // of a road
    else if (is_of_field(b.id))
      table.add(b.id.osm, "", 0, bit_of(Assumption::kFields));  // of farmland
    else if (is_derived(b.id))
      table.add(b.id.osm, "", 0, bit_of(Assumption::kYards));  // of a building
    else
      table.add(b.id.osm, map::name_of(b.kind), b.height_m);
  }
  // trees and rows
  template <typename Plant>
  requires requires(Plant plant) { plant.species_mix; }
  void add(const Plant& plant) {
    if (is_derived(plant.id))
      table.add(plant.id.osm, "", 0, bit_of(Assumption::kYards));  // of a building
    else
      table.add(plant.id.osm, name_of(species, plant.species_mix), plant.height_m);
  }
  void add(const props::Lamp& lamp) { table.add(lamp.id.osm, "StreetLamp", lamp.height_m); }
  // equipment of a sports pitch belongs to the pitch's area
  void add(const things::Thing& thing) {
    if (map::is_contact(map::role_of(thing.form.kind)) && is_derived(thing.id))
      table.add(thing.id.osm, "", 0, bit_of(Assumption::kMasts));  // of the track
    else if (!is_derived(thing.id))
      table.add(thing.id.osm, class_of_thing(classes, thing.form.kind), thing.form.height_m);
  }
  void add(const wires::WireSpan& span) {
    const bool is_aerialway = span.wires.front().kind == wires::WireKind::kCable;
    if (is_derived(span.id))
      table.add(span.id.osm, "", 0, bit_of(Assumption::kMasts));
    else
      table.add(span.id.osm, is_aerialway ? "Aerialway" : "PowerLine", span.above_m);
  }
  // yards have the id of a building, which may be in another chunk
  void add(const ground::LandCoverPolygon& surface) {
    const Assumptions assumed = map::is_field(surface.surface) ? bit_of(Assumption::kFields)
                                : is_derived(surface.id)       ? bit_of(Assumption::kYards)
                                                               : kNoAssumptions;
    table.add(surface.id.osm, map::values_of(surface.surface).name, 0, assumed);
  }
};

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
  Describer describer{table, classes, species};
  scene::for_each_element_kind(chunk, [&]<typename Object>(std::string_view kind, const std::vector<Object>& objects) {
    for (const Object& object : objects)
      if constexpr (requires { describer.add(object); })
        describer.add(object);
      else
        table.add(object.id.osm, kind);  // a kind that says no more of its elements
  });
  add_texts(table, chunk.texts);
  return std::move(table.rows);
}

}  // namespace citykiln::bake
