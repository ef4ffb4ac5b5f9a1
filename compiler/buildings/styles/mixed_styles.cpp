#include "compiler/buildings/styles/mixed_styles.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <limits>

#include "compiler/contract/random_sequence.h"

namespace citykiln::buildings {
namespace {

using map::BuildingTradition;
using map::CountryGroup;
using materials::Material;

// Sets of styles, country groups and traditions have a bit for each member.
using Bits = std::uint32_t;
constexpr Bits kAnyMember = ~Bits{0};

constexpr Bits bit(Style style) { return Bits{1} << static_cast<int>(style); }
constexpr Bits bit(CountryGroup group) { return Bits{1} << static_cast<int>(group); }
constexpr Bits bit(BuildingTradition tradition) { return Bits{1} << static_cast<int>(tradition); }
static_assert(static_cast<int>(Style::kChineseSlab) < std::numeric_limits<Bits>::digits);

enum class Standing : std::uint8_t { kAnywhere, kInRow, kAlone };

struct MixedRow {
  Style style{};
  std::uint32_t percent = 0;
  Bits replaced = 0;
  Bits groups = kAnyMember, traditions = kAnyMember;
  std::uint8_t from_levels = 0, to_levels = 255;
  double from_m2 = 0, to_m2 = 1e9;
  std::uint16_t from_year = 0, to_year = 9999;
  Standing attached = Standing::kAnywhere;
  bool mansard = false;  // under a mansard or gambrel roof only
};

// The table with the names of its sets.
struct MixedTable {
  static constexpr auto kInRow = Standing::kInRow, kAlone = Standing::kAlone;
  static constexpr Bits kFrance = bit(BuildingTradition::kFrance), kBelgium = bit(BuildingTradition::kBelgium),
                        kGermany = bit(BuildingTradition::kGermany);
  static constexpr Bits kSouthernEurope = bit(CountryGroup::kSouthernEurope),
                        kEasternEurope = bit(CountryGroup::kEasternEurope),
                        kNorthAmerica = bit(CountryGroup::kNorthAmerica),
                        kNorthAfricaAndMiddleEast = bit(CountryGroup::kNorthAfricaAndMiddleEast),
                        kChina = bit(CountryGroup::kChina), kJapan = bit(CountryGroup::kJapan),
                        kSouthEastAsia = bit(CountryGroup::kSouthEastAsia);
  static constexpr Bits kOldBlocks =
      bit(Style::kOldTownHouse) | bit(Style::kCourtyardBlock) | bit(Style::kMediterraneanHouse);
  static constexpr Bits kGlassTowers = bit(Style::kGlassTower), kOffices = bit(Style::kOfficeSlab);
  static constexpr Bits kFlats = kOldBlocks | bit(Style::kPanelBlock) | bit(Style::kBalconyFlats) |
                                 bit(Style::kNorthAmericanRow) | bit(Style::kJapaneseApartments) |
                                 bit(Style::kChineseSlab) | bit(Style::kFlatRoofHouse) | bit(Style::kSouthAsianHouse);
  static constexpr MixedRow kRows[] = {
#define MIXED_STYLE(name, share, replaces, ...) \
  {.style = Style::name, .percent = share, .replaced = replaces, __VA_ARGS__},
#include "compiler/buildings/styles/mixed_styles.inc"
#undef MIXED_STYLE
  };
};

struct MixedWallRow {
  Style style;
  Material first;
  std::uint32_t first_percent;
  Material second;
  std::uint32_t second_percent;
  Material rest;
};

constexpr MixedWallRow kMixedWalls[] = {
#define MIXED_WALL(style, wall, percent, other, other_percent, rest) \
  {Style::style, Material::wall, percent, Material::other, other_percent, Material::rest},
#include "compiler/buildings/styles/mixed_walls.inc"
#undef MIXED_WALL
};

bool has_mansard(const Building& building) {
  const roofs::RoofForm form = building.roof_shape.form;
  return form == roofs::RoofForm::kMansard || form == roofs::RoofForm::kGambrel;
}

bool stands_so(Standing wanted, const Building& building) {
  return wanted == Standing::kAnywhere || (wanted == Standing::kInRow) == !building.party_walls.empty();
}

bool fits(const MixedRow& row, const map::Footprint& footprint, const Building& building, Style usual) {
  const double area = area_m2(footprint.polygon);
  return (row.replaced & bit(usual)) != 0 && (row.groups & bit(footprint.country)) != 0 &&
         (row.traditions & bit(footprint.tradition)) != 0 && building.levels >= row.from_levels &&
         building.levels <= row.to_levels && footprint.year >= row.from_year && footprint.year <= row.to_year &&
         area >= row.from_m2 && area <= row.to_m2 && stands_so(row.attached, building) &&
         (!row.mansard || has_mansard(building));
}

std::uint32_t drawn_percent(const map::Footprint& footprint) {
  const ObjectId whole = footprint.outline.value_or(footprint.id);
  return static_cast<std::uint32_t>(RandomSequence(0, stable_id(whole), "mixed style").below(100, 0));
}

}  // namespace

Style mixed_style(const map::Footprint& footprint, const Building& building, Style usual) {
  if (!has(footprint.assumed, Assumption::kStyles)) return usual;
  std::uint32_t percent = drawn_percent(footprint);
  for (const MixedRow& row : MixedTable::kRows) {
    if (!fits(row, footprint, building, usual)) continue;
    if (percent < row.percent) return row.style;
    percent -= row.percent;
  }
  return usual;
}

Material mixed_wall(Style style, Material usual, std::uint32_t draw) {
  const auto row = std::ranges::find(kMixedWalls, style, &MixedWallRow::style);
  if (row == std::end(kMixedWalls)) return usual;
  if (draw < row->first_percent) return row->first;
  return draw < row->first_percent + row->second_percent ? row->second : row->rest;
}

}  // namespace citykiln::buildings
