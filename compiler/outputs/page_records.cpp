#include "compiler/outputs/page_records.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "compiler/bake/feature_attributes.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/buildings/styles/style.h"
#include "compiler/contract/derived_id.h"
#include "compiler/geometry/box.h"
#include "compiler/map/plane/globe.h"
#include "compiler/scene/kinds.h"

namespace citykiln::outputs {
namespace {

using exporters::FeatureRecord;
using exporters::FeatureRecords;
using Recipe = std::vector<std::pair<std::string, exporters::PageValue>>;

std::string text(std::string_view view) { return std::string(view); }
std::string material_name(materials::Material material) { return text(materials::values_of(material).name); }

Recipe recipe_of(const buildings::Building& b) {
  const double foot_m = b.stands_on_ground ? b.floor_m : b.bottom_m;
  Recipe recipe = {{"style", text(buildings::rule_file_of(b.style))},
                   {"storeys", std::int64_t{b.levels}},
                   {"eaves_m", buildings::eaves_m(b) - foot_m},
                   {"top_m", b.top_m - foot_m},
                   {"roof", text(roofs::name_of(b.roof_shape.form))},
                   {"wall", material_name(b.wall)},
                   {"roof_material", material_name(b.roof)},
                   {"corners", static_cast<std::int64_t>(b.footprint.outer.size())},
                   {"party_walls", static_cast<std::int64_t>(b.party_walls.size())}};
  if (b.year > 0) recipe.emplace_back("year", std::int64_t{b.year});
  if (b.has_shop) recipe.emplace_back("shop", true);
  if (!b.fronts.empty()) recipe.emplace_back("shop_fronts", static_cast<std::int64_t>(b.fronts.size()));
  return recipe;
}

Recipe recipe_of(const roads::Road& road) {
  const auto& values = map::values_of(road.surface);
  return {{"lanes", map::to_string(road.section)},
          {"carriageway_m", map::carriageway_width_m(road.section)},
          {"width_m", map::total_width_m(road.section)},
          {"surface", material_name(values.material)},
          {"lit", road.is_lit}};
}

Recipe recipe_of(const structures::Span& span) {
  Recipe recipe = recipe_of(static_cast<const roads::Road&>(span));
  recipe.emplace_back("layer", std::int64_t{span.layer});
  if (!span.piers.empty()) recipe.emplace_back("piers", static_cast<std::int64_t>(span.piers.size()));
  return recipe;
}

Recipe recipe_of(const roads::Strip& strip) {
  return {{"width_m", strip.left_m + strip.right_m},
          {"surface", material_name(map::values_of(strip.surface).material)}};
}

Recipe recipe_of(const props::Barrier& barrier) {
  return {{"kind", text(map::name_of(barrier.kind))}, {"height_m", barrier.height_m}, {"width_m", barrier.width_m}};
}

Recipe plant_recipe(const plants::SpeciesTable& species, plants::SpeciesMix mix, double height_m) {
  Recipe recipe = {{"species", plants::name_of(species, mix)}};
  if (height_m > 0) recipe.emplace_back("height_m", height_m);
  return recipe;
}

Recipe recipe_of(const props::Lamp& lamp) { return {{"kind", text("street lamp")}, {"height_m", lamp.height_m}}; }

Recipe recipe_of(const things::Thing& thing) {
  const things::Form& form = thing.form;
  return {{"kind", form.kind},
          {"width_m", form.width_m},
          {"depth_m", form.depth_m},
          {"height_m", form.height_m},
          {"faces_deg", static_cast<std::int64_t>(thing.direction * 360 / things::kDirections)}};
}

Recipe recipe_of(const wires::WireSpan& span) {
  return {{"wires", static_cast<std::int64_t>(span.wires.size())}, {"above_ground_m", span.above_m}};
}

Recipe recipe_of(const ground::LandCoverPolygon& polygon) {
  Recipe recipe = {{"surface", material_name(map::values_of(polygon.surface).material)}};
  if (polygon.area_m2 > ground::kPassedJunctionArea_m2)
    recipe.emplace_back("area_m2", static_cast<std::int64_t>(polygon.area_m2));
  if (polygon.level_m) recipe.emplace_back("level_m", *polygon.level_m);
  return recipe;
}

Box2 box_of_recipe(const buildings::Building& b) { return box_of(b.footprint.outer); }
Box2 box_of_recipe(const ground::LandCoverPolygon& polygon) { return ground::box_of(polygon); }
Box2 box_of_recipe(const wires::WireSpan& span) {
  Box2 box;
  for (const wires::Wire& wire : span.wires) box.grow(in_plan(wire.from)), box.grow(in_plan(wire.to));
  return box;
}
template <typename Object>
Box2 box_of_recipe(const Object& object) {
  Box2 box;
  if constexpr (requires { object.axis; })
    box = box_of(object.axis);
  else
    box.grow(object.at);
  return box;
}

template <typename Object>
Vec2 place_of(const Object& object) {
  if constexpr (requires { object.axis; }) return object.axis[object.axis.size() / 2];
  return box_of_recipe(object).centre();
}

/// Adds the records of one chunk after another.
class RecordMaker {
 public:
  RecordMaker(const scene::Header& header, const map::Geoid& geoid)
      : geoid_(geoid),
        globe_(header.origin),
        classes_(bake::PrototypeCache(header).thing_classes()),
        species_(header.species) {}

