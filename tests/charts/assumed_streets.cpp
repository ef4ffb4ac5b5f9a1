// Pavements, light and widths of streets, as tagged and as built.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "tests/charts/assumed_values.h"

namespace citykiln::charts {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;
using map::Track;

enum StreetSide : std::uint8_t { kLeftSide, kRightSide };

/// How far from the kerb a path beside a street runs, how often the street is looked at, and the least cosine of the
/// angle between both.
constexpr double kBesideKerb_m = 10, kLookEvery_m = 10, kLeastParallel = 0.87;
constexpr double kPathBucket_m = 32;

bool is_street(const Track& track) {
  return map::is_street(track.surface) && track.passage == map::Passage::kGround && !track.is_indoor;
}

Sample sample_of(const Track& track, int side, double tagged) {
  return {.key = {track.id.osm, side},
          .at = box_of(track.axis).centre(),
          .kind = static_cast<int>(track.surface),
          .tagged = tagged};
}

/// Calls visit(track, tags) for each street of a place.
template <typename Visit>
void for_each_tagged_street(const Place& place, Visit visit) {
  for (const Track& track : place.mapped.tracks) {
    if (!is_street(track)) continue;
    const auto way = std::ranges::lower_bound(place.osm.ways, track.id.osm.id, {}, &source::Way::id);
    if (way != place.osm.ways.end() && way->id == track.id.osm.id) visit(track, way->tags);
  }
}

/// The meaning of a value of sidewalk:left=* and the like, and of sidewalk=no and the like.
std::optional<bool> pavement_said(std::string_view value) {
  if (value == "yes" || value == "separate" || value == "both") return true;
  if (value == "no" || value == "none") return false;
  return std::nullopt;
}

/// Whether tags state a pavement on a side of a way.
std::optional<bool> tagged_pavement(const source::OsmData& osm, source::Range tags, StreetSide side) {
  const char* own = side == kLeftSide ? "left" : "right";
  for (const std::string& key : {std::string("sidewalk:") + own, std::string("sidewalk:both")})
    if (const auto said = pavement_said(osm.value_of(tags, key))) return said;
  const std::string_view all = osm.value_of(tags, "sidewalk");
  if (all == "left" || all == "right") return all == own;
  return pavement_said(all);
}

/// The paths of a map as segments.
struct PathSegments {
  std::vector<std::pair<Vec2, Vec2>> segments;
  BoxGrid grid;
};

PathSegments path_segments(const map::Features& features) {
  PathSegments paths;
  std::vector<Box2> boxes;
  for (const Track& track : features.tracks) {
    if (map::values_of(track.surface).group != LandCoverGroup::kPath || track.surface == LandCoverClass::kFarmTrack ||
        track.is_indoor)
      continue;
    for (std::size_t i = 0; i + 1 < track.axis.size(); ++i) {
      paths.segments.emplace_back(track.axis[i], track.axis[i + 1]);
      boxes.push_back(box_of_segment(track.axis[i], track.axis[i + 1]));
    }
  }
  if (!boxes.empty()) paths.grid = grid_of(boxes, kPathBucket_m);
  return paths;
}

/// True if a path runs beside a street at a place of its axis.
/// @param out     The direction square to the street, towards the side.
/// @param kerb_m  The distance of the kerb from the axis.
bool has_path_beside(const PathSegments& paths, Vec2 at, Vec2 out, double kerb_m) {
  if (paths.segments.empty()) return false;
  const Box2 near = Box2{at, at}.widened(kerb_m + kBesideKerb_m);
  return std::ranges::any_of(boxes_about(paths.grid, near), [&](std::uint32_t i) {
    const auto& [a, b] = paths.segments[i];
    if (a == b || std::abs(cross(unit(b - a), out)) < kLeastParallel) return false;
    const Vec2 offset = nearest_point(a, b, at) - at;
    const double beside_m = dot(offset, out);
    return beside_m > kerb_m / 2 && beside_m < kerb_m + kBesideKerb_m &&
           std::abs(cross(offset, out)) < kLookEvery_m / 2;
  });
}

bool has_pavement_lane(const Track& track, StreetSide side) {
  std::vector<map::Lane> lanes = track.section.lanes;
  if (side == kRightSide) std::ranges::reverse(lanes);
  const auto kerb = std::ranges::find(lanes, false, &map::Lane::is_raised);
  return std::any_of(lanes.begin(), kerb, [](const map::Lane& lane) { return lane.kind == map::LaneKind::kSidewalk; });
}

double kerb_of_m(const Track& track, StreetSide side) {
  const double left_m = track.section.axis_offset_m;
  return side == kLeftSide ? left_m : map::carriageway_width_m(track.section) - left_m;
}

/// The length of a street with a pavement on a side.
double paved_length_m(const Track& track, StreetSide side, const PathSegments& paths) {
  const bool has_lane = has_pavement_lane(track, side);
  double paved_m = 0;
  for (std::size_t i = 0; i + 1 < track.axis.size(); ++i) {
    const Vec2 a = track.axis[i], b = track.axis[i + 1], left = left_of(unit(b - a));
    const int looks = std::max(1, static_cast<int>(distance(a, b) / kLookEvery_m));
    for (int k = 0; k < looks; ++k)
      if (has_lane || has_path_beside(paths, a + (b - a) * ((k + 0.5) / looks), side == kLeftSide ? left : left * -1.0,
                                      kerb_of_m(track, side)))
        paved_m += distance(a, b) / looks;
  }
  return paved_m;
}

double length_of_m(const Polyline& axis) {
  double length_m = 0;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) length_m += distance(axis[i], axis[i + 1]);
  return length_m;
}

}  // namespace

