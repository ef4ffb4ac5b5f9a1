#include "compiler/assume/curves/curves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "compiler/assume/curves/curved_line.h"
#include "compiler/assume/curves/free_room.h"
#include "compiler/geometry/mathematics.h"
#include "compiler/map/ways/curve_nodes.h"

namespace citykiln::assume {
namespace {

using map::LandCoverClass;
using map::Track;

/// The largest distances of the straight pieces from curves. Wide roads show them most, and points cost bytes.
constexpr double kErrorOfRoads_m = 0.1, kErrorOfWater_m = 0.2, kErrorOfBarriers_m = 0.05;
/// The largest reach of a bulge (geometry/curved_chord.h): a straight street stays straight beyond.
constexpr double kReachInTown_m = 40, kReachInTheOpen_m = 96;

// Paths and tracks are narrow, so that their corners are hardly seen, and have more than all roads.
bool is_narrow(const Track& track) {
  return map::family_of(track.surface) == map::Family::kPath || track.surface == LandCoverClass::kFarmTrack;
}

bool keeps_axis(const Track& track) {
  return is_narrow(track) || track.is_through_building || track.is_covered || track.is_arcade || track.is_indoor ||
         track.surface == LandCoverClass::kRunway || track.section.axis_drift != 0;
}

// The limits of a chord for which these hold, whatever its length.
ChordLimits limits_of(ChordLimits limits, Vec2 a, Vec2 b) {
  const double length_m = distance(a, b);
  if (length_m > kLongestChord_m) return {};
  limits.most_m = std::min(limits.most_m, kMostOfChord * length_m);
  return limits;
}

ChordLimits limits_of_road(const BuildingOutlines& walls, Vec2 a, Vec2 b) {
  if (is_in_town(walls, a, b)) return limits_of({kMostOfRoads_m, kReachInTown_m, kErrorOfRoads_m}, a, b);
  const double most_m = std::clamp(kMostInTheOpen * distance(a, b), kMostOfRoads_m, kMostInTheOpen_m);
  return limits_of({most_m, kReachInTheOpen_m, kErrorOfRoads_m}, a, b);
}

std::vector<ChordLimits> chords_of(const Track& track, const BuildingOutlines& walls) {
  std::vector<ChordLimits> chords(track.axis.size() - 1);
  for (std::size_t c = 0; c < chords.size() && !keeps_axis(track); ++c)
    chords[c] = limits_of_road(walls, track.axis[c], track.axis[c + 1]);
  return chords;
}

// Circles of ground lie about these nodes, with junctions of their own.
std::vector<bool> corners_of(const Track& track) {
  std::vector<bool> corners(track.axis.size());
  for (const map::TrackPoint& point : track.points)
    if (point.kind == map::TrackPointKind::kTurningCircle || point.kind == map::TrackPointKind::kTurningLoop ||
        point.kind == map::TrackPointKind::kMiniRoundabout)
      corners[point.vertex] = true;
  return corners;
}

CurvableLine line_of(const Track& track, const BuildingOutlines& walls) {
  return {.axis = track.axis,
          .nodes = track.node_ids,
          .network = static_cast<int>(map::family_of(track.surface)),
          .priority = map::values_of(track.surface).priority,
          .is_circle = track.is_roundabout,
          .chords = chords_of(track, walls),
          .is_corner = corners_of(track)};
}

Track with_axis(Track track, CurvedLine line) {
  std::vector<std::int64_t> node_ids;
  std::size_t next = 0;
  for (std::uint32_t v = 0; v < line.axis.size(); ++v) {
    const bool is_mapped = v == line.mapped[next];
    node_ids.push_back(is_mapped ? track.node_ids[next] : map::curve_node_id(track.id, v));
    if (is_mapped) ++next;
  }
  for (map::TrackPoint& point : track.points) point.vertex = line.mapped[point.vertex];
  track.axis = std::move(line.axis), track.node_ids = std::move(node_ids);
  track.assumed |= bit_of(Assumption::kCurves);
  return track;
}

// The distance from the axis that a road needs between walls.
double room_m(const Track& track) {
  return std::max(map::left_kerb_m(track.section), map::right_kerb_m(track.section)) + map::kMinPavement_m;
}

// Ids of the places of points: equal at equal places. O(n log n).
std::vector<std::vector<std::int64_t>> ids_of_places(const std::vector<std::span<const Vec2>>& axes) {
  std::vector<Vec2> places;
  for (const std::span<const Vec2> axis : axes) places.insert(places.end(), axis.begin(), axis.end());
  std::ranges::sort(places);
  std::vector<std::vector<std::int64_t>> ids(axes.size());
  for (std::size_t i = 0; i < axes.size(); ++i)
    for (const Vec2 p : axes[i]) ids[i].push_back(std::ranges::lower_bound(places, p) - places.begin());
  return ids;
}

std::vector<std::span<const Vec2>> axes_of(const auto& features) {
  std::vector<std::span<const Vec2>> axes;
  for (const auto& feature : features) axes.emplace_back(feature.axis);
  return axes;
}

std::vector<double> turns_deg(std::span<const Vec2> axis) {
  std::vector<double> turns(axis.size());
  for (std::size_t v = 1; v + 1 < axis.size(); ++v) {
    const Vec2 in = axis[v] - axis[v - 1], out = axis[v + 1] - axis[v];
    turns[v] = arctangent2_deg(cross(in, out), dot(in, out));
  }
  return turns;
}

// Corners of a barrier: points that are not the middle or an end of three that turn alike, by at most 40 degrees.
std::vector<bool> corners_of_barrier(std::span<const Vec2> axis) {
  constexpr double kMost_deg = 40, kLeast_deg = 4, kLongest_m = 20;
  const std::vector<double> turns = turns_deg(axis);
  const auto bends = [&](std::size_t v, double sign) {
    const double turn = turns[v] * sign;
    return turn >= kLeast_deg && turn <= kMost_deg && distance(axis[v - 1], axis[v]) <= kLongest_m &&
           distance(axis[v], axis[v + 1]) <= kLongest_m;
  };
  std::vector<bool> corners(axis.size(), true);
  for (std::size_t v = 2; v + 2 < axis.size(); ++v) {
    const double sign = turns[v] < 0 ? -1 : 1;
    if (bends(v - 1, sign) && bends(v, sign) && bends(v + 1, sign))
      corners[v - 1] = corners[v] = corners[v + 1] = false;
  }
  return corners;
}

std::vector<ChordLimits> equal_chords(std::span<const Vec2> axis, const ChordLimits& limits) {
  std::vector<ChordLimits> chords;
  for (std::size_t c = 0; c + 1 < axis.size(); ++c) chords.push_back(limits_of(limits, axis[c], axis[c + 1]));
  return chords;
}

bool is_always_free(std::size_t, std::size_t, const Polyline&) { return true; }

}  // namespace

std::vector<Track> curved_tracks(const map::FeatureView& features, Report& report) {
  const BuildingOutlines walls = building_outlines(features.footprints);
  std::vector<CurvableLine> lines;
  for (const Track& track : features.tracks) lines.push_back(line_of(track, walls));
  const WayPieces ways = pieces_of_ways(features.tracks);
  const auto has_room = [&](std::size_t l, std::size_t, const Polyline& curve) {
    const Track& track = features.tracks[l];
    return track.passage != map::Passage::kGround ||
           (has_room_between(walls, curve, room_m(track)) && keeps_off_other_ways(ways, track, curve));
  };
  std::vector<CurvedLine> curved = curved_lines(lines, has_room);
  std::vector<Track> tracks;
  OsmId last{};
  for (std::size_t t = 0; t < curved.size(); ++t) {
    const Track& track = features.tracks[t];
    tracks.push_back(curved[t].is_curved() ? with_axis(track, std::move(curved[t])) : track);
    // the pieces of a way follow each other, and are one object
    if (has(tracks.back().assumed, Assumption::kCurves) && last != track.id.osm)
      report.count_assumed(Assumption::kCurves, track.id.osm), last = track.id.osm;
  }
  return tracks;
}

std::vector<map::Waterway> curved_waterways(std::span<const map::Waterway> waterways) {
  const std::vector<std::vector<std::int64_t>> ids = ids_of_places(axes_of(waterways));
  std::vector<CurvableLine> lines;
  for (std::size_t w = 0; w < waterways.size(); ++w) {
    const map::Waterway& way = waterways[w];
    const bool is_wide = way.width_m >= kWideWater_m;
    const double most_m = way.passage == map::Passage::kGround && is_wide ? kMostOfWater_m : 0;
    lines.push_back({.axis = way.axis,
                     .nodes = ids[w],
                     .network = 0,
                     .priority = 0,
                     .is_circle = false,
                     .chords = equal_chords(way.axis, {most_m, kReachInTheOpen_m, kErrorOfWater_m})});
  }
  std::vector<CurvedLine> curved = curved_lines(lines, is_always_free);
  std::vector<map::Waterway> made(waterways.begin(), waterways.end());
  for (std::size_t w = 0; w < made.size(); ++w) made[w].axis = std::move(curved[w].axis);
  return made;
}

std::vector<map::Barrier> curved_barriers(std::span<const map::Barrier> barriers) {
  using map::BarrierKind;
  const std::vector<std::vector<std::int64_t>> ids = ids_of_places(axes_of(barriers));
  std::vector<CurvableLine> lines;
  for (std::size_t b = 0; b < barriers.size(); ++b) {
    const map::Barrier& barrier = barriers[b];
    const bool may_curve = barrier.kind != BarrierKind::kRetainingWall && barrier.kind != BarrierKind::kCityWall;
    lines.push_back(
        {.axis = barrier.axis,
         .nodes = ids[b],
         .network = 0,
         .priority = 0,
         .is_circle = false,
         .chords = equal_chords(barrier.axis, {may_curve ? kMostOfBarriers_m : 0, kReachInTown_m, kErrorOfBarriers_m}),
         .is_corner = corners_of_barrier(barrier.axis)});
  }
  std::vector<CurvedLine> curved = curved_lines(lines, is_always_free);
  std::vector<map::Barrier> made(barriers.begin(), barriers.end());
  for (std::size_t b = 0; b < made.size(); ++b) made[b].axis = std::move(curved[b].axis);
  return made;
}

}  // namespace citykiln::assume
