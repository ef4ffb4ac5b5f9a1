#include "compiler/climate/climate_class.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace citykiln::climate {
namespace {

struct ClassRow {
  std::string_view name, leaves, dry, snow;
  double bare;
};
constexpr ClassRow kRows[] = {
#define CLIMATE(name, letter, leaves, dry, snow, bare) {#name, leaves, dry, snow, bare},
#include "compiler/climate/climate_classes.inc"
};

constexpr std::string_view kMonths = "123456789abc";

constexpr bool is_year(const ClassRow& row) {
  return row.leaves.size() == 12 && row.dry.size() == 12 && row.snow.size() == 12 && row.leaves[5] == '6' &&
         row.leaves.find_first_not_of(kMonths) == row.leaves.npos &&
         row.dry.find_first_not_of("0123456789") == row.dry.npos && row.snow.find_first_not_of(".*") == row.snow.npos;
}
static_assert(std::ranges::all_of(kRows, is_year));

const ClassRow& row_of(ClimateClass climate) {
  assert(climate < ClimateClass::kCount);
  return kRows[static_cast<std::size_t>(climate)];
}

std::size_t index_of(LocalMonth month) {
  assert(LocalMonth{1} <= month && month <= LocalMonth{12});
  return static_cast<std::size_t>(month) - 1;
}

}  // namespace

std::string_view name_of(ClimateClass climate) { return row_of(climate).name; }

ClimateClass climate_named(std::string_view name) {
  return static_cast<ClimateClass>(std::ranges::find(kRows, name, &ClassRow::name) - std::begin(kRows));
}

bool has_cold_winters(ClimateClass climate) { return name_of(climate)[0] == 'D' || name_of(climate)[0] == 'E'; }

std::uint8_t equivalent_month(ClimateClass climate, LocalMonth month) {
  return static_cast<std::uint8_t>(kMonths.find(row_of(climate).leaves[index_of(month)]) + 1);
}

double straw_share(ClimateClass climate, LocalMonth month) {
  return (row_of(climate).dry[index_of(month)] - '0') / 10.0;
}

double bare_share(ClimateClass climate) { return row_of(climate).bare; }

bool is_under_snow(ClimateClass climate, LocalMonth month) { return row_of(climate).snow[index_of(month)] == '*'; }

}  // namespace citykiln::climate