std::vector<Sample> tagged_pavements(const Place& place) {
  std::vector<Sample> samples;
  for_each_tagged_street(place, [&](const Track& track, source::Range tags) {
    for (const StreetSide side : {kLeftSide, kRightSide})
      if (const auto said = tagged_pavement(place.osm, tags, side))
        samples.push_back(sample_of(track, side, *said ? 1 : 0));
  });
  return samples;
}

Values built_pavements(const map::Features& features) {
  const PathSegments paths = path_segments(features);
  MeansByWay built;
  for (const Track& track : features.tracks) {
    if (!is_street(track)) continue;
    const double length_m = length_of_m(track.axis);
    for (const StreetSide side : {kLeftSide, kRightSide})
      built.add({track.id.osm, side}, paved_length_m(track, side, paths) / length_m, length_m);
  }
  return built.means();
}

std::vector<Sample> tagged_lit(const Place& place) {
  std::vector<Sample> samples;
  for_each_tagged_street(place, [&](const Track& track, source::Range tags) {
    const std::string_view lit = place.osm.value_of(tags, "lit");
    if (!lit.empty()) samples.push_back(sample_of(track, 0, lit == "no" || lit == "disused" ? 0 : 1));
  });
  return samples;
}

Values built_lit(const map::Features& features) {
  MeansByWay built;
  for (const Track& track : features.tracks)
    if (is_street(track)) built.add({track.id.osm, 0}, track.is_lit ? 1 : 0, length_of_m(track.axis));
  return built.means();
}

std::vector<Sample> tagged_widths(const Place& place) {
  std::vector<Sample> samples;
  for (const Track& track : place.mapped.tracks)
    if (is_street(track) && track.has_tagged_width)
      samples.push_back(sample_of(track, 0, map::carriageway_width_m(track.section)));
  return samples;
}

Values built_widths(const map::Features& features) {
  MeansByWay built;
  for (const Track& track : features.tracks)
    if (is_street(track))
      built.add({track.id.osm, 0}, map::carriageway_width_m(track.section), length_of_m(track.axis));
  return built.means();
}

}  // namespace citykiln::charts
