// Tracks as contact lines see them: axes with heights, stations along them, and the tracks beside each other at a
// station.
//
//     o-------|-----------|-----------|-------o     a way: stations at equal shares of its length, closer in curves
//     - - - - +- - - - - - - - - - - - - - - - -
//     --------+--------------------------------     a section: the tracks beside a station, across its direction
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/map/features.h"
#include "compiler/roads/recipe.h"
#include "compiler/structures/recipe.h"

namespace citykiln::things {

/// A railway or tramway that is not in a tunnel.
struct ContactTrack {
  ObjectId id;
  Polyline axis;
  std::vector<double> along_m;         ///< The distance of each vertex along the way.
  std::vector<std::int64_t> node_ids;  ///< The OSM node of each vertex.
  bool is_tram = false, is_on_bridge = false;
  bool has_contact_line = false;            ///< False below covers and in buildings.
  std::vector<const roads::Road*> parts{};  ///< The roads, or the bridge, that have its heights.
};

/// The tracks of a map, sorted by id, with an index of their segments.
struct TrackIndex {
  struct Segment {
    std::uint32_t track = 0, vertex = 0;
  };
  std::vector<ContactTrack> tracks;
  std::vector<Segment> segments;
  BoxGrid grid;
};

/// Returns the tracks of a map. Roads and bridges must outlive the index.
TrackIndex index_tracks(const map::FeatureView& features, std::span<const roads::Road> roads,
                        std::span<const structures::Span> bridges);

/// A place on an axis and the direction of the axis there, length 1.
struct AxisPlace {
  Vec2 at, along;
};
/// Returns the place at a distance along the way, which is limited to the way.
AxisPlace place_at(const ContactTrack& track, double along_m);
/// Returns the height of the track at a distance along the way: that of its profile, else of the ground.
double track_height_m(const ContactTrack& track, double along_m, const ground::GradedTerrain& ground);

/// The longest distances between supports, on straight track, of railways and of tramways in streets; and the shortest.
/// Source: Kiessling, Puschmann, Schmieder, Schneider, Contact Lines for Electric Railways (2018): 50 to 65 m for main
/// lines, 25 to 35 m for tramways.
inline constexpr double kRailSpan_m = 60, kTramSpan_m = 35, kShortestContactSpan_m = 15;
/// The distance by which a contact wire in a curve may lie off the axis between its supports and at them together: the
/// wire is within 0.4 m of the middle of the pantograph (TSI ENE, Regulation (EU) 1301/2014, 4.2.9.2), less room for
/// wind.
inline constexpr double kCurveOffset_m = 0.5;

/// Returns the longest span with its middle at a distance along the way: a whole multiple of 5 m up to that of a
/// straight, such that the axis there is at most kCurveOffset_m off the chord; kShortestContactSpan_m if none is.
double longest_span_m(const ContactTrack& track, double along_m);
/// Returns the stations of a way: distances along it, ascending, in the middles of n parts that are equal where the
/// track is straight and shorter in curves. A way shorter than 0.4 of a span has none. They depend on the way alone.
std::vector<double> stations_of(const ContactTrack& track);

/// The tracks that a section looks at: within this distance of the station on both sides.
inline constexpr double kSection_m = 64;
/// Neighbouring tracks of one group are at most this far apart; wider gaps have platforms, and masts of their own.
inline constexpr double kTracksApart_m = 7;

/// A track in a section.
struct SectionTrack {
  double left_m = 0;  ///< Its distance to the left of the station, across the station's direction.
  std::uint32_t track = 0;
  double along_m = 0;
};
/// Returns the group of tracks that the station belongs to, from right to left: parallel tracks on the ground of its
/// kind, each at most kTracksApart_m from the next. O(segments near).
std::vector<SectionTrack> section_at(const TrackIndex& index, std::uint32_t track, double along_m);

/// Returns the distance of the nearest axis of a track on the ground of its kind, at most `search_m`.
double distance_to_tracks(const TrackIndex& index, Vec2 p, bool of_trams, double search_m);

}  // namespace citykiln::things