  void add(const scene::Chunk& chunk) {
    chunk_ = &chunk;
    own_.clear();
    scene::for_each_element_kind(chunk, [&](std::string_view, const auto& objects) {
      for (const auto& object : objects) add(object);
    });
    add_attributes();
  }

  FeatureRecords records;

 private:
  void add(const buildings::Building& b) { add_object(b, (b.floor_m + b.top_m) / 2); }
  // dykes and cliffs have no record
  void add(const ground::Landform&) {}
  // floors of buildings are not elements; they lie in tiles beside the building's, too
  void add(const ground::LandCoverPolygon& polygon) {
    if (polygon.surface != map::LandCoverClass::kBuilding && !is_derived(polygon.id)) add_object(polygon, std::nullopt);
  }
  template <typename Object>
  void add(const Object& object) {
    if (!is_derived(object.id)) add_object(object, std::nullopt);
  }

  // @param z_m  Plane height of the middle; on the ground if empty.
  template <typename Object>
  void add_object(const Object& object, std::optional<double> z_m) {
    const OsmId id = object.id.osm;
    if (id.type == OsmType::kNone) return;
    own_.push_back(id);
    const auto [found, is_new] = records.try_emplace(id);
    if (!is_new) return;
    const Box2 box = box_of_recipe(object);
    const Vec2 at = place_of(object);
    const double height_m = z_m.value_or(map::height_m_at(chunk_->heights, at)) + map::height_m(geoid_, at);
    found->second.at = globe_.at({at.x, at.y, height_m}).at;
    found->second.size_m = std::sqrt(box.width() * box.width() + box.height() * box.height());
    if constexpr (requires { object.species_mix; })
      found->second.recipe = plant_recipe(species_, object.species_mix, object.height_m);
    else if constexpr (requires { recipe_of(object); })
      found->second.recipe = recipe_of(object);
  }

  void add_attributes() {
    std::ranges::sort(own_);
    own_.erase(std::unique(own_.begin(), own_.end()), own_.end());
    const std::vector<bake::FeatureAttributes> rows = bake::attributes_of(*chunk_, own_, classes_, species_);
    for (std::size_t i = 0; i < own_.size(); ++i) {
      FeatureRecord& record = records.at(own_[i]);
      if (record.kind.empty()) record.kind = rows[i].kind;
      record.name = rows[i].name, record.tags = rows[i].tags;
      record.height_m = std::max(record.height_m, static_cast<double>(rows[i].height_m));
      record.assumed |= rows[i].assumed;
    }
  }

  const map::Geoid& geoid_;
  map::Globe globe_;
  bake::ThingClasses classes_;
  plants::SpeciesTable species_;
  const scene::Chunk* chunk_ = nullptr;
  std::vector<OsmId> own_;  ///< The elements of the chunk.
};

}  // namespace

FeatureRecords page_records(const scene::Scene& scene, const map::Geoid& geoid) {
  RecordMaker maker(scene.header, geoid);
  for (const scene::Chunk& chunk : scene.chunks) maker.add(chunk);
  return std::move(maker.records);
}

}  // namespace citykiln::outputs
