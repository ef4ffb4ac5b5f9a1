#include "compiler/buildings/styles/building_materials.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "compiler/buildings/styles/mixed_styles.h"
#include "compiler/buildings/styles/paint_colour.h"
#include "compiler/buildings/styles/regional_styles.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::buildings {
namespace {

using map::BuildingClass;
using materials::Material;
using materials::Tint;

struct Row {
  BuildingClass building_class;
  Material wall, other_wall;
  std::uint32_t other_percent;
  Material pitched_roof, flat_roof;
};

constexpr Row kRows[] = {
#define BUILDING_MATERIALS(building, wall, other, percent, pitched, flat) \
  {BuildingClass::building, Material::wall, Material::other, percent, Material::pitched, Material::flat},
#include "compiler/buildings/styles/building_materials.inc"
#undef BUILDING_MATERIALS
};
static_assert(std::size(kRows) == static_cast<std::size_t>(BuildingClass::kCount));
static_assert([] {
  for (std::size_t i = 0; i < std::size(kRows); ++i)
    if (static_cast<std::size_t>(kRows[i].building_class) != i) return false;
  return true;
}());

const Row& materials_row(std::uint8_t building_class) {
  assert(building_class < std::size(kRows));
  return kRows[building_class];
}

// Towns of the Netherlands are of brick, where others around are of plaster: an estimate.
std::uint32_t other_percent(const Row& row, const map::Footprint& footprint) {
  constexpr std::uint32_t kBrickOfNetherlands = 85;
  const bool is_brick =
      row.other_wall == Material::kBrick && footprint.tradition == map::BuildingTradition::kNetherlands;
  return is_brick ? kBrickOfNetherlands : row.other_percent;
}

Material untagged_wall(const map::Footprint& footprint) {
  const Row& row = materials_row(footprint.building_class);
  if (footprint.height_m > kGlassTower_m && row.wall != Material::kStone) return Material::kGlassFacade;
  const bool is_other =
      RandomSequence(0, stable_id(footprint.id), "wall").below(100, 0) < other_percent(row, footprint);
  return is_other ? row.other_wall : row.wall;
}

Material untagged_roof(const map::Footprint& footprint, roofs::RoofForm form) {
  const Row& row = materials_row(footprint.building_class);
  return form == roofs::RoofForm::kFlat ? row.flat_roof : row.pitched_roof;
}

std::uint32_t percent_drawn(const map::Footprint& footprint, const char* purpose) {
  return static_cast<std::uint32_t>(RandomSequence(0, stable_id(footprint.id), purpose).below(100, 0));
}

// Styles of glass keep it: towers of glass look alike everywhere.
Material regional_untagged_wall(const map::Footprint& footprint, Style style) {
  const std::uint32_t percent = percent_drawn(footprint, "regional wall");
  const Material usual = mixed_wall(style, untagged_wall(footprint), percent);
  if (usual == Material::kGlassFacade) return usual;
  return regional_wall(footprint.country, style, usual, percent);
}

Material regional_untagged_roof(const map::Footprint& footprint, roofs::RoofForm form) {
  const Material usual = untagged_roof(footprint, form);
  if (usual != Material::kRoofTile) return usual;
  return regional_roof(footprint.country, percent_drawn(footprint, "regional roof"));
}

Material material_for(const std::optional<map::Srgb>& colour, std::initializer_list<Material> choice) {
  return colour ? tintable_material(paint_reflectance(*colour), choice) : *choice.begin();
}

// The tagged materials or those given, or lighter ones that show the tagged colours.
BuildingMaterials tinted_materials(const map::Footprint& footprint, Material wall, Material roof) {
  const Material own_wall = footprint.wall_material.value_or(wall);
  return {material_for(footprint.wall_colour, {own_wall, materials::light_variant_of(own_wall)}),
          material_for(footprint.roof_colour,
                       {footprint.roof_material.value_or(roof), Material::kFlatRoof, Material::kPaint})};
}

// Colours of untagged plaster as shares of the material's base colour, for all that no rule colours; rules draw
// `plaster_colour` of building.cga instead. Warm whites and creams first, then sand, ochre, pink, grey, sage and
// terracotta.
constexpr LinearRgb kUnruledPlasterHues[] = {
    {1.00, 1.00, 1.00}, {0.97, 0.96, 0.94}, {1.00, 0.95, 0.84}, {1.00, 0.93, 0.78},
    {0.95, 0.94, 0.96}, {0.90, 0.83, 0.70}, {0.96, 0.84, 0.62}, {0.93, 0.77, 0.50},
    {0.96, 0.80, 0.72}, {0.92, 0.72, 0.63}, {0.80, 0.82, 0.86}, {0.72, 0.72, 0.73},
    {0.86, 0.80, 0.72}, {1.00, 0.97, 0.90}, {0.78, 0.85, 0.76}, {0.80, 0.55, 0.42}};

Tint tint_for(Material material, const std::optional<map::Srgb>& colour, const RandomSequence& draw) {
  if (colour) return tint_towards(material, paint_reflectance(*colour));
  const double brightness = 1 - values_of(material).variation * draw.unit(0);
  if (material != Material::kPlaster) return tint_of({brightness, brightness, brightness});
  const LinearRgb& hue = kUnruledPlasterHues[draw.below(std::size(kUnruledPlasterHues), 1)];
  return tint_of({brightness * hue[0], brightness * hue[1], brightness * hue[2]});
}

}  // namespace

BuildingMaterials building_materials(const map::Footprint& footprint, roofs::RoofForm form) {
  return tinted_materials(footprint, untagged_wall(footprint), untagged_roof(footprint, form));
}

BuildingMaterials regional_materials(const map::Footprint& footprint, roofs::RoofForm form, Style style) {
  if (!has(footprint.assumed, Assumption::kStyles)) return building_materials(footprint, form);
  return tinted_materials(footprint, regional_untagged_wall(footprint, style), regional_untagged_roof(footprint, form));
}

Tint wall_tint(const Building& building, std::uint64_t seed) {
  return tint_for(building.wall, building.wall_colour, RandomSequence(seed, stable_id(building.id), "wall tint"));
}

Tint roof_tint(const Building& building, std::uint64_t seed) {
  return tint_for(building.roof, building.roof_colour, RandomSequence(seed, stable_id(building.id), "roof tint"));
}

}  // namespace citykiln::buildings
