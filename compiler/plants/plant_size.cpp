#include "compiler/plants/plant_size.h"

#include <algorithm>
#include <cmath>

namespace citykiln::plants {
namespace {

// A tree has half of its species' greatest height at this trunk diameter; the shape of foresters' height curves
// (Michailoff, Naslund), rounded.
constexpr double kHalfHeightDiameter_m = 0.22;

// Height when planted, and growth a year up to the year of the extracts: a map does not state its own year.
constexpr double kPlanted_m = 2.5, kYearly_m = 0.35;
constexpr int kThisYear = 2026;

// Trees in towns and fields stay below the height that their species reaches.
constexpr double kUsualShare = 0.55;

double height_by_girth_m(double tallest_m, double girth_m) {
  constexpr double kPi = 3.14159265358979;
  const double diameter_m = girth_m / kPi;
  return tallest_m * diameter_m / (diameter_m + kHalfHeightDiameter_m);
}

double height_by_year_m(double mature_m, std::uint16_t year) {
  return std::min(mature_m, kPlanted_m + kYearly_m * std::max(0, kThisYear - year));
}

}  // namespace

double height_from_tags_m(const SpeciesValues& values, const map::PlantTags& plant_tags) {
  double height_m = 0;
  if (plant_tags.crown_m > 0)
    height_m = plant_tags.crown_m / values.crown_share;
  else if (plant_tags.girth_m > 0)
    height_m = height_by_girth_m(values.tallest_m, plant_tags.girth_m);
  else if (plant_tags.year > 0)
    height_m = height_by_year_m(values.height_m, plant_tags.year);
  return std::floor(std::min(height_m, values.tallest_m) * 8) / 8;
}

double default_height_m(const SpeciesValues& species) { return kUsualShare * species.height_m; }

}  // namespace citykiln::plants
