#include "compiler/map/rails_in_streets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln::map {
namespace {

// Tracks are sampled at this distance. Shorter gaps between streets, such as junctions, count as street.
constexpr double kSample_m = 2, kLongestGap_m = 16;
// Parts of ids count distances in these steps; no piece is shorter.
constexpr double kPartStep_m = 4, kLongestWay_m = 60'000;
constexpr double kBucket_m = 64;

bool is_railway_on_ground(const Track& track) {
  return track.passage == Passage::kGround && track.is_rail && track.id.part == 0 &&
         values_of(track.surface).group == LandCoverGroup::kRail && length_m(track.axis) <= kLongestWay_m;
}

// Streets by place.
struct Streets {
  std::vector<const Track*> tracks;
  BoxGrid grid;
};

Streets streets_of(const std::vector<Track>& tracks) {
  Streets streets;
  std::vector<Box2> boxes;
  for (const Track& track : tracks) {
    if (track.passage != Passage::kGround || values_of(track.surface).group != LandCoverGroup::kRoad) continue;
    streets.tracks.push_back(&track);
    boxes.push_back(box_of(track.axis).widened(carriageway_width_m(track.section)));
  }
  streets.grid = grid_of(boxes, kBucket_m);
  return streets;
}

// True for a place between the kerbs of a street that runs in nearly this direction.
bool lies_along(const Track& street, Vec2 at, Vec2 along) {
  constexpr double kLeastCosine = 0.9;
  for (std::size_t i = 0; i + 1 < street.axis.size(); ++i) {
    const Vec2 a = street.axis[i], b = street.axis[i + 1], direction = unit(b - a);
    if (std::abs(dot(direction, along)) < kLeastCosine) continue;
    const Vec2 offset = at - nearest_point(a, b, at);
    const double left_m = cross(direction, offset);
    if (std::abs(dot(direction, offset)) < kQuantum_m && left_m <= left_kerb_m(street.section) &&
        -left_m <= right_kerb_m(street.section))
      return true;
  }
  return false;
}

bool is_in_street(const Streets& streets, const Track& rails, Vec2 at, Vec2 along) {
  return std::ranges::any_of(boxes_about(streets.grid, at), [&](std::uint32_t i) {
    const Track& street = *streets.tracks[i];
    return values_of(street.surface).priority > values_of(rails.surface).priority && lies_along(street, at, along);
  });
}

// A part of a track between two distances from its beginning.
struct Stretch {
  double from_m = 0, to_m = 0;
};

// The stretches in streets, with the gaps between them.
std::vector<Stretch> stretches_in_streets(const Streets& streets, const Track& rails) {
  std::vector<Stretch> stretches;
  double begin_m = 0;
  for (std::size_t i = 0; i + 1 < rails.axis.size(); ++i) {
    const Vec2 a = rails.axis[i], b = rails.axis[i + 1];
    const double long_m = distance(a, b);
    const int steps = std::max(1, static_cast<int>(std::ceil(long_m / kSample_m)));
    for (int k = 0; k < steps; ++k) {
      if (!is_in_street(streets, rails, a + (b - a) * ((k + 0.5) / steps), unit(b - a))) continue;
      const double from_m = begin_m + long_m * k / steps, to_m = begin_m + long_m * (k + 1) / steps;
      if (stretches.empty() || from_m - stretches.back().to_m > kLongestGap_m) stretches.push_back({from_m, from_m});
      stretches.back().to_m = to_m;
    }
    begin_m += long_m;
  }
  std::erase_if(stretches, [](const Stretch& s) { return s.to_m - s.from_m < kLeastInStreet_m; });
  return stretches;
}

std::vector<double> distances_of_vertices(const Polyline& axis) {
  std::vector<double> along_m{0};
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) along_m.push_back(along_m.back() + distance(axis[i], axis[i + 1]));
  return along_m;
}

// Moves a cut to a vertex of the axis that is near, so that no piece is short.
double at_vertex_if_near(const std::vector<double>& vertices_m, double at_m) {
  const double nearest_m = *std::ranges::min_element(vertices_m, {}, [&](double v) { return std::abs(v - at_m); });
  if (std::abs(vertices_m.front() - at_m) < 2 * kPartStep_m) return vertices_m.front();
  if (std::abs(vertices_m.back() - at_m) < 2 * kPartStep_m) return vertices_m.back();
  return std::abs(nearest_m - at_m) < kPartStep_m ? nearest_m : at_m;
}

