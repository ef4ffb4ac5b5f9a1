#include "compiler/roads/plan.h"

#include <algorithm>

namespace citykiln::roads {

Road road_of(const map::Track& track) {
  return {.id = track.id,
          .axis = track.axis,
          .surface = track.surface,
          .section = track.section,
          .side = track.side,
          .is_lit = track.is_lit,
          .is_link = track.is_link,
          .is_roundabout = track.is_roundabout,
          .points = track.points,
          .width_limits = {},
          .country = track.country,
          .assumed = track.assumed,
          .assumed_strips = track.assumed_strips};
}

std::vector<Road> plan(const map::Features& features, Report& report) {
  std::vector<Road> roads;
  Account account;
  for (const map::Track& track : features.tracks) {
    const bool counts = report.counts(track.id.osm);
    account.in += counts;
    // bridges and tunnels become structures
    if (track.passage != map::Passage::kGround) {
      account.merged += counts;
      continue;
    }
    account.out += counts;
    roads.push_back(road_of(track));
  }
  report.account("roads", "track") = account;
  return roads;
}

std::vector<OsmId> ways_through_buildings(const map::Features& features) {
  std::vector<OsmId> ids;
  for (const map::Track& track : features.tracks)
    if (track.is_through_building) ids.push_back(track.id.osm);
  for (const map::Passageway& passageway : features.passageways) ids.push_back(passageway.way.osm);
  std::ranges::sort(ids);
  return ids;
}

}  // namespace citykiln::roads
