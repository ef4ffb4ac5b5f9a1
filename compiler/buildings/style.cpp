#include "compiler/buildings/style.h"

#include <iterator>

#include "compiler/map/building_classes.h"

namespace citykiln::buildings {
namespace {

using map::BuildingClass;

constexpr std::string_view kRules[] = {
#define STYLE(name, rules) rules,
#include "compiler/buildings/styles.inc"
#undef STYLE
};
static_assert(std::size(kRules) == static_cast<std::size_t>(Style::kCount));

// No walls that could have a window.
constexpr double kLeast_m2 = 12, kLeastWall_m = 2.2;
constexpr double kTower_m = 60, kHouse_m2 = 220, kOldTown_m2 = 350;
constexpr int kHouseLevels = 3;
// When walls came to be made of slabs and concrete.
constexpr std::uint16_t kPrefab = 1955;

bool is_modern(const map::Footprint& footprint) { return footprint.year >= kPrefab; }

// Where people live, and all that nobody says what it is.
Style dwelling(const map::Footprint& footprint, const Building& building) {
  const bool is_attached = !building.party_walls.empty();
  const double area = area_m2(footprint.polygon);
  if (area <= kHouse_m2 && building.levels <= kHouseLevels)
    return is_attached ? (building.levels > 2 && !is_modern(footprint) ? Style::kOldTownHouse : Style::kRowHouse)
                       : Style::kVilla;
  if (is_modern(footprint) || !is_attached) return Style::kPanelBlock;
  return area <= kOldTown_m2 ? Style::kOldTownHouse : Style::kCourtyardBlock;
}

Style by_class(const map::Footprint& footprint, const Building& building) {
  switch (static_cast<BuildingClass>(footprint.building_class)) {
    case BuildingClass::kHouse:
      return building.party_walls.empty() ? Style::kVilla : Style::kRowHouse;
    case BuildingClass::kOffice:
      return Style::kOfficeSlab;
    case BuildingClass::kCivic:
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
    case BuildingClass::kGreenhouse:
      return Style::kPlain;
    default:
      return dwelling(footprint, building);
  }
}

}  // namespace

std::string_view rule_file_of(Style style) { return kRules[static_cast<std::size_t>(style)]; }

Style style_of(const map::Footprint& footprint, const Building& building) {
  const double wall_m = eaves_m(building) - building.floor_m;
  if (wall_m < kLeastWall_m || area_m2(footprint.polygon) < kLeast_m2) return Style::kPlain;
  const bool is_glass = building.wall == materials::Material::kGlassFacade;
  const bool is_greenhouse = footprint.building_class == static_cast<std::uint8_t>(BuildingClass::kGreenhouse);
  if (is_glass && !is_greenhouse) return wall_m > kTower_m ? Style::kGlassTower : Style::kOfficeSlab;
  return by_class(footprint, building);
}

}  // namespace citykiln::buildings
