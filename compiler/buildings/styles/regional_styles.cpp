#include "compiler/buildings/styles/regional_styles.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>

namespace citykiln::buildings {
namespace {

using map::CountryGroup;
using materials::Material;

constexpr std::size_t kMaxReplaced = 5;

struct StyleRow {
  CountryGroup country;
  Style style;
  std::uint8_t most_levels;
  Material walls[3];
  std::uint32_t percents[2];
  Style replaced[kMaxReplaced] = {};  // kPlain: none

  constexpr StyleRow(CountryGroup in, Style used, std::uint8_t levels, Material first, std::uint32_t first_percent,
                     Material second, std::uint32_t second_percent, Material rest, std::initializer_list<Style> usual)
      : country(in),
        style(used),
        most_levels(levels),
        walls{first, second, rest},
        percents{first_percent, second_percent} {
    std::copy(usual.begin(), usual.end(), replaced);
  }
};

using enum Style;
constexpr StyleRow kStyleRows[] = {
#define REGIONAL_STYLE(group, style, levels, wall, percent, other, other_percent, rest, ...) \
  {CountryGroup::group, Style::style,  levels,         Material::wall, percent,              \
   Material::other,     other_percent, Material::rest, {__VA_ARGS__}},
#include "compiler/buildings/styles/regional_styles.inc"
#undef REGIONAL_STYLE
};

struct RoofRow {
  CountryGroup country;
  Material roof;
  std::uint32_t percent;
  Material rest;
};

constexpr RoofRow kRoofRows[] = {
#define REGIONAL_ROOF(group, roof, percent, rest) {CountryGroup::group, Material::roof, percent, Material::rest},
#include "compiler/buildings/styles/regional_roofs.inc"
#undef REGIONAL_ROOF
};
static_assert(std::size(kRoofRows) == static_cast<std::size_t>(CountryGroup::kCount));
static_assert([] {
  for (std::size_t i = 0; i < std::size(kRoofRows); ++i)
    if (static_cast<std::size_t>(kRoofRows[i].country) != i) return false;
  return true;
}());

// An estimate: houses of one storey with a garage under the same roof.
constexpr double kMaxHouse_m2 = 220, kMaxWideHouse_m2 = 420;

}  // namespace

Style regional_style(CountryGroup country, Style usual, std::uint8_t levels) {
  if (usual == Style::kPlain) return usual;
  const auto row = std::ranges::find_if(kStyleRows, [&](const StyleRow& r) {
    return r.country == country && levels <= r.most_levels &&
           std::ranges::find(r.replaced, usual) != std::end(r.replaced);
  });
  return row == std::end(kStyleRows) ? usual : row->style;
}

Material regional_wall(CountryGroup country, Style style, Material usual, std::uint32_t draw) {
  const auto row =
      std::ranges::find_if(kStyleRows, [&](const StyleRow& r) { return r.country == country && r.style == style; });
  if (row == std::end(kStyleRows)) return usual;
  if (draw < row->percents[0]) return row->walls[0];
  return draw < row->percents[0] + row->percents[1] ? row->walls[1] : row->walls[2];
}

Material regional_roof(CountryGroup country, std::uint32_t draw) {
  const RoofRow& row = kRoofRows[static_cast<std::size_t>(country)];
  return draw < row.percent ? row.roof : row.rest;
}

double max_house_m2(CountryGroup country) {
  return country == CountryGroup::kNorthAmerica || country == CountryGroup::kOceania ? kMaxWideHouse_m2 : kMaxHouse_m2;
}

}  // namespace citykiln::buildings
