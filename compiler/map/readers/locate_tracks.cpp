#include <algorithm>
#include <array>
#include <cstdlib>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/countries/driving_side.h"
#include "compiler/map/countries/road_guidelines.h"
#include "compiler/map/lanes/lane_tags.h"
#include "compiler/map/lanes/lanes.h"
#include "compiler/map/lanes/track_points.h"
#include "compiler/map/lanes/track_rules.h"
#include "compiler/map/lanes/transitions.h"
#include "compiler/map/rails_in_streets.h"
#include "compiler/map/readers/for_each_line.h"
#include "compiler/map/readers/plant_tags.h"
#include "compiler/map/tagged_words.h"

namespace citykiln::map {
namespace {

constexpr std::array<std::string_view, 3> kTrackKeys = {"highway", "railway", "aeroway"};

// A closed runway is the outline of its area.
bool is_outline_of_runway(const ReadContext& context, const source::Way& way) {
  const auto nodes = context.osm.nodes_of(way);
  const bool is_closed = nodes.size() > 3 && nodes.front().id == nodes.back().id;
  return is_closed && context.tag(way.tags, "aeroway") == "runway" && context.tag(way.tags, "area") != "no";
}

bool carries_track_key(const ReadContext& context, const source::Way& way) {
  if (is_outline_of_runway(context, way)) return false;
  for (const std::string_view key : kTrackKeys)
    if (!context.tag(way.tags, key).empty()) return true;
  return false;
}

// Rack railways climb like funiculars.
LandCoverClass racked(LandCoverClass surface, std::string_view rack) {
  return surface == LandCoverClass::kRailway && says_yes(rack) ? LandCoverClass::kFunicular : surface;
}

// The class after surface=*.
LandCoverClass surfaced(LandCoverClass surface, std::string_view tagged) {
  const std::optional<bool> paved = is_paved_surface(tagged);
  if (!paved) return surface;
  if (*paved) return surface == LandCoverClass::kFarmTrack ? LandCoverClass::kServiceRoad : surface;
  if (surface == LandCoverClass::kPavedFootPath) return LandCoverClass::kFootPath;
  return surface == LandCoverClass::kServiceRoad ? LandCoverClass::kUnpavedRoad : surface;
}

LonLat place_of_way(const ReadContext& context, const source::Way& way) {
  const source::Location at = context.osm.nodes_of(way).front().at;
  return {at.lon_deg(), at.lat_deg()};
}

// A path through a building on an upper storey is a corridor in it, unlike one on the ground.
bool is_upper_passage(const ReadContext& context, const source::Way& way, const Track& track) {
  return track.layer > 0 && values_of(track.surface).group == LandCoverGroup::kPath &&
         context.tag(way.tags, "tunnel") == "building_passage" && !says_yes(context.tag(way.tags, "bridge"));
}

// True if the element lies on a storey other than the ground's, or inside rooms.
bool is_indoor(const ReadContext& context, source::Range tags) {
  const std::string_view level = context.tag(tags, "level");
  return says_yes(context.tag(tags, "indoor")) || context.tag(tags, "highway") == "corridor" ||
         (!level.empty() && number_of(level).value_or(1) != 0);
}

bool is_arcade(const ReadContext& context, source::Range tags) {
  const auto is_open = [](std::string_view value) {
    return value == "arcade" || value == "colonnade" || value == "open" || value == "gallery";
  };
  return is_open(context.tag(tags, "covered")) || says_yes(context.tag(tags, "arcade")) ||
         is_open(context.tag(tags, "tunnel"));
}

// The clearance of a way, between a crawlway's and a hall's; 0 if it is not tagged.
double tagged_clearance_m(const ReadContext& context, OsmId id, source::Range tags) {
  constexpr double kLeast_m = 1, kMost_m = 30;
  for (const std::string_view key : {"maxheight:physical", "maxheight", "height"}) {
    const std::string_view value = context.tag(tags, key);
    // words such as default or below_default state a law
    if (value.empty() || value.front() < '0' || value.front() > '9') continue;
    if (const auto height = tagged_length_m(context, id, tags, key, kLeast_m, kMost_m)) return *height;
  }
  return 0;
}

void read_cover(const ReadContext& context, source::Range tags, Track& track) {
  track.is_arcade = is_arcade(context, tags);
  track.is_covered =
      track.is_arcade || context.tag(tags, "tunnel") == "building_passage" || says_yes(context.tag(tags, "covered"));
  track.is_indoor = is_indoor(context, tags);
  track.has_tagged_layer = !context.tag(tags, "layer").empty();
  track.is_through_building = track.is_covered || !context.tag(tags, "level").empty();
  if (track.is_covered || track.passage == Passage::kTunnel)
    track.clear_m = tagged_clearance_m(context, track.id.osm, tags);
}

// Both sides unless sides are named.
std::uint8_t tagged_handrails(const ReadContext& context, source::Range tags) {
  unsigned rails = 0;
  if (says_yes(context.tag(tags, "handrail:left"))) rails |= kHandrailLeft;
  if (says_yes(context.tag(tags, "handrail:right"))) rails |= kHandrailRight;
  if (says_yes(context.tag(tags, "handrail:center")) || says_yes(context.tag(tags, "handrail:centre")))
    rails |= kHandrailCentre;
  const std::string_view all = context.tag(tags, "handrail");
  if (all == "left" || all == "right" || all == "center")
    rails |= all == "left" ? kHandrailLeft : all == "right" ? kHandrailRight : kHandrailCentre;
  else if (rails == 0 && says_yes(all))
    rails = kHandrailLeft | kHandrailRight;
  return static_cast<std::uint8_t>(rails);
}

void read_stairs(const ReadContext& context, source::Range tags, Track& track) {
  constexpr double kMostSteps = 5000;
  const std::string_view count = context.tag(tags, "step_count");
  if (const auto steps = number_within(context, track.id.osm, "step_count", count, 1, kMostSteps))
    track.step_count = static_cast<std::uint16_t>(*steps);
  track.handrails = tagged_handrails(context, tags);
}

// Tramways have no other line than one above the track. The value may be a list, such as "contact_line;rail".
bool has_contact_line(std::string_view electrified, LandCoverClass surface) {
  if (surface == LandCoverClass::kTram && electrified == "yes") return true;
  return electrified.find("contact_line") != std::string_view::npos;
}

// The values name sides: "yes", "both", "left", "right".
bool is_in_earthwork(const ReadContext& context, source::Range tags) {
  return std::ranges::any_of(std::array{context.tag(tags, "cutting"), context.tag(tags, "embankment")},
                             [](std::string_view value) { return !value.empty() && value != "no"; });
}

void tell_layer(const Track& track, Report& report) {
  if (track.passage == Passage::kBridge && track.layer == 0) report.add(Code::kBridgeWithoutLayer, track.id.osm);
  // paths in tunnels without a layer are corridors in buildings
  if (track.passage == Passage::kTunnel && track.layer == 0 && values_of(track.surface).group != LandCoverGroup::kPath)
    report.add(Code::kTunnelWithoutLayer, track.id.osm);
  if (track.passage == Passage::kGround && track.layer != 0)
    report.add(Code::kLayerWithoutBridge, track.id.osm, std::abs(track.layer));
}

Track track_of(const ReadContext& context, std::optional<DrivingSide> driving_side, const source::Way& way,
               const TrackRow& row, LocatedLine&& line) {
  const OsmId id{OsmType::kWay, way.id};
  const LonLat place = place_of_way(context, way);
  const DrivingSide side = driving_side ? *driving_side : driving_side_at(place);
  Track track;
  track.id = {id, 0};
  track.axis = std::move(line.axis);
  track.node_ids = std::move(line.node_ids);
  track.surface = racked(surfaced(row.surface, context.tag(way.tags, "surface")), context.tag(way.tags, "rack"));
  track.side = side;
  track.country = country_group_at(place);
  TaggedSection section = tagged_section_of(context, id, way.tags, side, guidelines_at(place));
  track.section = std::move(section.section);
  track.has_tagged_width = section.has_width, track.has_tagged_placement = section.has_placement;
  track.is_transition = section.is_transition;
  track.tagged_pavements = section.tagged_pavements, track.fixed_pavements = section.fixed_pavements;
  track.tagged_verges = section.tagged_verges, track.tagged_parking = section.tagged_parking;
  track.has_tagged_surface = !context.tag(way.tags, "surface").empty();
  track.layer = tagged_layer(context, id, way.tags);
  track.passage = is_upper_passage(context, way, track) ? Passage::kTunnel : tagged_passage(context, way.tags);
  read_cover(context, way.tags, track);
  if (track.surface == LandCoverClass::kSteps) read_stairs(context, way.tags, track);
  track.is_in_earthwork = is_in_earthwork(context, way.tags);
  track.is_oneway = tagged_traffic(context.tag(way.tags, "oneway")).value_or(Traffic::kTwoWay) != Traffic::kTwoWay;
  track.is_lit = says_yes(context.tag(way.tags, "lit"));
  track.has_tagged_lighting = !context.tag(way.tags, "lit").empty();
  track.is_rail = row.key == "railway";
  track.has_contact_line = track.is_rail && has_contact_line(context.tag(way.tags, "electrified"), track.surface);
  track.trees = tree_sides_of(context.tag(way.tags, "tree_lined"));
  const std::string_view junction = context.tag(way.tags, "junction");
  track.is_roundabout = junction == "roundabout" || junction == "circular";
  track.is_link = row.value.ends_with("_link");
  tell_layer(track, context.report);
  return track;
}

// True if a road also has rails.
bool has_street_rails(const ReadContext& context, const source::Way& way, const TrackRow& row) {
  const std::string_view railway = context.tag(way.tags, "railway");
  const bool are_rails = railway == "tram" || railway == "light_rail" || railway == "rail" || railway == "narrow_gauge";
  return row.key == "highway" && are_rails && presence_of(context.osm, way.tags, "railway") != Presence::kGone;
}

// The rails of a way that is both a road and a railway: a track of its own, in the middle of the road.
Track street_rails_of(const ReadContext& context, const source::Way& way, const Track& road) {
  Track rails = as_street_rails(road);
  rails.id = derived_id({road.id.osm, 0}, 0);
  rails.is_rail = true;
  rails.is_lit = rails.is_link = rails.is_roundabout = rails.is_transition = false;
  rails.has_tagged_width = rails.has_tagged_surface = rails.has_tagged_lighting = true;
  rails.tagged_pavements = rails.fixed_pavements = rails.tagged_verges = rails.tagged_parking = kBothSides;
  rails.has_contact_line = has_contact_line(context.tag(way.tags, "electrified"), LandCoverClass::kTram);
  rails.trees = {}, rails.points.clear(), rails.step_count = 0, rails.handrails = 0;
  // the rails lie in the middle of the carriageway
  rails.section.axis_offset_m =
      snapped_to(1.0 / 2048, road.section.axis_offset_m - carriageway_width_m(road.section) / 2 +
                                 carriageway_width_m(rails.section) / 2);
  rails.section.axis_drift = road.section.axis_drift;
  return rails;
}

// The code with which a way on an upper storey or in rooms is dropped. Ways below the ground are tunnels.
std::optional<Code> reason_off_ground(const ReadContext& context, const source::Way& way) {
  if (context.tag(way.tags, "highway").empty()) return std::nullopt;
  if (context.tag(way.tags, "highway") == "corridor") return Code::kInsideBuilding;
  const auto is_yes = [&](std::string_view key) { return says_yes(context.tag(way.tags, key)); };
  if (is_yes("bridge") || is_yes("tunnel")) return std::nullopt;
  const std::optional<Code> reason =
      reason_to_drop({.storey = standing_of_object(context.osm, way.tags, "highway").storey});
  return reason == Code::kUnderground ? std::nullopt : reason;
}

// Ways underground are tunnels, so those are dropped that are gone or not finished, and those above and in rooms.
std::optional<Code> reason_without_track(const ReadContext& context, const source::Way& way) {
  for (const std::string_view key : kTrackKeys) {
    const std::string_view value = context.tag(way.tags, key);
    if (value.empty()) continue;
    if (presence_of(context.osm, way.tags, key) == Presence::kGone || value == "construction") return Code::kNotThere;
  }
  return reason_off_ground(context, way);
}

}  // namespace

std::vector<Track> locate_tracks(const ReadContext& context, std::optional<DrivingSide> side) {
  std::vector<Track> tracks;
  const std::vector<NodeMark> marks = node_marks(context);
  for_each_line(
      context, "track", [&](const source::Way& way) { return carries_track_key(context, way); },
      [&](const source::Way& way) {
        return track_row([&](std::string_view key) { return context.tag(way.tags, key); });
      },
      [&](const source::Way& way) { return reason_without_track(context, way); },
      [&](const source::Way& way, const TrackRow& row, LocatedLine&& line) {
        std::vector<TrackPoint> points = points_of(context, way, line, marks);
        tracks.push_back(track_of(context, side, way, row, std::move(line)));
        tracks.back().points = std::move(points);
        if (has_street_rails(context, way, row)) tracks.push_back(street_rails_of(context, way, tracks.back()));
      });
  join_transitions(tracks);
  return tracks;
}

}  // namespace citykiln::map
