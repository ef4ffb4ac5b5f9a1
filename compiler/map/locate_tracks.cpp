#include <array>

#include "compiler/geometry/snap.h"
#include "compiler/map/each_line.h"
#include "compiler/map/pavements.h"

namespace citykiln::map {
namespace {

struct TrackRow {
  std::string_view key, value;
  SurfaceClass surface;
  double width_m;
  int lanes;
};

constexpr TrackRow kTracks[] = {
#define TRACK(key, value, surface, width_m, lanes) {key, value, SurfaceClass::surface, width_m, lanes},
#include "compiler/map/track_rules.inc"
#undef TRACK
};

constexpr std::array<std::string_view, 3> kTrackKeys = {"highway", "railway", "aeroway"};

bool carries_track_key(const Reading& reading, const source::Way& way) {
  for (const std::string_view key : kTrackKeys)
    if (!reading.tag(way.tags, key).empty()) return true;
  return false;
}

const TrackRow* row_of(const Reading& reading, const source::Way& way) {
  for (const TrackRow& row : kTracks)
    if (reading.tag(way.tags, row.key) == row.value) return &row;
  return nullptr;
}

bool is_unpaved(std::string_view surface) {
  constexpr std::array<std::string_view, 9> kUnpaved = {"unpaved", "gravel",      "ground",    "dirt", "earth",
                                                        "grass",   "fine_gravel", "compacted", "sand"};
  for (const std::string_view name : kUnpaved)
    if (surface == name) return true;
  return false;
}

// What the surface=* tag makes of a class.
SurfaceClass surfaced(SurfaceClass surface, std::string_view tagged) {
  if (surface == SurfaceClass::kPavedFootPath && is_unpaved(tagged)) return SurfaceClass::kFootPath;
  if (surface == SurfaceClass::kServiceRoad && is_unpaved(tagged)) return SurfaceClass::kUnpavedRoad;
  if (surface == SurfaceClass::kFarmTrack && (tagged == "asphalt" || tagged == "paved" || tagged == "concrete"))
    return SurfaceClass::kServiceRoad;
  return surface;
}

constexpr double kLeastWidth_m = 0.3, kMostWidth_m = 80;
constexpr int kMostLanes = 16;

double width_m(const Reading& reading, OsmId id, source::Range tags, const TrackRow& row) {
  if (const auto tagged = tagged_length_m(reading, id, tags, "width", kLeastWidth_m, kMostWidth_m)) return *tagged;
  if (row.lanes == 0) return row.width_m;
  const std::string_view oneway = reading.tag(tags, "oneway");
  double lanes = row.lanes == 2 && says_yes(oneway) && row.surface != SurfaceClass::kMotorwayRoad ? 1 : row.lanes;
  if (const std::string_view text = reading.tag(tags, "lanes"); !text.empty()) {
    const auto tagged = number_of(text);
    if (tagged && *tagged >= 1 && *tagged <= kMostLanes)
      lanes = *tagged;
    else
      reading.report.add(Code::kBadTagValue, id);
  }
  // a single lane is never narrower than a parked row and a lorry
  return std::max(lanes * row.width_m, 3.5);
}

Track track_of(const Reading& reading, const source::Way& way, const TrackRow& row, LocatedLine&& line) {
  const OsmId id{OsmType::kWay, way.id};
  Track track{{id, 0}, std::move(line.axis), std::move(line.node_ids), row.surface};
  track.surface = surfaced(row.surface, reading.tag(way.tags, "surface"));
  track.width_m = std::max(kQuantum_m, snapped(width_m(reading, id, way.tags, row)));
  track.layer = tagged_layer(reading, id, way.tags);
  track.passage = tagged_passage(reading, way.tags);
  track.is_oneway = says_yes(reading.tag(way.tags, "oneway"));
  track.is_lit = says_yes(reading.tag(way.tags, "lit"));
  track.is_rail = row.key == "railway";
  const Pavements pavements = pavements_of(reading, id, way.tags);
  track.pavement_left_m = pavements.left_m, track.pavement_right_m = pavements.right_m;
  return track;
}

}  // namespace

std::vector<Track> locate_tracks(const Reading& reading) {
  std::vector<Track> tracks;
  for_each_line(
      reading, "track", [&](const source::Way& way) { return carries_track_key(reading, way); },
      [&](const source::Way& way) { return row_of(reading, way); },
      [&](const source::Way& way, const TrackRow& row, LocatedLine&& line) {
        tracks.push_back(track_of(reading, way, row, std::move(line)));
      });
  return tracks;
}

}  // namespace citykiln::map