// The node ids of places where ways are cut: far below those of maps, and apart from those of axes of bridge areas.
std::int64_t cut_node_id(const Track& way, double at_m) {
  constexpr std::int64_t kHighest = std::numeric_limits<std::int64_t>::min() / 2, kPerWay = 1 << 16;
  return kHighest - way.id.osm.id * kPerWay - static_cast<std::int64_t>(at_m);
}

// The part of a way between two distances.
Track rails_between(const Track& way, const std::vector<double>& vertices_m, const Stretch& stretch) {
  Track piece = way;
  piece.id.part = static_cast<std::uint32_t>(stretch.from_m / kPartStep_m);
  piece.is_piece = true;
  piece.axis.clear(), piece.node_ids.clear(), piece.points.clear();
  const auto add_cut = [&](double at_m) {
    const std::size_t i = static_cast<std::size_t>(std::ranges::upper_bound(vertices_m, at_m) - vertices_m.begin());
    const double share = (at_m - vertices_m[i - 1]) / (vertices_m[i] - vertices_m[i - 1]);
    piece.axis.push_back(snapped(way.axis[i - 1] + (way.axis[i] - way.axis[i - 1]) * share));
    piece.node_ids.push_back(cut_node_id(way, at_m));
  };
  const auto is_vertex = [&](double at_m) { return std::ranges::binary_search(vertices_m, at_m); };
  if (!is_vertex(stretch.from_m)) add_cut(stretch.from_m);
  for (std::size_t v = 0; v < way.axis.size(); ++v) {
    if (vertices_m[v] < stretch.from_m || vertices_m[v] > stretch.to_m) continue;
    for (TrackPoint point : way.points)
      if (point.vertex == v)
        point.vertex = static_cast<std::uint32_t>(piece.axis.size()), piece.points.push_back(point);
    piece.axis.push_back(way.axis[v]), piece.node_ids.push_back(way.node_ids[v]);
  }
  if (!is_vertex(stretch.to_m)) add_cut(stretch.to_m);
  return piece;
}

// A way as pieces in streets and between them.
std::vector<Track> cut_at(const Track& way, const std::vector<Stretch>& in_streets) {
  const std::vector<double> vertices_m = distances_of_vertices(way.axis);
  std::vector<Track> pieces;
  double done_m = 0;
  for (const Stretch& found : in_streets) {
    const Stretch street{at_vertex_if_near(vertices_m, found.from_m), at_vertex_if_near(vertices_m, found.to_m)};
    if (street.from_m > done_m) pieces.push_back(rails_between(way, vertices_m, {done_m, street.from_m}));
    pieces.push_back(as_street_rails(rails_between(way, vertices_m, street)));
    done_m = street.to_m;
  }
  if (done_m < vertices_m.back()) pieces.push_back(rails_between(way, vertices_m, {done_m, vertices_m.back()}));
  return pieces;
}

}  // namespace

Track as_street_rails(Track rails) {
  constexpr double kRails_m = 2.5;
  rails.surface = LandCoverClass::kStreetRails;
  const double width_m = snapped_to(1.0 / 1024, std::min(kRails_m, carriageway_width_m(rails.section)));
  rails.section = {.lanes = {{.kind = LaneKind::kRail, .width_m = width_m}},
                   .axis_offset_m = snapped_to(1.0 / 2048, width_m / 2)};
  std::erase_if(rails.points, [](const TrackPoint& point) { return point.kind == TrackPointKind::kLevelCrossing; });
  return rails;
}

std::vector<Track> with_rails_in_streets(std::vector<Track> tracks) {
  const Streets streets = streets_of(tracks);
  std::vector<Track> all;
  for (const Track& track : tracks) {
    const std::vector<Stretch> in_streets =
        is_railway_on_ground(track) ? stretches_in_streets(streets, track) : std::vector<Stretch>{};
    if (in_streets.empty())
      all.push_back(track);
    else
      std::ranges::move(cut_at(track, in_streets), std::back_inserter(all));
  }
  return all;
}

}  // namespace citykiln::map
