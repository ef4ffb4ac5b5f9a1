#include "compiler/map/bridge_areas.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <tuple>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/erase_repeated.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/land_cover/area_rules.h"
#include "compiler/map/readers/feature_readers.h"
#include "compiler/map/tags/standing.h"
#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

// ---- areas ----------------------------------------------------------------------------------------------------------

bool is_bridge_outline(const ReadContext& context, source::Range tags) {
  return context.tag(tags, "man_made") == "bridge";
}

// A wood or a lake cannot lie on a plate; grass, gardens and pitches can.
bool may_be_deck(LandCoverClass surface) {
  const LandCoverGroup group = values_of(surface).group;
  return surface != LandCoverClass::kUnknown && group != LandCoverGroup::kWater && group != LandCoverGroup::kForest;
}

// The class of the top of an area that is a bridge, by its tags; kUnknown for an outline. Nothing for other areas.
std::optional<LandCoverClass> deck_class_of(const ReadContext& context, const source::Area& area) {
  const AreaRule* row = area_rule_of([&](std::string_view key) { return context.tag(area.tags, key); });
  if (row == nullptr || is_closed_line(context, area.tags, area.from.type)) return std::nullopt;
  if (presence_of(context.osm, area.tags, row->key) == Presence::kGone) return std::nullopt;
  if (says_yes(context.tag(area.tags, "bridge")) && may_be_deck(row->surface)) return row->surface;
  return is_bridge_outline(context, area.tags) ? std::optional(LandCoverClass::kUnknown) : std::nullopt;
}

// ---- which bridges lie on an area -----------------------------------------------------------------------------------

constexpr double kCarriedStep_m = 1;

bool lies_on(const BridgeArea& area, const Track& track) {
  constexpr double kLeastShare = 1.0 / 3, kOfExtent = 0.5;
  if (track.passage != Passage::kBridge) return false;
  const double share = share_inside(track.axis, area.polygon);
  const Box2 box = box_of(area.polygon.outer);
  return share >= kLeastShare || share * length_m(track.axis) >= kOfExtent * std::max(box.width(), box.height());
}

bool has_same_layer(const BridgeArea& area, const Track& track) {
  return track.layer == 0 || area.layer == 0 || track.layer == area.layer;
}

// The bridges on an area that no area before it carries: those of its layer, or all if there are none.
std::vector<const Track*> carried_by(const BridgeArea& area, std::span<const Track* const> near,
                                     std::span<const ObjectId> taken) {
  std::vector<const Track*> here, of_layer;
  for (const Track* track : near)
    if (lies_on(area, *track) && std::ranges::find(taken, track->id) == taken.end()) here.push_back(track);
  std::ranges::copy_if(here, std::back_inserter(of_layer),
                       [&](const Track* track) { return has_same_layer(area, *track); });
  return of_layer.empty() ? here : of_layer;
}

// ---- places where ways meet the outline -----------------------------------------------------------------------------

struct JoinPlace {
  Vec2 at;
  std::int64_t node_id = 0;
  LandCoverClass surface{};
};

bool is_corner(const BridgeArea& area, Vec2 p) {
  const auto has = [&](const Ring& ring) { return std::ranges::find(ring, p) != ring.end(); };
  return has(area.polygon.outer) || std::ranges::any_of(area.polygon.holes, has);
}

// The nodes of a way on the outline: both ends, and one between if it is the only one. A way with more runs along it.
void add_places(const BridgeArea& area, const Track& track, std::vector<JoinPlace>& places) {
  std::vector<std::size_t> on;
  for (std::size_t v = 0; v < track.axis.size(); ++v)
    if (is_corner(area, track.axis[v])) on.push_back(v);
  for (const std::size_t v : on)
    if (on.size() == 1 || v == 0 || v + 1 == track.axis.size())
      places.push_back({track.axis[v], track.node_ids[v], track.surface});
}

