#include "compiler/people/spots.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "compiler/furniture/stations.h"
#include "compiler/geometry/line_part.h"
#include "compiler/geometry/snap.h"
#include "compiler/roads/pieces/stretches.h"
#include "compiler/roads/width_limits/narrowed_section.h"

namespace citykiln::people {
namespace {

using map::LandCoverClass;
using roads::Road;

// Spots keep this far from the kerb, where furniture stands, and from the walls.
constexpr double kFromKerb_m = 0.8, kFromWall_m = 0.5;
// Beside each other are spots this far apart.
constexpr double kBeside_m = 2.25;

bool is_for_walkers(LandCoverClass surface) {
  return surface == LandCoverClass::kPedestrianStreet || surface == LandCoverClass::kFootPath ||
         surface == LandCoverClass::kPavedFootPath;
}

// Draws that place a spot; they do not depend on the seed, so that spots are those of the map.
RandomSequence place_draws(StableId key) { return {0, key, "spot"}; }

int spots_beside(double width_m) { return std::clamp(static_cast<int>(width_m / kBeside_m), 1, 6); }

// The middles of spots across a strip, as distances from its beginning.
double across_m(const RandomSequence& draw, double width_m, int number, int count) {
  return width_m * (number + draw.between(0.25, 0.75, 0)) / count;
}

std::vector<Spot> spots_of_pavements(const Road& road, const Box2& box) {
  std::vector<Spot> spots;
  for (const furniture::Station& station : furniture::stations_along(road, box, kPavementStep_m)) {
    const double free_m = std::max(0.0, station.room_m - kFromKerb_m - kFromWall_m);
    const int count = spots_beside(free_m);
    for (int i = 0; i < count; ++i) {
      const StableId key = stable_id(station.key, "spot", static_cast<std::uint64_t>(i));
      const RandomSequence draw = place_draws(key);
      const double out_m = kFromKerb_m + across_m(draw, free_m, i, count);
      const Vec2 along = left_of(station.outward);
      const Vec2 at = station.inner_edge + station.outward * out_m + along * draw.between(-0.75, 0.75, 1);
      // those near the houses look at them
      const Vec2 towards = 2 * out_m > station.room_m ? station.outward : station.outward * -1.0;
      if (box.contains(at))
        spots.push_back({key, road.id.osm, at, along, towards, kPavementStep_m / count, SpotUse::kOpen, road.country});
    }
  }
  return spots;
}

// The spots across a way for walkers at one place of its axis.
void add_across_way(const Road& road, double at_m, Vec2 at, Vec2 along, std::uint64_t number, const Box2& box,
                    std::vector<Spot>& spots) {
  const roads::RoadEdges edges = roads::road_edges_at(road, at_m);
  const double width_m = edges.kerb_left_m + edges.kerb_right_m, free_m = std::max(0.0, width_m - 2 * kFromWall_m);
  const bool is_street = road.surface == LandCoverClass::kPedestrianStreet;
  const int count = spots_beside(free_m);
  for (int i = 0; i < count; ++i) {
    const StableId key =
        stable_id(stable_id(stable_id(road.id), "walkers", number), "spot", static_cast<std::uint64_t>(i));
    const RandomSequence draw = place_draws(key);
    const double off_m = kFromWall_m + across_m(draw, free_m, i, count) - edges.kerb_right_m;
    const double step_m = is_street ? kPavementStep_m : kPathStep_m;
    const Vec2 place = at + left_of(along) * off_m + along * draw.between(-step_m / 4, step_m / 4, 1);
    const double extent = is_street ? step_m * width_m / count : step_m / count;
    const SpotUse use = is_street ? SpotUse::kSquare : SpotUse::kOpen;
    if (box.contains(place))
      spots.push_back(
          {key, road.id.osm, place, along, left_of(along) * (off_m > 0 ? 1.0 : -1.0), extent, use, road.country});
  }
}

std::vector<Spot> spots_of_way(const Road& road, const Box2& box) {
  std::vector<Spot> spots;
  const double step_m = road.surface == LandCoverClass::kPedestrianStreet ? kPavementStep_m : kPathStep_m;
  const std::vector<double> along = roads::distances_along(road);
  const Box2 about = box.widened(roads::max_offset_m(road) + step_m);
  for (auto k = static_cast<std::int64_t>(std::ceil(along.front() / step_m));
       static_cast<double>(k) * step_m < along.back(); ++k) {
    const double at_m = static_cast<double>(k) * step_m;
    const Vec2 at = point_at(road.axis, along, at_m);
    if (!about.contains(at)) continue;
    const Vec2 ahead = unit(point_at(road.axis, along, std::min(at_m + 1, along.back())) - at);
    if (ahead != Vec2{}) add_across_way(road, at_m, at, ahead, static_cast<std::uint64_t>(k), box, spots);
  }
  return spots;
}

// A key that follows from a place.
StableId key_at(const char* role, Vec2 at) {
  const auto steps = [](double v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v / kQuantum_m)));
  };
  return stable_id(stable_id(stable_id(ObjectId{}), role, steps(at.x)), role, steps(at.y));
}

