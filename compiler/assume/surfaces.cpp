#include "compiler/assume/surfaces.h"

#include "compiler/assume/cut_way.h"
#include "compiler/assume/pavements.h"

namespace citykiln::assume {
namespace {

struct UnpavedRow {
  map::LandCoverClass paved, unpaved;
  LandUse land;
};
constexpr UnpavedRow kUnpavedRows[] = {
#define UNPAVED(paved, unpaved, land) {map::LandCoverClass::paved, map::LandCoverClass::unpaved, LandUse::land},
#include "compiler/assume/surfaces.inc"
#undef UNPAVED
};

bool may_be_unpaved(const map::Track& track) {
  if (track.has_tagged_surface || track.passage != map::Passage::kGround || track.is_rail || track.is_indoor)
    return false;
  if (track.is_through_building) return false;
  for (const UnpavedRow& row : kUnpavedRows)
    if (row.paved == track.surface) return true;
  return false;
}

}  // namespace

map::LandCoverClass assumed_surface(map::LandCoverClass surface, LandUse land) {
  for (const UnpavedRow& row : kUnpavedRows)
    if (row.paved == surface && row.land == land) return row.unpaved;
  return surface;
}

std::vector<map::Track> assume_surfaces(const map::Features& features, Report& report) {
  const Surroundings surroundings = index_surroundings(features);
  const CommonNodes common = common_nodes_of(features.tracks);
  Account account;
  std::vector<map::Track> tracks;
  OsmId last{};
  for (const map::Track& track : features.tracks) {
    const bool may_be_cut = may_be_unpaved(track) && !track.is_piece;
    std::vector<map::Track> stretches =
        may_be_cut ? cut_way(track, kLongestWhole_m, kStretch_m, common) : std::vector{track};
    for (map::Track& stretch : stretches) {
      if (may_be_unpaved(stretch) && length_m(stretch.axis) <= kLongestWhole_m)
        stretch.surface = assumed_surface(stretch.surface, land_use_along(surroundings, stretch.axis));
      const bool is_new = stretch.surface != track.surface;
      if (is_new) stretch.assumed |= bit_of(Assumption::kSurfaces);
      // the pieces of a way are one object
      if (is_new && last != track.id.osm)
        report.count_assumed(Assumption::kSurfaces, track.id.osm), last = track.id.osm;
      tracks.push_back(std::move(stretch));
    }
    if (report.counts(track.id.osm))
      ++account.in, account.split += stretches.size() - 1, account.out += stretches.size();
  }
  report.account("assume", "surface_track") = account;
  return tracks;
}

}  // namespace citykiln::assume