std::vector<JoinPlace> join_places_of(const BridgeArea& area, std::span<const Track* const> near) {
  std::vector<JoinPlace> places;
  for (const Track* track : near)
    if (track->passage != Passage::kTunnel) add_places(area, *track, places);
  // the class of the widest way first
  std::ranges::sort(places, {}, [](const JoinPlace& p) {
    return std::tuple(p.at.x, p.at.y, -values_of(p.surface).priority, p.node_id);
  });
  erase_repeated(places, [](const JoinPlace& p) { return std::pair(p.at.x, p.at.y); });
  return places;
}

// ---- axes -----------------------------------------------------------------------------------------------------------

// Node ids of the vertices of axes: far below those of maps and of unsaved edits.
std::int64_t axis_node_id(const BridgeArea& area, std::size_t number) {
  constexpr std::int64_t kLowest = std::numeric_limits<std::int64_t>::min(), kPerArea = 1024;
  return kLowest + (area.id.osm.id * 8 + area.id.part % 8) * kPerArea + static_cast<std::int64_t>(number);
}

double width_across_m(double width_m) { return snapped_to(1.0 / 512, std::clamp(width_m, 2.0, 60.0)); }

LandCoverClass axis_class(std::span<const JoinPlace> places) {
  LandCoverClass best = LandCoverClass::kPavedFootPath;
  for (const JoinPlace& place : places)
    if (values_of(place.surface).group == LandCoverGroup::kRoad &&
        values_of(place.surface).priority > values_of(best).priority)
      best = place.surface;
  return best;
}

// A bridge on the area with the place's ends. Its one lane is as wide as the area.
Track axis_track(const BridgeArea& area, std::uint32_t number, LandCoverClass surface, double width_m,
                 std::span<const JoinPlace> along) {
  Track track;
  track.id = derived_id({area.id.osm, area.id.part % 8}, 1024, number);
  for (const JoinPlace& place : along) track.axis.push_back(place.at), track.node_ids.push_back(place.node_id);
  track.surface = surface;
  track.layer = area.layer;
  track.passage = Passage::kBridge;
  track.has_tagged_width = track.has_tagged_surface = track.has_tagged_lighting = true;
  track.tagged_pavements = track.tagged_verges = track.tagged_parking = kBothSides;
  const bool is_path = values_of(surface).group == LandCoverGroup::kPath;
  track.section.lanes = {{.kind = is_path ? LaneKind::kFoot : LaneKind::kDriving, .width_m = width_m}};
  track.section.axis_offset_m = width_m / 2;
  return track;
}

// The two places that are farthest from each other.
std::pair<std::size_t, std::size_t> farthest_pair(std::span<const Vec2> places) {
  std::pair<std::size_t, std::size_t> best{0, 0};
  double best_m = -1;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = i + 1; j < places.size(); ++j)
      if (const double apart_m = distance(places[i], places[j]); apart_m > best_m) best = {i, j}, best_m = apart_m;
  return best;
}

// Shorter axes are left out.
constexpr double kNearEnd_m = 2;

// Adds corners of the outline until there are two places that are apart: the corner farthest from the only place, or
// the two corners farthest from each other.
std::vector<JoinPlace> at_least_two(const BridgeArea& area, std::vector<JoinPlace> places) {
  const Ring& ring = area.polygon.outer;
  std::vector<Vec2> at;
  for (const JoinPlace& place : places) at.push_back(place.at);
  if (const auto [i, j] = farthest_pair(at); places.size() >= 2 && distance(at[i], at[j]) >= kNearEnd_m) return places;
  if (places.empty()) {
    const auto [i, j] = farthest_pair(ring);
    return {{ring[i], axis_node_id(area, 0)}, {ring[j], axis_node_id(area, 1)}};
  }
  const Vec2 from = places.front().at;
  places.push_back(
      {*std::ranges::max_element(ring, {}, [&](Vec2 p) { return distance(from, p); }), axis_node_id(area, 0)});
  return places;
}

