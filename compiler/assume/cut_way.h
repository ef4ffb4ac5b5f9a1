// Cuts long ways into pieces, so that an assumption about a piece does not depend on distant parts of the way.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// The ids of the nodes that several tracks share, or that one track passes twice: ascending, each once.
using CommonNodes = std::vector<std::int64_t>;
/// Returns the common nodes of these tracks. O(n log n), n: nodes of all tracks.
CommonNodes common_nodes_of(std::span<const map::Track> tracks);

/// Returns the pieces of a way that is longer than `longest_m`, else the way alone. The axis is divided into windows of
/// `piece_m`, from its first point on. In each window but the last the way is cut at the last common node, else at the
/// last node; a window without a node has no cut. So a cut depends only on the nodes of its window, and a piece is at
/// most twice as long as a window, unless windows without a node follow.
///
/// > o-----o---+-o--+--|--o---o---o-|---+----o     + common nodes, | ends of windows
/// > ^              ^             ^           ^     ends of pieces
///
/// Two neighbouring pieces both have the node between them, with its TrackPoint. The ids of the pieces are the way's,
/// with the parts 0, 1, 2 … in its direction. A way that is cut must have the part 0 and an axis_drift of 0.
/// O(n log m), n: nodes of the way, m: common nodes.
std::vector<map::Track> cut_way(const map::Track& way, double longest_m, double piece_m, const CommonNodes& common);

/// Returns the tracks after an assumption about their stretches. A changed way is counted as assumed once.
/// @param account  The name of the account in the room "assume": tracks, and the pieces that they become.
/// @param cut      cut(track): the stretches of a track, or the track alone.
/// @param change   change(stretch): true if it changed the stretch, which is then marked.
template <typename Cut, typename Change>
std::vector<map::Track> with_changed_stretches(std::span<const map::Track> tracks, Assumption assumption,
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
