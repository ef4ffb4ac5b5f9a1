#include "compiler/assume/pavements.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/assume/beside.h"
#include "compiler/assume/cut_way.h"

namespace citykiln::assume {
namespace {

using map::CountryGroup;
using map::LandCoverClass;
using map::Track;

// Widths are multiples of this, so that tags can state them.
constexpr double kWidthStep_m = 0.25;

struct ClassScore {
  LandCoverClass surface;
  double score;
};
constexpr ClassScore kClassScores[] = {
#define CLASS_SCORE(surface, score) {LandCoverClass::surface, score},
#include "compiler/assume/pavements.inc"
#undef CLASS_SCORE
};

struct LandScore {
  LandUse land;
  double score;
};
constexpr LandScore kLandScores[] = {
#define LAND_SCORE(land, score) {LandUse::land, score},
#include "compiler/assume/pavements.inc"
#undef LAND_SCORE
};

struct CountryScore {
  CountryGroup country;
  LandCoverClass surface;
  double score;
};
constexpr CountryScore kCountryScores[] = {
#define COUNTRY_SCORE(country, surface, score) {CountryGroup::country, LandCoverClass::surface, score},
#include "compiler/assume/pavements.inc"
#undef COUNTRY_SCORE
};

#define SCORE(name, score) constexpr double name = score;
#include "compiler/assume/pavements.inc"
#undef SCORE

struct WidthRow {
  CountryGroup country;  // kCount: the others
  LandCoverClass surface;
  double usual_m, between_houses_m;
};
constexpr CountryGroup kElsewhere = CountryGroup::kCount;
constexpr WidthRow kWidths[] = {
#define PAVEMENT_WIDTH(surface, usual_m, between_houses_m) \
  {kElsewhere, LandCoverClass::surface, usual_m, between_houses_m},
#define PAVEMENT_WIDTH_IN(country, surface, usual_m, between_houses_m) \
  {CountryGroup::country, LandCoverClass::surface, usual_m, between_houses_m},
#include "compiler/assume/pavements.inc"
#undef PAVEMENT_WIDTH
#undef PAVEMENT_WIDTH_IN
};

// Shares of a side along which houses stand: below the first it is open; above the second pavements are wider.
constexpr double kOpen = 0.1, kTownHouses = 0.6;
// The share of the inner side of a one-way street along which houses stand, from which it is the side of a street of
// its own, not of a carriageway.
constexpr double kInsideHouses = 0.6;
// The share of a stretch near cross streets from which it belongs to a town.
constexpr double kTownStreets = 0.4;
// A path along more than this share of a side is its pavement; another carriageway along more than this share is on its
// inner side.
constexpr double kPathReplaces = 0.5, kCarriagewayReplaces = 0.25;

std::optional<double> class_score(LandCoverClass surface) {
  for (const ClassScore& row : kClassScores)
    if (row.surface == surface) return row.score;
  return std::nullopt;
}

double score_of(const Track& stretch, const SideFacts& side, bool is_inner_side) {
  double score = class_score(stretch.surface).value_or(0);
  for (const LandScore& row : kLandScores)
    if (row.land == side.land) score += row.score;
  for (const CountryScore& row : kCountryScores)
    if (row.country == stretch.country && row.surface == stretch.surface) score += row.score;
  if (stretch.is_link) score += kLinkScore;
  if (stretch.is_oneway) score += kOneWayScore;
  if (stretch.is_oneway && is_inner_side)
    score += side.houses > kInsideHouses ? kOneWayInsideHousesScore : kOneWayInsideScore;
  if (side.houses < kOpen && side.houses_across < kOpen && side.near_cross_street < kTownStreets) score += kOpenScore;
  return score;
}

double usual_width_m(const Track& stretch, bool is_between_houses) {
  const WidthRow* found = nullptr;
  for (const WidthRow& row : kWidths)
    if (row.surface == stretch.surface && (row.country == stretch.country || (row.country == kElsewhere && !found)))
      found = &row;
  if (found == nullptr) return 0;
  return is_between_houses ? found->between_houses_m : found->usual_m;
}

// True for streets on the ground on which a pavement may be assumed.
bool may_have_pavement(const Track& track) {
  if (track.tagged_pavements == map::kBothSides || track.passage != map::Passage::kGround || track.is_rail)
    return false;
  if (track.is_indoor || track.is_through_building || track.is_transition) return false;
  return class_score(track.surface).has_value();
}

// The side of one-way streets and roundabouts away from the kerb by which slow traffic keeps.
std::uint8_t inner_side(const Track& track) {
  return track.side == map::DrivingSide::kRight ? map::kLeftSide : map::kRightSide;
}

// Returns the width of the pavement that is assumed on a side of a stretch; 0 for none.
// @param is_inner_side  True for the left side where traffic drives on the right, and for the right side elsewhere: on
//                       roundabouts and dual carriageways this is the inner side.
double assumed_pavement_m(const Track& stretch, const SideFacts& side, bool is_inner_side) {
  if ((is_inner_side && stretch.is_roundabout) || side.path > kPathReplaces || side.oncoming > kCarriagewayReplaces)
    return 0;
  if (score_of(stretch, side, is_inner_side) <= 0) return 0;
  const double usual_m = usual_width_m(stretch, side.houses > kTownHouses);
  const double width_m = std::min(usual_m, std::floor(side.room_m / kWidthStep_m) * kWidthStep_m);
  return width_m < kNarrowestPavement_m ? 0 : width_m;
}

bool add_pavement(Track& stretch, std::uint8_t side, const SideFacts& facts) {
  if ((stretch.tagged_pavements & side) != 0) return false;
  const double width_m = assumed_pavement_m(stretch, facts, inner_side(stretch) == side);
  if (width_m <= 0) return false;
  stretch.section = with_pavement(std::move(stretch.section), side, width_m);
  stretch.assumed |= bit_of(Assumption::kPavements), stretch.assumed_sides |= side;
  return true;
}

// Adds what is assumed to a stretch; returns whether that is anything.
bool add_pavements(const Surroundings& surroundings, Track& stretch) {
  if (length_m(stretch.axis) > kLongestWhole_m) return false;
  const BothSides facts = facts_beside(surroundings, stretch);
  const bool has_left = add_pavement(stretch, map::kLeftSide, facts.left);
  return add_pavement(stretch, map::kRightSide, facts.right) || has_left;
}

}  // namespace

bool has_usual_pavements(LandCoverClass surface, CountryGroup country) {
  double score = class_score(surface).value_or(0);
  for (const CountryScore& row : kCountryScores)
    if (row.country == country && row.surface == surface) score += row.score;
  return score > 0;
}

std::vector<Track> assume_pavements(const map::FeatureView& features, Report& report) {
  const Surroundings surroundings = index_surroundings(features);
  const CommonNodes common = common_nodes_of(features.tracks);
  Account account;
  std::vector<Track> tracks;
  for (const Track& track : features.tracks) {
    const bool counts = report.counts(track.id.osm);
    std::vector<Track> stretches =
        may_have_pavement(track) ? cut_way(track, kLongestWhole_m, kStretch_m, common) : std::vector{track};
    bool is_any = false;
    for (Track& stretch : stretches) {
      if (may_have_pavement(stretch)) is_any |= add_pavements(surroundings, stretch);
      tracks.push_back(std::move(stretch));
    }
    if (is_any) report.count_assumed(Assumption::kPavements, track.id.osm);
    if (counts) ++account.in, account.split += stretches.size() - 1, account.out += stretches.size();
  }
  report.account("assume", "track") = account;
  return tracks;
}

}  // namespace citykiln::assume