// The axes of an area that carries no bridge of the map.
std::vector<Track> own_axes(const BridgeArea& area, const std::vector<JoinPlace>& joins) {
  const std::vector<JoinPlace> places = at_least_two(area, joins);
  std::vector<Vec2> at;
  for (const JoinPlace& place : places) at.push_back(place.at);
  const auto [first, last] = farthest_pair(at);
  const Vec2 from = at[first], to = at[last];
  const double long_m = distance(from, to);
  if (long_m < kNearEnd_m) return {};
  const double width_m = width_across_m(area_m2(area.polygon) / long_m);
  const LandCoverClass surface = axis_class(places);
  std::vector<std::pair<double, JoinPlace>> spine = {{0, places[first]}, {1, places[last]}};
  std::vector<Track> axes;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i == first || i == last) continue;
    const double share = nearest_share(from, to, at[i]);
    JoinPlace foot{snapped(from + (to - from) * share), axis_node_id(area, 2 + i), {}};
    if (share * long_m < kNearEnd_m)
      foot = places[first];
    else if ((1 - share) * long_m < kNearEnd_m)
      foot = places[last];
    else if (distance(foot.at, at[i]) < kNearEnd_m)
      foot = places[i];
    if (foot.at != from && foot.at != to) spine.emplace_back(share, foot);
    if (foot.at != at[i])
      axes.push_back(axis_track(area, static_cast<std::uint32_t>(1 + i), surface, width_across_m(0),
                                std::vector{places[i], foot}));
  }
  std::ranges::sort(spine, {}, [](const auto& p) { return std::tuple(p.first, p.second.node_id); });
  std::vector<JoinPlace> along;
  for (const auto& [share, place] : spine)
    if (along.empty() || along.back().at != place.at) along.push_back(place);
  axes.push_back(axis_track(area, 0, surface, width_m, along));
  return axes;
}

// Axes from places where other ways meet the outline to the nearest node of a bridge on the area.
std::vector<Track> branches(const BridgeArea& area, std::span<const Track* const> carried,
                            const std::vector<JoinPlace>& joins) {
  std::vector<Track> axes;
  for (std::uint32_t i = 0; i < joins.size(); ++i) {
    std::optional<JoinPlace> nearest;
    for (const Track* track : carried)
      for (std::size_t v = 0; v < track->axis.size(); ++v)
        if (!nearest || distance(track->axis[v], joins[i].at) < distance(nearest->at, joins[i].at))
          nearest = JoinPlace{track->axis[v], track->node_ids[v], {}};
    if (!nearest || nearest->at == joins[i].at) continue;
    axes.push_back(
        axis_track(area, 1 + i, LandCoverClass::kPavedFootPath, width_across_m(0), std::vector{joins[i], *nearest}));
  }
  return axes;
}

// True if a way on the ground runs through most of an outline: its bridge is not tagged.
bool is_crossed_on_ground(const BridgeArea& area, std::span<const Track* const> near) {
  constexpr double kThrough = 0.6;
  return std::ranges::any_of(near, [&](const Track* track) {
    return track->passage == Passage::kGround && track->layer >= area.layer &&
           share_inside(track->axis, area.polygon) >= kThrough;
  });
}

// ---- areas within outlines ------------------------------------------------------------------------------------------

bool lies_in(const BridgeArea& inner, const BridgeArea& outer) {
  const Ring& ring = inner.polygon.outer;
  const auto inside = std::ranges::count_if(
      ring, [&](Vec2 p) { return contains(outer.polygon, p) || distance_to_ring(outer.polygon.outer, p) < 1; });
  return 2 * inside > static_cast<std::ptrdiff_t>(ring.size());
}