// The spots at both ends of a crossing, which is at a place of a road's axis.
void add_crossing(const Road& road, const std::vector<double>& along, double at_m, const Box2& box,
                  std::vector<Spot>& spots) {
  constexpr double kApart_m = 0.9, kBehind_m = 0.55;
  const Vec2 at = point_at(road.axis, along, at_m);
  const Vec2 ahead = unit(point_at(road.axis, along, std::min(at_m + 1, along.back())) -
                          point_at(road.axis, along, std::max(at_m - 1, along.front())));
  const roads::RoadEdges edges = roads::road_edges_at(road, at_m);
  for (const bool is_left : {true, false})
    for (const double shift_m : {-kApart_m, kApart_m}) {
      const Vec2 outward = left_of(ahead) * (is_left ? 1.0 : -1.0);
      const double off_m = (is_left ? edges.kerb_left_m : edges.kerb_right_m) + kBehind_m;
      const Vec2 place = at + outward * off_m + ahead * shift_m;
      if (box.contains(place))
        spots.push_back({key_at("crossing", place), road.id.osm, place, ahead, outward * -1.0, 1, SpotUse::kCrossing,
                         road.country});
    }
}

}  // namespace

std::vector<Spot> spots_along(const Road& road, const Box2& box) {
  if (!box_of(road.axis).widened(roads::max_offset_m(road)).touches(box)) return {};
  return is_for_walkers(road.surface) ? spots_of_way(road, box) : spots_of_pavements(road, box);
}

std::vector<Spot> spots_of_square(OsmId square, map::CountryGroup country, const Box2& box) {
  std::vector<Spot> spots;
  for (double y = std::floor(box.min.y / kSquareStep_m); y * kSquareStep_m < box.max.y; ++y)
    for (double x = std::floor(box.min.x / kSquareStep_m); x * kSquareStep_m < box.max.x; ++x) {
      const Vec2 corner = Vec2{x, y} * kSquareStep_m;
      const StableId key = key_at("square", corner);
      const RandomSequence draw = place_draws(key);
      const Vec2 at = corner + Vec2{draw.between(0.2, 0.8, 0), draw.between(0.2, 0.8, 1)} * kSquareStep_m;
      if (!box.contains(at)) continue;
      const Vec2 along = unit(Vec2{draw.between(-1, 1, 2), draw.between(0.05, 1, 3)});
      spots.push_back(
          {key, square, at, along, left_of(along), kSquareStep_m * kSquareStep_m, SpotUse::kSquare, country});
    }
  return spots;
}

std::vector<Spot> spots_at_crossings(std::span<const Road> roads, std::span<const roads::Junction> junctions,
                                     double tile_m, const Box2& box) {
  std::vector<Spot> spots;
  const std::vector<std::vector<roads::JunctionInterval>> intervals = roads::junction_intervals_of(roads, junctions);
  for (std::size_t i = 0; i < roads.size(); ++i) {
    const Road& road = roads[i];
    if (!map::is_street(road.surface) || road.points.empty()) continue;
    const std::vector<double> along = roads::distances_along(road);
    for (const roads::RoadStretch& stretch : roads::stretches_of(road, intervals[i], tile_m))
      if (stretch.stretch == roads::StretchKind::kZebra || stretch.stretch == roads::StretchKind::kCrossing)
        add_crossing(road, along, (stretch.from_m + stretch.to_m) / 2, box, spots);
  }
  return spots;
}

std::vector<Spot> spots_at_stop(const Solid& stop, map::CountryGroup country) {
  std::vector<Spot> spots;
  const Vec2 facing{stop.right.y, -stop.right.x};
  for (const double aside_m : {-3.9, -2.4, -0.9, 0.9, 2.4, 3.9}) {
    const StableId key = key_at("stop", stop.at + stop.right * aside_m);
    const double behind_m = place_draws(key).between(0.2, 1.2, 0);
    spots.push_back({key, stop.feature, stop.at + stop.right * aside_m - facing * behind_m, stop.right, facing, 1,
                     SpotUse::kStop, country});
  }
  return spots;
}

std::vector<Spot> spots_on_seat(const Solid& seat, map::CountryGroup country) {
  std::vector<Spot> spots;
  const Vec2 facing{seat.right.y, -seat.right.x};
  for (const double aside_m : {-seat.width_m / 4, seat.width_m / 4}) {
    const Vec2 at = seat.at + seat.right * aside_m;
    spots.push_back({key_at("seat", at), seat.feature, at, seat.right, facing, 1, SpotUse::kSeat, country});
  }
  return spots;
}

}  // namespace citykiln::people
