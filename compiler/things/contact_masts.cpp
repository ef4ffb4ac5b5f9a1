#include "compiler/things/contact_masts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/plane/plane.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/structures/deck_dimensions.h"
#include "compiler/things/facing.h"
#include "compiler/things/free_places.h"
#include "compiler/things/generate.h"

namespace citykiln::things {
namespace {

using map::ThingRole;

// Masts stand at whole multiples of this from their track, so that they have few forms; heights are multiples of 1/8 m.
constexpr double kReachStep_m = 0.25, kHeightStep_m = 0.125;
constexpr double kMastSide_m = 0.5, kPoleSide_m = 0.25;
constexpr double kUsualReach_m = 3.25, kFarthestReach_m = 6, kFarthestArm_m = 8, kFarthestPole_m = 14;
constexpr double kWidestPortal_m = 44;
// Above the messenger wire, the top of a mast; above the contact wire of a tramway, the top of a pole.
constexpr double kMastAboveMessenger_m = 0.6, kPoleAboveWire_m = 1.5;
// Stations of a group that are nearer to each other than this share of a span are one.
constexpr double kNearStations = 0.35;
constexpr double kMastBucket_m = 64, kMappedReach_m = 7;
// Decks: their parapets and what a mast needs beside them; the distance of wires from their underside.
constexpr double kBesideDeck_m = 1.5, kBelowDeck_m = 0.3, kLeastSystem_m = 0.1, kOverTrack_m = 3;

// A place of a track where masts may stand.
struct Station {
  std::uint32_t track = 0, number = 0;
  double along_m = 0;
  AxisPlace place;
  std::vector<SectionTrack> group;
};

struct Deck {
  Vec2 a, b;
  const structures::Span* bridge;
  double from_m;  // of `a` along the bridge
};

// The data of all stations.
struct MastPlanner {
  const map::FeatureView& features;
  const ground::GradedTerrain& ground;
  FreePlaces places;
  std::vector<Deck> decks{};
  BoxGrid deck_grid{};
  std::vector<const map::ThingFeature*> mapped{};
  BoxGrid mapped_grid{};
};

void index_decks(std::span<const structures::Span> bridges, MastPlanner& planner) {
  std::vector<Box2> boxes;
  for (const structures::Span& bridge : bridges) {
    const std::vector<double> along_m = roads::distances_along(bridge);
    for (std::size_t i = 0; i + 1 < bridge.axis.size(); ++i) {
      planner.decks.push_back({bridge.axis[i], bridge.axis[i + 1], &bridge, along_m[i]});
      boxes.push_back(box_of_segment(bridge.axis[i], bridge.axis[i + 1]).widened(max_offset_m(bridge) + kBesideDeck_m));
    }
  }
  planner.deck_grid = grid_of(boxes, kMastBucket_m);
}

void index_mapped(MastPlanner& planner) {
  std::vector<Box2> boxes;
  for (const map::ThingFeature& thing : planner.features.things) {
    if (map::role_of(thing.kind) != ThingRole::kCatenaryMast) continue;
    planner.mapped.push_back(&thing);
    boxes.push_back(Box2{thing.at, thing.at}.widened(kMappedMasts_m));
  }
  planner.mapped_grid = grid_of(boxes, kMastBucket_m);
}

bool has_mapped_near(const MastPlanner& planner, Vec2 p) {
  return std::ranges::any_of(boxes_about(planner.mapped_grid, p),
                             [&](std::uint32_t i) { return distance(planner.mapped[i]->at, p) <= kMappedMasts_m; });
}

bool is_beside_deck(const MastPlanner& planner, Vec2 p) {
  return std::ranges::any_of(boxes_about(planner.deck_grid, p), [&](std::uint32_t i) {
    const Deck& deck = planner.decks[i];
    return distance_to_segment(deck.a, deck.b, p) <= max_offset_m(*deck.bridge) + kBesideDeck_m;
  });
}

bool may_stand(MastPlanner& planner, const TrackIndex& index, Vec2 p, bool is_tram) {
  if (!planner.features.extent.contains(p) || is_beside_deck(planner, p)) return false;
  if (!planner.places.is_free(p, is_tram ? kPoleSide_m / 2 : kMastSide_m / 2)) return false;
  return distance_to_tracks(index, p, false, kMastClear_m) >= kMastClear_m &&
         distance_to_tracks(index, p, true, kPoleClear_m) >= kPoleClear_m;
}

// ---- stations -------------------------------------------------------------------------------------------------------

bool decides(const TrackIndex& index, const Station& station) {
  return std::ranges::all_of(station.group, [&](const SectionTrack& s) {
    return s.track >= station.track || !index.tracks[s.track].has_contact_line;
  });
}

std::vector<Station> stations_on(const TrackIndex& index, std::uint32_t track, const std::vector<double>& at_m) {
  std::vector<Station> stations;
  for (std::uint32_t i = 0; i < at_m.size(); ++i) {
    Station station{track, i, at_m[i], place_at(index.tracks[track], at_m[i]), {}};
    station.group = section_at(index, track, at_m[i]);
    if (decides(index, station)) stations.push_back(std::move(station));
  }
  return stations;
}

// True if `other` is a station of the group of `station`, so near that one of them is enough.
bool is_same(const TrackIndex& index, const Station& station, const Station& other) {
  const Vec2 to = other.place.at - station.place.at;
  const bool is_tram = index.tracks[station.track].is_tram;
  if (is_tram != index.tracks[other.track].is_tram) return false;
  if (std::abs(dot(to, station.place.along)) > kNearStations * (is_tram ? kTramSpan_m : kRailSpan_m)) return false;
  const double left_m = cross(station.place.along, to);
  return left_m > station.group.front().left_m - 2 && left_m < station.group.back().left_m + 2;
}

// Leaves out stations near to one of a lower track.
std::vector<Station> without_near_ones(const TrackIndex& index, std::vector<Station> stations) {
  std::vector<Box2> boxes;
  for (const Station& s : stations) boxes.push_back(Box2{s.place.at, s.place.at}.widened(kSection_m));
  const BoxGrid grid = grid_of(boxes, kMastBucket_m);
  std::vector<Station> left;
  for (const Station& s : stations) {
    const bool is_near_lower = std::ranges::any_of(boxes_about(grid, s.place.at), [&](std::uint32_t i) {
      const Station& other = stations[i];
      return std::tie(other.track, other.number) < std::tie(s.track, s.number) && is_same(index, s, other);
    });
    if (!is_near_lower) left.push_back(s);
  }
  return left;
}

std::vector<Station> all_stations(const TrackIndex& index, const MastPlanner& planner) {
  std::vector<Station> stations;
  for (std::uint32_t t = 0; t < index.tracks.size(); ++t) {
    const ContactTrack& track = index.tracks[t];
    if (!track.has_contact_line || track.is_on_bridge) continue;
    for (Station& station : stations_on(index, t, stations_of(track)))
      if (!has_mapped_near(planner, station.place.at)) stations.push_back(std::move(station));
  }
  return without_near_ones(index, std::move(stations));
}

// ---- structures -----------------------------------------------------------------------------------------------------

// A structure at a station, before it is known to stand.
struct Structure {
  std::vector<Thing> things;
  std::vector<CrossWire> wires;
  std::vector<SectionTrack> held;
};

double wire_height_m(const ContactTrack& track) { return track.is_tram ? kTramWire_m : kRailWire_m; }

// A thing with its top at a plane height or up to kHeightStep_m above it.
Thing thing_with_top(const MastPlanner& planner, ThingRole role, Vec2 at, Vec2 faces, Vec2 size, double top_m) {
  Thing thing{.id = {},
              .at = snapped_to(map::kMapStep_m, at),
              .direction = nearest_direction(faces),
              .is_in_way = role == ThingRole::kContactPortal || role == ThingRole::kContactHanger,
              .form = {.kind = std::string(map::name_of(role)), .width_m = size.x, .depth_m = size.y}};
  const double high_m = top_m - place(thing, planner.ground).at.z;
  thing.form.height_m = std::max(1.0, std::ceil(high_m / kHeightStep_m) * kHeightStep_m);
  return thing;
}

// The stations of a group, with what its structures need.
struct StationSite {
  MastPlanner& planner;
  const TrackIndex& index;
  const Station& station;
  std::vector<SectionTrack> held;  // the tracks with a contact line
  double rail_m = 0;               // the highest of their heights
  bool is_tram = false;