// Gives outlines the class of the largest surface on them, and removes these surfaces.
std::vector<BridgeArea> merged_outlines(std::vector<BridgeArea> areas) {
  std::vector<bool> is_merged(areas.size());
  for (BridgeArea& outline : areas) {
    double best_m2 = 0;
    for (std::size_t i = 0; outline.is_outline && i < areas.size(); ++i) {
      if (areas[i].is_outline || is_merged[i] || !lies_in(areas[i], outline)) continue;
      is_merged[i] = true;
      const double size_m2 = area_m2(areas[i].polygon);
      if (size_m2 > best_m2) best_m2 = size_m2, outline.surface = areas[i].surface;
      if (outline.layer == 0) outline.layer = areas[i].layer;
    }
  }
  std::vector<BridgeArea> kept;
  for (std::size_t i = 0; i < areas.size(); ++i)
    if (!is_merged[i]) kept.push_back(std::move(areas[i]));
  return kept;
}

}  // namespace

bool is_bridge_area(const ReadContext& context, const source::Area& area) {
  return deck_class_of(context, area).value_or(LandCoverClass::kUnknown) != LandCoverClass::kUnknown;
}

double share_inside(const Polyline& axis, const Polygon& polygon) {
  int all = 0, inside = 0;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const int steps = std::max(1, static_cast<int>(std::ceil(distance(axis[i], axis[i + 1]) / kCarriedStep_m)));
    for (int k = 0; k < steps; ++k) {
      ++all;
      inside += contains(polygon, axis[i] + (axis[i + 1] - axis[i]) * ((k + 0.5) / steps));
    }
  }
  return all > 0 ? static_cast<double>(inside) / all : 0;
}

std::vector<BridgeArea> locate_bridge_areas(const ReadContext& context) {
  std::vector<BridgeArea> areas;
  Account account;
  for (const source::Area& area : context.osm.areas) {
    const std::optional<LandCoverClass> surface = deck_class_of(context, area);
    if (!surface) continue;
    account.in += context.report.counts(area.from);
    for_each_near_polygon(context, area.from, located(context, area), account, [&](const LocatedPolygon& polygon) {
      areas.push_back({.id = {area.from, polygon.part},
                       .polygon = polygon.polygon,
                       .surface = *surface,
                       .layer = tagged_layer(context, area.from, area.tags),
                       .is_outline = *surface == LandCoverClass::kUnknown});
    });
  }
  context.report.account("map", "bridge area") = account;
  return areas;
}

CarriedTracks with_bridge_areas(std::vector<Track> tracks, std::vector<BridgeArea> areas, Report& report) {
  constexpr double kBucket_m = 64;
  if (areas.empty()) return {std::move(tracks), {}};
  std::ranges::sort(areas, {}, &BridgeArea::id);
  std::vector<Box2> boxes;
  for (const Track& track : tracks) boxes.push_back(box_of(track.axis));
  const BoxGrid grid = grid_of(boxes, kBucket_m);
  std::vector<BridgeArea> with_tracks;
  std::vector<Track> axes;
  std::vector<ObjectId> taken;
  for (BridgeArea& area : merged_outlines(std::move(areas))) {
    std::vector<const Track*> near;
    for (const std::uint32_t t : boxes_about(grid, box_of(area.polygon.outer))) near.push_back(&tracks[t]);
    const std::vector<const Track*> carried = carried_by(area, near, taken);
    if (carried.empty() && area.is_outline && is_crossed_on_ground(area, near)) {
      report.add(Code::kBridgeOutlineOnGround, area.id.osm);
      continue;
    }
    const std::vector<JoinPlace> joins = join_places_of(area, near);
    std::vector<Track> own = carried.empty() ? own_axes(area, joins) : branches(area, carried, joins);
    for (const Track* track : carried) area.tracks.push_back(track->id);
    for (const Track& track : own) area.tracks.push_back(track.id);
    if (area.tracks.empty()) {
      report.add(Code::kBridgeAreaWithoutDeck, area.id.osm);
      continue;
    }
    std::ranges::sort(area.tracks);
    taken.insert(taken.end(), area.tracks.begin(), area.tracks.end());
    axes.insert(axes.end(), own.begin(), own.end());
    with_tracks.push_back(std::move(area));
  }
  tracks.insert(tracks.end(), axes.begin(), axes.end());
  return {std::move(tracks), std::move(with_tracks)};
}

}  // namespace citykiln::map
