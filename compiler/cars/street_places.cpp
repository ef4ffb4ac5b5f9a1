#include "compiler/cars/street_places.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/geometry/line_part.h"
#include "compiler/roads/width_limits/narrowed_section.h"

namespace citykiln::cars {
namespace {

using map::LandCoverClass;
using map::Lane;
using map::LaneDirection;
using map::LaneKind;
using roads::Road;

// Parking lanes from this width on have cars across them. Narrowed ones below the least width have none.
constexpr double kLeastAcross_m = 4, kLeastLane_m = 1.8125;
constexpr double kBayLength_m = 5;
// The cosine of the largest bend within a place, some 10 degrees.
constexpr double kStraight = 0.985;

struct AxisFrame {
  double along_m = 0;
  Vec2 at, ahead;
};

// A row of places along a road: `number` tells rows of a road apart.
struct Row {
  std::uint32_t number = 0;
  double step_m = 0, across_m = 0;  // along the road and across it
  PlaceKind kind{};
  bool is_across = false;  // cars look away from the road
};

// The middle of a place on the axis, if the axis is straight beside it.
std::optional<AxisFrame> frame_at(const Road& road, const std::vector<double>& along, double at_m, double length_m) {
  const double from_m = at_m - length_m / 2, to_m = at_m + length_m / 2;
  if (from_m < along.front() || to_m > along.back()) return std::nullopt;
  const Vec2 a = point_at(road.axis, along, from_m), b = point_at(road.axis, along, at_m),
             c = point_at(road.axis, along, to_m);
  if (dot(unit(b - a), unit(c - b)) < kStraight) return std::nullopt;
  return AxisFrame{at_m, b, unit(c - a)};
}

bool is_main(const Road& road) {
  return roads::priority_of(road) > map::values_of(LandCoverClass::kResidentialRoad).priority;
}

// Adds the places of a row. offset_of(frame) is the distance of their middles from the axis, to the left positive;
// nothing where there is no room.
class Rows {
 public:
  Rows(const Road& road, const Box2& box) : road_(road), box_(box), along_(roads::distances_along(road)) {}

  template <typename OffsetAt, typename Finish>
  void add(const Row& row, OffsetAt offset_at, Finish finish) {
    const auto first = static_cast<std::int64_t>(std::ceil(along_.front() / row.step_m - 0.5));
    for (std::int64_t k = std::max<std::int64_t>(first, 0); (static_cast<double>(k) + 0.5) * row.step_m < along_.back();
         ++k) {
      const double at_m = (static_cast<double>(k) + 0.5) * row.step_m;
      if (!is_near(at_m)) continue;
      const std::optional<AxisFrame> frame = frame_at(road_, along_, at_m, row.step_m);
      const std::optional<double> offset_m = frame ? offset_at(*frame) : std::nullopt;
      if (!offset_m) continue;
      Place place = place_at(row, k, *frame, *offset_m);
      if (!box_.contains(place.at)) continue;
      finish(*frame, *offset_m, place);
      places.push_back(place);
    }
  }

  std::vector<Place> places{};

 private:
  bool is_near(double at_m) const {
    return box_.widened(roads::max_offset_m(road_) + 2 * kBayLength_m).contains(point_at(road_.axis, along_, at_m));
  }

  Place place_at(const Row& row, std::int64_t k, const AxisFrame& frame, double offset_m) const {
    const Vec2 left = left_of(frame.ahead);
    const StableId of_row = stable_id(stable_id(road_.id), "parking row", row.number);
    return {.key = stable_id(of_row, "place", static_cast<std::uint64_t>(k)),
            .feature = road_.id.osm,
            .at = frame.at + left * offset_m,
            .ahead = row.is_across ? left * (offset_m > 0 ? 1.0 : -1.0) : frame.ahead,
            .length_m = row.is_across ? row.across_m : row.step_m,
            .width_m = row.is_across ? row.step_m : row.across_m,
            .kind = row.kind,
            .use = is_main(road_) ? PlaceUse::kMainStreet : PlaceUse::kHomeStreet,
            .country = road_.country,
            .may_turn = row.is_across};
  }