  Vec2 at(double left_m) const { return station.place.at + left_of(station.place.along) * left_m; }
  bool is_free(double left_m) const { return may_stand(planner, index, at(left_m), is_tram); }
  double top_m() const {
    return rail_m + (is_tram ? kTramWire_m + kPoleAboveWire_m : kRailWire_m + kSystemHeight_m + kMastAboveMessenger_m);
  }
};

// The first free distance of a mast to the left (side 1) or right (side -1) of a place; 0: none.
double free_reach_m(const StationSite& site, double from_m, double side, double nearest_m, double farthest_m) {
  for (double reach_m = nearest_m; reach_m <= farthest_m; reach_m += kReachStep_m)
    if (site.is_free(from_m + side * reach_m)) return reach_m;
  return 0;
}

// A mast or a pole with an arm over the track at a distance to the left of the station.
Thing mast_beside(const StationSite& site, double track_left_m, double side, double reach_m) {
  const Vec2 left = left_of(site.station.place.along);
  const double width_m = site.is_tram ? kPoleSide_m : kMastSide_m;
  Thing mast = thing_with_top(site.planner, site.is_tram ? ThingRole::kContactPole : ThingRole::kContactMast,
                              site.at(track_left_m + side * reach_m), left * -side, {width_m, width_m}, site.top_m());
  mast.form.capacity = static_cast<std::uint16_t>(reach_m / kReachStep_m + 0.5);
  return mast;
}

// Cantilevers: the outer tracks have masts outside, others in spaces that are wide enough. False if one has no place.
bool add_cantilevers(const StationSite& site, Structure& structure) {
  const auto& group = site.station.group;
  for (const SectionTrack& s : site.held) {
    const auto own = std::ranges::find(group, s.track, &SectionTrack::track);
    const bool is_leftmost = std::next(own) == group.end(), is_rightmost = own == group.begin();
    // a track alone has its mast on the side that lies more to the north or east, so that masts stay on one side
    const Vec2 left = left_of(site.station.place.along);
    const double first_side = left.x + left.y >= 0 ? 1 : -1;
    double reach_m = 0, side = 0;
    for (const double tried : {first_side, -first_side}) {
      const bool is_outside = tried > 0 ? is_leftmost : is_rightmost;
      if (reach_m > 0) break;
      reach_m = free_reach_m(site, s.left_m, tried, is_outside ? kUsualReach_m : kMastClear_m,
                             is_outside ? kFarthestReach_m : kTracksApart_m - kMastClear_m);
      side = tried;
    }
    if (reach_m == 0) return false;
    structure.things.push_back(mast_beside(site, s.left_m, side, reach_m));
  }
  return true;
}

void add_hangers(const StationSite& site, double top_m, Structure& structure) {
  for (const SectionTrack& s : site.held)
    structure.things.push_back(thing_with_top(site.planner, ThingRole::kContactHanger, site.at(s.left_m),
                                              left_of(site.station.place.along), {kPoleSide_m, kPoleSide_m}, top_m));
}

// A portal over all tracks of the group. False if it would be too wide, or has no place.
bool add_portal(const StationSite& site, Structure& structure) {
  const double right_m = site.station.group.front().left_m, left_m = site.station.group.back().left_m;
  const double left_reach_m = free_reach_m(site, left_m, 1, kUsualReach_m, kFarthestReach_m),
               right_reach_m = free_reach_m(site, right_m, -1, kUsualReach_m, kFarthestReach_m);
  if (left_reach_m == 0 || right_reach_m == 0) return false;
  const double from_m = right_m - right_reach_m, to_m = left_m + left_reach_m;
  const double wide_m = std::ceil((to_m - from_m) / kReachStep_m) * kReachStep_m;
  if (wide_m > kWidestPortal_m || !site.is_free(from_m + wide_m)) return false;
  const Thing portal = thing_with_top(site.planner, ThingRole::kContactPortal, site.at(from_m + wide_m / 2),
                                      site.station.place.along, {wide_m, kMastSide_m}, site.top_m());
  add_hangers(site, place(portal, site.planner.ground).at.z + portal.form.height_m, structure);
  structure.things.push_back(portal);
  return true;
}

// Poles on both sides of a tramway with a wire across, else a pole with an arm that reaches the farther track.
bool add_poles(const StationSite& site, Structure& structure) {
  const double right_m = site.station.group.front().left_m, left_m = site.station.group.back().left_m;
  const double wide_m = left_m - right_m;
  const double left_reach_m = free_reach_m(site, left_m, 1, 2, kFarthestPole_m),
               right_reach_m = free_reach_m(site, right_m, -1, 2, kFarthestPole_m);
  if (left_reach_m > 0 && right_reach_m > 0) {
    std::array<Vec3, 2> ends;
    for (const double side : {-1.0, 1.0}) {
      Thing pole = mast_beside(site, side > 0 ? left_m : right_m, side, side > 0 ? left_reach_m : right_reach_m);
      pole.form.capacity = 0;
      ends[side > 0] = at_height(pole.at, site.top_m() - kHeightStep_m);
      structure.things.push_back(std::move(pole));
    }
    structure.wires.push_back({{}, ends[0], ends[1]});
    return true;
  }
  for (const double side : {1.0, -1.0}) {
    const double reach_m = side > 0 ? left_reach_m : right_reach_m;
    if (reach_m == 0 || reach_m + wide_m > kFarthestArm_m) continue;
    Thing pole = mast_beside(site, side > 0 ? left_m : right_m, side, reach_m);
    pole.form.capacity = static_cast<std::uint16_t>((reach_m + wide_m) / kReachStep_m + 0.999);
    structure.things.push_back(std::move(pole));
    return true;
  }
  return false;
}

std::optional<Structure> structure_at(MastPlanner& planner, const TrackIndex& index, const Station& station) {
  StationSite site{planner, index, station, {}, -1e9, index.tracks[station.track].is_tram};
  for (const SectionTrack& s : station.group) {
    if (!index.tracks[s.track].has_contact_line) continue;
    site.held.push_back(s);
    site.rail_m = std::max(site.rail_m, track_height_m(index.tracks[s.track], s.along_m, planner.ground));
  }
  Structure structure{{}, {}, site.held};
  const auto attempt = [&](auto add) {
    structure.things.clear(), structure.wires.clear();
    return add(site, structure);
  };
  if (site.is_tram
          ? attempt(add_poles)
          : (station.group.size() < 3 && attempt(add_cantilevers)) || attempt(add_portal) || attempt(add_cantilevers))
    return structure;
  return std::nullopt;
}

// ---- supports -------------------------------------------------------------------------------------------------------

// The place of the contact wire beside the axis: outside of a curve, else to both sides in turn.
double stagger_m(const ContactTrack& track, double along_m, std::uint32_t number) {
  constexpr double kChord_m = 20, kStraight_m = 0.1;
  const Vec2 a = place_at(track, along_m - kChord_m).at, b = place_at(track, along_m + kChord_m).at;
  const double bulge_m = cross(unit(b - a), place_at(track, along_m).at - a);
  if (std::abs(bulge_m) > kStraight_m) return bulge_m > 0 ? kCurveStagger_m : -kCurveStagger_m;
  return number % 2 == 0 ? kStagger_m : -kStagger_m;
}

ContactSupport support_of(const ContactTrack& track, std::uint32_t number, const SectionTrack& s,
                          const ground::GradedTerrain& ground) {
  const AxisPlace place = place_at(track, s.along_m);
  const Vec2 at = place.at + left_of(place.along) * stagger_m(track, s.along_m, number);
  return {.track = s.track,
          .along_m = s.along_m,
          .contact = at_height(at, track_height_m(track, s.along_m, ground) + wire_height_m(track)),
          .messenger_m = track.is_tram ? 0 : kSystemHeight_m};
}

// The parts of ids number masts by their place, so that they do not depend on masts far away.
ObjectId mast_id(const TrackIndex& index, const Station& station, std::size_t number) {
  const auto metre = static_cast<std::uint32_t>(station.along_m);
  return derived_id({index.tracks[station.track].id.osm, 0}, metre * 16 + static_cast<std::uint32_t>(number % 16));
}

void add_structure(const TrackIndex& index, const Station& station, Structure structure, MastPlanner& planner,
                   ContactLines& lines) {
  std::size_t number = 0;
  for (Thing& thing : structure.things) {
    thing.id = mast_id(index, station, number++);
    lines.masts.push_back(std::move(thing));
  }
  for (CrossWire& wire : structure.wires) {
    wire.id = mast_id(index, station, number++);
    lines.cross_wires.push_back(wire);
  }
  for (const SectionTrack& s : structure.held)
    lines.supports.push_back(support_of(index.tracks[s.track], station.number, s, planner.ground));
}

// ---- bridges above the track ----------------------------------------------------------------------------------------

// The underside of a bridge above a place of a track.
struct Underside {
  double along_m, half_m, height_m;
};

std::vector<Underside> undersides_over(const MastPlanner& planner, const ContactTrack& track) {
  std::vector<Underside> found;
  for (std::size_t v = 0; v + 1 < track.axis.size(); ++v) {
    const Vec2 a = track.axis[v], b = track.axis[v + 1];
    for (const std::uint32_t i : boxes_about(planner.deck_grid, box_of_segment(a, b))) {
      const Deck& deck = planner.decks[i];
      const auto shares = crossing_shares(a, b, deck.a, deck.b);
      if (!shares || deck.bridge->id.osm == track.id.osm) continue;
      const double along_m = track.along_m[v] + (track.along_m[v + 1] - track.along_m[v]) * shares->first;
      const double deck_m = deck.from_m + distance(deck.a, deck.b) * shares->second;
      const double top_m = deck.bridge->profile.empty() ? land_m(planner.ground, a + (b - a) * shares->first)
                                                        : knot_at(deck.bridge->profile, deck_m).z_m;
      const double thick_m =
          structures::deck_dimensions(*deck.bridge, structures::longest_bay_m(*deck.bridge)).thickness_m;
      if (top_m < track_height_m(track, along_m, planner.ground) + kOverTrack_m) continue;
      const double across = std::max(0.3, std::abs(cross(unit(b - a), unit(deck.b - deck.a))));
      found.push_back({along_m, (max_offset_m(*deck.bridge) + 1) / across, top_m - thick_m});
    }
  }
  return found;
}

// Wires hang lower on both sides of a bridge above them; where it is too low, nothing holds them.
void add_supports_below(const MastPlanner& planner, std::uint32_t t, ContactLines& lines) {
  const ContactTrack& track = lines.index.tracks[t];
  for (const Underside& under : undersides_over(planner, track)) {
    std::erase_if(lines.supports, [&](const ContactSupport& s) {
      return s.track == t && std::abs(s.along_m - under.along_m) < under.half_m + 1;
    });
    for (const double side : {-1.0, 1.0}) {
      const double along_m = under.along_m + side * under.half_m;
      if (along_m < 0 || along_m > track.along_m.back()) continue;
      ContactSupport support = support_of(track, 0, {0, t, along_m}, planner.ground);
      const double rail_m = support.contact.z - wire_height_m(track);
      const double room_m = under.height_m - kBelowDeck_m - support.contact.z;
      if (support.messenger_m > 0) {
        support.messenger_m = std::clamp(room_m, kLeastSystem_m, support.messenger_m);
        support.contact.z = std::min(support.contact.z, under.height_m - kBelowDeck_m - support.messenger_m);
      } else {
        support.contact.z = std::min(support.contact.z, under.height_m - kBelowDeck_m);
      }
      if (support.contact.z >= rail_m + kLeastWire_m) lines.supports.push_back(support);
    }
  }
}

// ---- mapped masts ---------------------------------------------------------------------------------------------------

// A mapped mast gets an arm that reaches the nearest track, and holds the wires of the tracks within kMappedReach_m.
void add_mapped(const map::ThingFeature& mapped, MastPlanner& planner, ContactLines& lines) {
  std::optional<SectionTrack> nearest;
  double nearest_m = kMappedReach_m;
  const TrackIndex& index = lines.index;
  for (const std::uint32_t i : boxes_about(index.grid, Box2{mapped.at, mapped.at}.widened(kMappedReach_m))) {
    const auto [t, v] = index.segments[i];
    const ContactTrack& track = index.tracks[t];
    const double share = nearest_share(track.axis[v], track.axis[v + 1], mapped.at);
    const double off_m = distance(track.axis[v] + (track.axis[v + 1] - track.axis[v]) * share, mapped.at);
    if (!track.has_contact_line || off_m >= nearest_m) continue;
    nearest_m = off_m;
    nearest = {0, t, track.along_m[v] + (track.along_m[v + 1] - track.along_m[v]) * share};
  }
  if (!nearest || nearest_m < 1 || !planner.features.extent.contains(mapped.at)) return;
  const ContactTrack& track = index.tracks[nearest->track];
  const AxisPlace place = place_at(track, nearest->along_m);
  const double top_m =
      track_height_m(track, nearest->along_m, planner.ground) +
      (track.is_tram ? kTramWire_m + kPoleAboveWire_m : kRailWire_m + kSystemHeight_m + kMastAboveMessenger_m);
  const double wide_m = track.is_tram ? kPoleSide_m : kMastSide_m;
  Thing mast = thing_with_top(planner, track.is_tram ? ThingRole::kContactPole : ThingRole::kContactMast, mapped.at,
                              place.at - mapped.at, {wide_m, wide_m}, top_m);
  mast.form.capacity = static_cast<std::uint16_t>(nearest_m / kReachStep_m + 0.5);
  mast.id = mapped.id, mast.is_in_way = true;
  lines.masts.push_back(std::move(mast));
  lines.replaced.insert(mapped.id.osm);
  for (const SectionTrack& s : section_at(index, nearest->track, nearest->along_m))
    if (index.tracks[s.track].has_contact_line &&
        distance(place_at(index.tracks[s.track], s.along_m).at, mapped.at) <= kMappedReach_m)
      lines.supports.push_back(support_of(index.tracks[s.track], 0, s, planner.ground));
}

// Supports of one track that are nearly at one place, of masts on both of its sides, are one.
void remove_double_supports(std::vector<ContactSupport>& supports) {
  constexpr double kOnePlace_m = 8;
  std::ranges::sort(supports, {}, [](const ContactSupport& s) { return std::tuple(s.track, s.along_m, s.contact); });
  std::vector<ContactSupport> once;
  for (const ContactSupport& s : supports) {
    const bool is_double =
        !once.empty() && once.back().track == s.track && s.along_m - once.back().along_m < kOnePlace_m;
    if (!is_double || s.messenger_m < once.back().messenger_m) once.push_back(s);
  }
  supports = std::move(once);
}

}  // namespace

ContactLines plan_contact_lines(const map::FeatureView& features, const ContactSurroundings& around, Report& report) {
  ContactLines lines;
  lines.index = index_tracks(features, around.roads, around.bridges);
  const TrackIndex& index = lines.index;
  if (std::ranges::none_of(index.tracks, &ContactTrack::has_contact_line)) return lines;
  MastPlanner planner{features, around.ground, FreePlaces(around.cover)};
  index_decks(around.bridges, planner), index_mapped(planner);
  Account account;
  std::set<OsmId> ways;
  for (const map::ThingFeature* mapped : planner.mapped) add_mapped(*mapped, planner, lines);
  for (const Station& station : all_stations(index, planner)) {
    const OsmId way = index.tracks[station.track].id.osm;
    if (!features.extent.contains(station.place.at)) continue;
    std::optional<Structure> structure = structure_at(planner, index, station);
    account.in += report.counts(way);
    if (!structure) {
      report.drop(account,
                  {Code::kNoPlaceForThing, way, 0, {}, {}, std::string(map::name_of(ThingRole::kContactMast))});
      continue;
    }
    account.out += report.counts(way);
    if (ways.insert(way).second) report.count_assumed(Assumption::kMasts, way);
    add_structure(index, station, std::move(*structure), planner, lines);
  }
  for (std::uint32_t t = 0; t < index.tracks.size(); ++t)
    if (index.tracks[t].has_contact_line && !index.tracks[t].is_on_bridge) add_supports_below(planner, t, lines);
  remove_double_supports(lines.supports);
  std::ranges::sort(lines.masts, {}, [](const Thing& mast) { return std::tie(mast.id, mast.at); });
  report.account("things", "contact mast") = account;
  return lines;
}

}  // namespace citykiln::things
