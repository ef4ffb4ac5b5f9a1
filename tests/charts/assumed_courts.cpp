// The courts of blocks, as mapped and as built.
#include <algorithm>
#include <array>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/lots/courts.h"
#include "tests/charts/assumed_values.h"

namespace citykiln::charts {
namespace {

constexpr double kFromStreet_m = 12, kToCourtWall_m = 30, kCourtChartBucket_m = 32;
constexpr int kFewestWalls = 5;

struct CourtSegment {
  Vec2 a, b;
};

struct CourtSegments {
  std::vector<CourtSegment> all;
  BoxGrid grid;
};

CourtSegments index_court_segments(std::vector<CourtSegment> all) {
  CourtSegments index{std::move(all), {}};
  std::vector<Box2> boxes;
  for (const CourtSegment& s : index.all) boxes.push_back(box_of_segment(s.a, s.b));
  if (!boxes.empty()) index.grid = grid_of(boxes, kCourtChartBucket_m);
  return index;
}

CourtSegments street_segments_of(const map::Features& features) {
  std::vector<CourtSegment> all;
  for (const map::Track& track : features.tracks)
    for (std::size_t i = 0; map::is_street(track.surface) && i + 1 < track.axis.size(); ++i)
      if (track.surface != map::LandCoverClass::kServiceRoad) all.push_back({track.axis[i], track.axis[i + 1]});
  return index_court_segments(std::move(all));
}

CourtSegments wall_segments_of(const map::Features& features) {
  std::vector<CourtSegment> all;
  for (const map::Footprint& footprint : features.footprints) {
    const Ring& ring = footprint.polygon.outer;
    for (std::size_t i = 0; !footprint.is_part && i < ring.size(); ++i)
      all.push_back({ring[i], ring[(i + 1) % ring.size()]});
  }
  return index_court_segments(std::move(all));
}

bool is_in_court(const CourtSegments& streets, const CourtSegments& walls, Vec2 p) {
  if (walls.all.empty() || streets.all.empty()) return false;
  for (const std::uint32_t i : boxes_about(streets.grid, Box2{p, p}.widened(kFromStreet_m)))
    if (distance_to_segment(streets.all[i].a, streets.all[i].b, p) < kFromStreet_m) return false;
  constexpr std::array<Vec2, 8> kWays = {
      {{1, 0}, {0.7, 0.7}, {0, 1}, {-0.7, 0.7}, {-1, 0}, {-0.7, -0.7}, {0, -1}, {0.7, -0.7}}};
  int hits = 0;
  for (const Vec2 way : kWays) {
    const Vec2 end = p + way * kToCourtWall_m;
    hits += std::ranges::any_of(boxes_about(walls.grid, box_of_segment(p, end)), [&](std::uint32_t i) {
      return crossing_shares(p, end, walls.all[i].a, walls.all[i].b).has_value();
    });
  }
  return hits >= kFewestWalls;
}

bool is_court_sized(const map::AreaFeature& area) {
  return area.area_m2 >= lots::kLeastCourt_m2 && area.area_m2 <= lots::kLargestCourt_m2 && !area.polygon.outer.empty();
}

}  // namespace

std::vector<Sample> tagged_courts(const Place& place) {
  const CourtSegments streets = street_segments_of(place.mapped), walls = wall_segments_of(place.mapped);
  std::vector<Sample> samples;
  for (const map::AreaFeature& area : place.mapped.areas) {
    const std::optional<bool> is_green = lots::is_green_court(area.surface);
    if (!is_green || !is_court_sized(area)) continue;
    const Vec2 middle = box_of(area.polygon.outer).centre();
    if (is_in_court(streets, walls, middle))
      samples.push_back({.key = {area.id.osm, 0}, .at = middle, .tagged = *is_green ? 1.0 : 0.0});
  }
  return samples;
}

Values built_courts(const map::Features& features) {
  constexpr double kDrawn = 0.55;
  const lots::CourtGreen green = lots::index_court_green(features);
  Values built;
  for (const map::AreaFeature& area : features.areas) {
    if (area.surface != map::LandCoverClass::kUnknown || !is_court_sized(area)) continue;
    const lots::LotKind kind = lots::court_of(green, box_of(area.polygon.outer).centre());
    built[{area.id.osm, 0}] = kind == lots::LotKind::kGreenCourt ? 1 : kind == lots::LotKind::kPavedCourt ? 0 : kDrawn;
  }
  return built;
}

void hide_courts(map::Features& features, const IsOut& is_out) {
  for (map::AreaFeature& area : features.areas)
    if (lots::is_green_court(area.surface) && is_out(area.id.osm)) area.surface = map::LandCoverClass::kUnknown;
}

}  // namespace citykiln::charts
