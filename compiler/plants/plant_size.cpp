#include "compiler/plants/plant_size.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace citykiln::plants {
namespace {

constexpr auto kCrownWidthShares = [] {
  std::array<double, static_cast<std::size_t>(Species::kCount)> shares{};
#define HABIT(species, share) shares[static_cast<std::size_t>(Species::species)] = share;
#include "compiler/plants/crown_shares.inc"
#undef HABIT
  return shares;
}();

// Half of the tallest at this diameter, then less and less a centimetre: the shape of foresters' height curves
// (Michailoff, Naslund), rounded.
constexpr double kHalfGrown_m = 0.22;

// A young tree as it is planted, what it adds a year, and when extracts are about: no map says what year it is.
constexpr double kPlanted_m = 2.5, kYearly_m = 0.35;
constexpr int kThisYear = 2026;

// Trees in towns and fields are not grown to what their kind can.
constexpr double kUsualShare = 0.55;

double height_by_girth_m(double tallest_m, double girth_m) {
  constexpr double kPi = 3.14159265358979;
  const double through_m = girth_m / kPi;
  return tallest_m * through_m / (through_m + kHalfGrown_m);
}

double height_by_year_m(double grown_m, std::uint16_t year) {
  return std::min(grown_m, kPlanted_m + kYearly_m * std::max(0, kThisYear - year));
}

double in_eighths(double height_m) { return std::floor(height_m * 8) / 8; }

}  // namespace

double crown_share(Species species) { return kCrownWidthShares[static_cast<std::size_t>(species)]; }

double height_from_tags_m(Species species, const map::PlantTags& plant_tags) {
  const SpeciesValues& values = values_of(species);
  double height_m = 0;
  if (plant_tags.crown_m > 0)
    height_m = plant_tags.crown_m / crown_share(species);
  else if (plant_tags.girth_m > 0)
    height_m = height_by_girth_m(values.tallest_m, plant_tags.girth_m);
  else if (plant_tags.year > 0)
    height_m = height_by_year_m(values.height_m, plant_tags.year);
  return in_eighths(std::min(height_m, values.tallest_m));
}

double default_height_m(Species species) { return kUsualShare * values_of(species).height_m; }

}  // namespace citykiln::plants
