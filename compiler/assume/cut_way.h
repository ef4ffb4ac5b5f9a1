// Cuts long ways into stretches of bounded length, so that what is assumed of one does not depend on its other end.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// The map nodes that several tracks share, or one passes twice: sorted.
using CommonNodes = std::vector<std::int64_t>;
CommonNodes common_nodes_of(const std::vector<map::Track>& tracks);

/// Returns a way in pieces, if it is longer than `longest_m`: each is cut at the last common node within `piece_m` of
/// its first point, else at the last node there, else at the next node. Both pieces have the node and its marks. A
/// piece has the way's id with its number as part, from 0 on. The axis does not drift. O(n log n).
std::vector<map::Track> cut_way(const map::Track& way, double longest_m, double piece_m, const CommonNodes& common);

/// Returns the tracks after an assumption about their stretches. A changed way is counted as assumed once.
/// @param account  The name of the account in the room "assume": tracks, and the pieces that they become.
/// @param cut      cut(track): the stretches of a track, or the track alone.
/// @param change   change(stretch): true if it changed the stretch, which is then marked.
template <typename Cut, typename Change>
std::vector<map::Track> with_changed_stretches(const std::vector<map::Track>& tracks, Assumption assumption,
                                               const char* account, Cut cut, Change change, Report& report) {
  Account counts;
  std::vector<map::Track> all;
  OsmId last{};
  for (const map::Track& track : tracks) {
    std::vector<map::Track> stretches = cut(track);
    for (map::Track& stretch : stretches) {
      if (change(stretch)) {
        stretch.assumed |= bit_of(assumption);
        // the pieces of a way follow each other, and are one object
        if (last != track.id.osm) report.count_assumed(assumption, track.id.osm);
        last = track.id.osm;
      }
      all.push_back(std::move(stretch));
    }
    if (report.counts(track.id.osm)) ++counts.in, counts.split += stretches.size() - 1, counts.out += stretches.size();
  }
  report.account("assume", account) = counts;
  return all;
}

}  // namespace citykiln::assume