  const Road& road_;
  const Box2& box_;
  std::vector<double> along_;
};

Vec2 to_far_kerb(const Road& road, const AxisFrame& frame, double offset_m) {
  const roads::RoadEdges edges = roads::road_edges_at(road, frame.along_m);
  const double far_m = offset_m > 0 ? -edges.kerb_right_m : edges.kerb_left_m;
  return left_of(frame.ahead) * (far_m - offset_m);
}

// Places in the i-th lane of the section.
void add_lane(const Road& road, std::size_t i, std::uint32_t number, Rows& rows) {
  const Lane& lane = road.section.lanes[i];
  const bool is_across = lane.width_m >= kLeastAcross_m;
  const Row row{.number = number,
                .step_m = is_across ? kAcross_m : kKerbPlace_m,
                .across_m = is_across ? kBayLength_m : kRow_m,
                .kind = PlaceKind::kLane,
                .is_across = is_across};
  const auto offset_at = [&](const AxisFrame& frame) -> std::optional<double> {
    const roads::NarrowedSection section = roads::narrowed_section_at(road, frame.along_m);
    double left_m = section.left_m;
    for (std::size_t n = 0; n < i; ++n) left_m -= section.widths_m[n];
    if (section.widths_m[i] < (is_across ? kLeastAcross_m : std::min(lane.width_m, kLeastLane_m))) return std::nullopt;
    return left_m - section.widths_m[i] / 2;
  };
  rows.add(row, offset_at, [&](const AxisFrame& frame, double offset_m, Place& place) {
    if (!is_across && lane.way == LaneDirection::kBackward) place.ahead = place.ahead * -1.0;
    place.surface = road.surface, place.across = to_far_kerb(road, frame, offset_m);
  });
}

// The outermost lane between the kerbs of a side.
const Lane& lane_at_kerb(const Road& road, bool is_left) {
  const std::vector<Lane>& lanes = road.section.lanes;
  const auto is_level = [](const Lane& lane) { return !lane.is_raised; };
  if (is_left) return *std::ranges::find_if(lanes, is_level);
  return *std::find_if(lanes.rbegin(), lanes.rend(), is_level);
}

// Cars look along the traffic beside them: of a lane for both directions along that of the side on which one drives.
bool looks_back(const Road& road, bool is_left) {
  const Lane& lane = lane_at_kerb(road, is_left);
  if (lane.way != LaneDirection::kBoth) return lane.way == LaneDirection::kBackward;
  return is_left == (road.side == map::DrivingSide::kRight);
}

void add_kerb(const Road& road, bool is_left, Rows& rows) {
  const int sides = road.kerb_parking == map::kBothSides ? 2 : 1;
  const Row row{.number = is_left ? 64u : 65u, .step_m = kKerbPlace_m, .across_m = kRow_m, .kind = PlaceKind::kKerb};
  const auto offset_at = [&](const AxisFrame& frame) -> std::optional<double> {
    const roads::RoadEdges edges = roads::road_edges_at(road, frame.along_m);
    if (edges.kerb_left_m + edges.kerb_right_m < kFreeLane_m + sides * kRow_m) return std::nullopt;
    return is_left ? edges.kerb_left_m - kRow_m / 2 : kRow_m / 2 - edges.kerb_right_m;
  };
  const bool is_backward = looks_back(road, is_left);
  rows.add(row, offset_at, [&](const AxisFrame& frame, double offset_m, Place& place) {
    if (is_backward) place.ahead = place.ahead * -1.0;
    place.surface = road.surface, place.across = to_far_kerb(road, frame, offset_m);
  });
}

// Places on a car park beside the outer edge of a road.
void add_beside(const Road& road, bool is_left, bool is_across, Rows& rows) {
  constexpr double kFromEdge_m = 0.125;
  const Row row{.number = 66u + 2 * is_left + is_across,
                .step_m = is_across ? kAcross_m : kKerbPlace_m,
                .across_m = is_across ? kBayLength_m : kRow_m,
                .kind = is_across ? PlaceKind::kBay : PlaceKind::kLane,
                .is_across = is_across};
  const auto offset_at = [&](const AxisFrame& frame) -> std::optional<double> {
    const roads::RoadEdges edges = roads::road_edges_at(road, frame.along_m);
    const double out_m = row.across_m / 2 + kFromEdge_m;
    return is_left ? edges.left_m + out_m : -edges.right_m - out_m;
  };
  const bool is_backward = looks_back(road, is_left);
  rows.add(row, offset_at, [&](const AxisFrame&, double, Place& place) {
    if (!is_across && is_backward) place.ahead = place.ahead * -1.0;
    place.surface = LandCoverClass::kParking;
    if (road.surface == LandCoverClass::kServiceRoad) place.use = PlaceUse::kCarPark;
  });
}

}  // namespace

std::vector<Place> places_along(const Road& road, const Box2& box) {
  if (!map::is_street(road.surface) ||
      !box_of(road.axis).widened(roads::max_offset_m(road) + 2 * kBayLength_m).touches(box))
    return {};
  Rows rows(road, box);
  for (std::size_t i = 0; i < road.section.lanes.size(); ++i)
    if (road.section.lanes[i].kind == LaneKind::kParking && !road.section.lanes[i].is_raised)
      add_lane(road, i, static_cast<std::uint32_t>(i), rows);
  for (const bool is_left : {true, false}) {
    if ((road.kerb_parking & (is_left ? map::kLeftSide : map::kRightSide)) != 0) add_kerb(road, is_left, rows);
    for (const bool is_across : {true, false}) add_beside(road, is_left, is_across, rows);
  }
  return std::move(rows.places);
}

}  // namespace citykiln::cars
