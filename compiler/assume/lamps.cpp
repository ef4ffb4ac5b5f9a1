#include "compiler/assume/lamps.h"

#include <algorithm>
#include <optional>

#include "compiler/assume/beside.h"
#include "compiler/assume/cut_way.h"
#include "compiler/assume/pavements.h"

namespace citykiln::assume {
namespace {

struct LitClass {
  map::LandCoverClass surface;
  double score;
};
constexpr LitClass kLitClasses[] = {
#define LIT_CLASS(surface, score) {map::LandCoverClass::surface, score},
#include "compiler/assume/lamps.inc"
#undef LIT_CLASS
};

struct LitLand {
  LandUse land;
  double score;
};
constexpr LitLand kLitLands[] = {
#define LIT_LAND(land, score) {LandUse::land, score},
#include "compiler/assume/lamps.inc"
#undef LIT_LAND
};

struct LitCountry {
  map::CountryGroup country;
  map::LandCoverClass surface;
  double score;
};
constexpr LitCountry kLitCountries[] = {
#define LIT_COUNTRY(country, surface, score) {map::CountryGroup::country, map::LandCoverClass::surface, score},
#include "compiler/assume/lamps.inc"
#undef LIT_COUNTRY
};

#define LIT_SCORE(name, score) constexpr double name = score;
#include "compiler/assume/lamps.inc"
#undef LIT_SCORE

constexpr double kLitHouses = 0.25, kLitOpen = 0.1;
// Shorter paths lead to doors.
constexpr double kShortestLitPath_m = 40;

std::optional<double> lit_class_score(map::LandCoverClass surface) {
  for (const LitClass& row : kLitClasses)
    if (row.surface == surface) return row.score;
  return std::nullopt;
}

double lit_land_score(LandUse land) {
  for (const LitLand& row : kLitLands)
    if (row.land == land) return row.score;
  return 0;
}

bool may_be_lit(const map::Track& track) {
  if (track.has_tagged_lighting || track.is_lit || track.is_rail || track.is_indoor) return false;
  if (track.passage == map::Passage::kTunnel || track.section.axis_drift != 0) return false;
  const bool is_path = map::values_of(track.surface).group == map::LandCoverGroup::kPath;
  if (is_path && !track.is_piece && length_m(track.axis) < kShortestLitPath_m) return false;
  return lit_class_score(track.surface).has_value();
}

// Returns true if a stretch of street or path is assumed to be lit. The caller checks that lit=* is not tagged.
bool is_assumed_lit(const map::Track& stretch, const BothSides& sides) {
  double score = lit_class_score(stretch.surface).value_or(0);
  score += std::max(lit_land_score(sides.left.land), lit_land_score(sides.right.land));
  for (const LitCountry& row : kLitCountries)
    if (row.country == stretch.country && row.surface == stretch.surface) score += row.score;
  const double houses = std::max(sides.left.houses, sides.right.houses);
  if (houses > kLitHouses) score += kLitHousesScore;
  if (houses < kLitOpen) score += kLitOpenScore;
  return score > 0;
}

}  // namespace

std::vector<map::Track> assume_lamps(const map::FeatureView& features, Report& report) {
  const Surroundings surroundings = index_surroundings(features);
  const CommonNodes common = common_nodes_of(features.tracks);
  const auto cut = [&](const map::Track& track) {
    // what leaves the ground stays whole: its heights follow from its ends
    const bool may_be_cut = may_be_lit(track) && !track.is_piece && track.passage == map::Passage::kGround;
    return may_be_cut ? cut_way(track, kLongestWhole_m, kStretch_m, common) : std::vector{track};
  };
  const auto change = [&](map::Track& stretch) {
    if (!may_be_lit(stretch) || length_m(stretch.axis) > kLongestWhole_m) return false;
    return stretch.is_lit = is_assumed_lit(stretch, facts_beside(surroundings, stretch));
  };
  return with_changed_stretches(features.tracks, Assumption::kLamps, "lit_track", cut, change, report);
}

}  // namespace citykiln::assume
