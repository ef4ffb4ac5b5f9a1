#include "compiler/buildings/building_materials.h"

#include <algorithm>
#include <initializer_list>

#include "compiler/buildings/paint_colour.h"
#include "compiler/contract/draw.h"
#include "compiler/map/building_classes.h"

namespace citykiln::buildings {
namespace {

using map::BuildingClass;
using materials::Material;
using materials::Tint;

struct MaterialRow {
  Material wall, other_wall;
  std::uint32_t other_percent;
  Material pitched_roof, flat_roof;
};

constexpr MaterialRow kRows[] = {
#define BUILDING_MATERIALS(building, wall, other, percent, pitched, flat) \
  {Material::wall, Material::other, percent, Material::pitched, Material::flat},
#include "compiler/buildings/building_materials.inc"
#undef BUILDING_MATERIALS
};
static_assert(std::size(kRows) == static_cast<std::size_t>(BuildingClass::kCount));

// That the rows stand in the order of the classes.
constexpr BuildingClass kOrder[] = {
#define BUILDING_MATERIALS(building, wall, other, percent, pitched, flat) BuildingClass::building,
#include "compiler/buildings/building_materials.inc"
#undef BUILDING_MATERIALS
};
static_assert([] {
  for (std::size_t i = 0; i < std::size(kOrder); ++i)
    if (static_cast<std::size_t>(kOrder[i]) != i) return false;
  return true;
}());

const MaterialRow& row_of(std::uint8_t building_class) {
  return kRows[std::min<std::size_t>(building_class, std::size(kRows) - 1)];
}

// The first material that can be tinted to the colour; the last, which is the lightest, where none can.
Material tintable_material(const std::optional<map::Srgb>& colour, std::initializer_list<Material> choice) {
  return colour ? buildings::tintable_material(paint_reflectance(*colour), choice) : *choice.begin();
}

Material untagged_wall(const map::Footprint& footprint) {
  const MaterialRow& row = row_of(footprint.building_class);
  const bool is_stone = row.wall == Material::kStone;
  if (footprint.height_m > kGlassTower_m && !is_stone) return Material::kGlassFacade;
  const bool is_other = Draw(0, stable_id(footprint.id), "wall").below(100, 0) < row.other_percent;
  return is_other ? row.other_wall : row.wall;
}

Material untagged_roof(const map::Footprint& footprint, roofs::Form form) {
  const MaterialRow& row = row_of(footprint.building_class);
  return form == roofs::Form::kFlat ? row.flat_roof : row.pitched_roof;
}

Tint tint_towards(Material material, const map::Srgb& colour) {
  return buildings::tint_towards(material, paint_reflectance(colour));
}

// Shares of plaster's base colour: warm whites and creams first, then sand, ochre, pink, grey, and now and then sage or
// terracotta.
constexpr LinearRgb kPlasterHues[] = {{1.00, 1.00, 1.00}, {0.97, 0.96, 0.94}, {1.00, 0.95, 0.84}, {1.00, 0.93, 0.78},
                                      {0.95, 0.94, 0.96}, {0.90, 0.83, 0.70}, {0.96, 0.84, 0.62}, {0.93, 0.77, 0.50},
                                      {0.96, 0.80, 0.72}, {0.92, 0.72, 0.63}, {0.80, 0.82, 0.86}, {0.72, 0.72, 0.73},
                                      {0.86, 0.80, 0.72}, {1.00, 0.97, 0.90}, {0.78, 0.85, 0.76}, {0.80, 0.55, 0.42}};

Tint varied(Material material, const Draw& draw) {
  const double brightness = 1 - values_of(material).variation * draw.unit(0);
  if (material != Material::kPlaster) return tint_of({brightness, brightness, brightness});
  const LinearRgb& hue = kPlasterHues[draw.below(std::size(kPlasterHues), 1)];
  return tint_of({brightness * hue[0], brightness * hue[1], brightness * hue[2]});
}

}  // namespace

BuildingMaterials building_materials(const map::Footprint& footprint, roofs::Form form) {
  const Material wall = footprint.wall_material.value_or(untagged_wall(footprint));
  const Material roof = footprint.roof_material.value_or(untagged_roof(footprint, form));
  return {tintable_material(footprint.wall_colour, {wall, Material::kPaint}),
          tintable_material(footprint.roof_colour, {roof, Material::kFlatRoof, Material::kPaint})};
}

Tint wall_tint(const Building& building, std::uint64_t seed) {
  if (building.wall_colour) return tint_towards(building.wall, *building.wall_colour);
  return varied(building.wall, Draw(seed, stable_id(building.id), "wall tint"));
}

Tint roof_tint(const Building& building, std::uint64_t seed) {
  if (building.roof_colour) return tint_towards(building.roof, *building.roof_colour);
  return varied(building.roof, Draw(seed, stable_id(building.id), "roof tint"));
}

}  // namespace citykiln::buildings
