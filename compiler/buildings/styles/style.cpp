#include "compiler/buildings/styles/style.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "compiler/buildings/styles/mixed_styles.h"
#include "compiler/buildings/styles/regional_styles.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::buildings {
namespace {

using map::BuildingClass;

constexpr std::string_view kRules[] = {
#define STYLE(name, rules) rules,
#include "compiler/buildings/styles.inc"
#undef STYLE
};
static_assert(std::size(kRules) == static_cast<std::size_t>(Style::kCount));

// Smaller buildings have no walls for windows.
constexpr double kMinWindowedArea_m2 = 12, kMinWindowedWall_m = 2.2;
constexpr double kMinTower_m = 60, kMaxOldTownHouse_m2 = 350;
constexpr int kMaxHouseLevels = 3;
// Since then walls are made of prefabricated slabs and concrete.
constexpr std::uint16_t kModernSince = 1955;

bool is_modern(const map::Footprint& footprint) { return footprint.year >= kModernSince; }

// The country group whose practice is followed: of styles that are not assumed, central Europe's.
map::CountryGroup practice(const map::Footprint& footprint) {
  return has(footprint.assumed, Assumption::kStyles) ? footprint.country : map::CountryGroup::kCentralEurope;
}

Style central_european_dwelling(const map::Footprint& footprint, const Building& building) {
  const bool is_attached = !building.party_walls.empty();
  const double area = area_m2(footprint.polygon);
  if (area <= max_house_m2(practice(footprint)) && building.levels <= kMaxHouseLevels)
    return is_attached ? (building.levels > 2 && !is_modern(footprint) ? Style::kOldTownHouse : Style::kRowHouse)
                       : Style::kVilla;
  if (is_modern(footprint) || !is_attached) return Style::kPanelBlock;
  return area <= kMaxOldTownHouse_m2 ? Style::kOldTownHouse : Style::kCourtyardBlock;
}

// Dwellings and buildings of unknown use.
Style dwelling(const map::Footprint& footprint, const Building& building) {
  return regional_style(practice(footprint), central_european_dwelling(footprint, building), building.levels);
}

Style house(const map::Footprint& footprint, const Building& building) {
  const Style usual = building.party_walls.empty() ? Style::kVilla : Style::kRowHouse;
  return regional_style(practice(footprint), usual, building.levels);
}

Style style_of_class(const map::Footprint& footprint, const Building& building) {
  switch (static_cast<BuildingClass>(footprint.building_class)) {
    case BuildingClass::kHouse:
      return house(footprint, building);
    case BuildingClass::kOffice:
      return Style::kOfficeSlab;
    case BuildingClass::kCivic:
    case BuildingClass::kSchool:
    case BuildingClass::kHospital:
      return is_modern(footprint) ? Style::kOfficeSlab : Style::kCourtyardBlock;
    case BuildingClass::kShop:
      return building.levels <= 2 ? Style::kShop : dwelling(footprint, building);
    case BuildingClass::kHall:
      return Style::kWarehouse;
    case BuildingClass::kGarage:
      return Style::kGarage;
    case BuildingClass::kBarn:
      return Style::kBarn;
    case BuildingClass::kChurch:
      return Style::kChurch;
    case BuildingClass::kCastle:
      return Style::kCastle;
    case BuildingClass::kHut:
    case BuildingClass::kTower:
    case BuildingClass::kRoof:
    case BuildingClass::kShelter:
    case BuildingClass::kSteps:
    case BuildingClass::kColumn:
    case BuildingClass::kGreenhouse:
    case BuildingClass::kShell:
      return Style::kPlain;
    default:
      return dwelling(footprint, building);
  }
}

}  // namespace

std::string_view rule_file_of(Style style) { return kRules[static_cast<std::size_t>(style)]; }

std::optional<Style> style_named(std::string_view rule_file) {
  const auto found = std::ranges::find(kRules, rule_file);
  if (rule_file.empty() || found == std::end(kRules)) return std::nullopt;
  return static_cast<Style>(found - std::begin(kRules));
}

Style style_of(const map::Footprint& footprint, const Building& building) {
  assert(footprint.id == building.id);
  const double wall_m = eaves_m(building) - building.floor_m;
  if (footprint.is_open || wall_m < kMinWindowedWall_m || area_m2(footprint.polygon) < kMinWindowedArea_m2)
    return Style::kPlain;
  if (const std::optional<Style> named = style_named(footprint.style_name)) return *named;
  const bool is_glass = building.wall == materials::Material::kGlassFacade;
  const bool is_greenhouse = footprint.building_class == static_cast<std::uint8_t>(BuildingClass::kGreenhouse);
  if (!is_glass || is_greenhouse) return mixed_style(footprint, building, style_of_class(footprint, building));
  const Style of_glass = wall_m > kMinTower_m ? Style::kGlassTower : Style::kOfficeSlab;
  return footprint.wall_material ? of_glass : mixed_style(footprint, building, of_glass);
}

}  // namespace citykiln::buildings
