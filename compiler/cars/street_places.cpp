#include "compiler/cars/street_places.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/cars/car_models.h"
#include "compiler/geometry/line_part.h"
#include "compiler/roads/markings/bay_rows.h"
#include "compiler/roads/width_limits/narrowed_section.h"

namespace citykiln::cars {
namespace {

using map::LandCoverClass;
using map::Lane;
using map::LaneDirection;
using map::LaneKind;
using roads::Road;

// Narrowed lanes below these widths have no cars along them, or square to them.
constexpr double kLeastLane_m = 1.8125, kLeastSquare_m = 4.5;
constexpr double kBayLength_m = 5;
// A slanted place is this wide, and its corners reach over either edge of the row by the second.
constexpr double kSlantedPlace_m = 1.96875, kOverEdge_m = 0.3125;
// The cosine of the largest bend within a place, some 10 degrees.
constexpr double kStraight = 0.985;

struct AxisFrame {
  double along_m = 0;
  Vec2 at, ahead;
};

// A row of places along a road: `number` tells rows of a road apart.
struct Row {
  std::uint32_t number = 0;
  double step_m = 0;
  PlaceKind kind{};
};

// A part of the way where places are numbered from zero_m on.
struct Run {
  double from_m = 0, to_m = 0, zero_m = 0;
};

// The part of a place that depends on its frame.
struct Stance {
  double offset_m = 0;  // of the middle from the axis, to the left positive
  Vec2 ahead;
  double length_m = 0, width_m = 0;
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

// Adds the places of a row. stance_at(frame) is empty where there is no room.
class Rows {
 public:
  Rows(const Road& road, const Box2& box) : road_(road), box_(box), along_(roads::distances_along(road)) {}

  Run whole_way() const { return {along_.front(), along_.back(), 0}; }

  template <typename StanceAt, typename Finish>
  void add(const Row& row, const Run& run, StanceAt stance_at, Finish finish) {
    constexpr double kRounding = 1e-6;
    const auto first = static_cast<std::int64_t>(std::ceil((run.from_m - run.zero_m) / row.step_m - kRounding));
    const auto end = static_cast<std::int64_t>(std::floor((run.to_m - run.zero_m) / row.step_m + kRounding));
    for (std::int64_t k = first; k < end; ++k) {
      const double at_m = run.zero_m + (static_cast<double>(k) + 0.5) * row.step_m;
      if (!is_near(at_m)) continue;
      const std::optional<AxisFrame> frame = frame_at(road_, along_, at_m, row.step_m);
      const std::optional<Stance> stance = frame ? stance_at(*frame) : std::nullopt;
      if (!stance) continue;
      Place place = place_at(row, *frame, *stance);
      if (!box_.contains(place.at)) continue;
      finish(*frame, *stance, place);
      places.push_back(place);
    }
  }

  std::vector<Place> places{};

 private:
  bool is_near(double at_m) const {
    return box_.widened(roads::max_offset_m(road_) + 2 * kBayLength_m).contains(point_at(road_.axis, along_, at_m));
  }

  // Places of a row are more than 1/16 m apart.
  StableId key_at(const Row& row, double along_m) const {
    const StableId of_row = stable_id(stable_id(road_.id), "parking row", row.number);
    return stable_id(of_row, "place", static_cast<std::uint64_t>(std::floor(along_m * 16 + 0.5)));
  }

  Place place_at(const Row& row, const AxisFrame& frame, const Stance& stance) const {
    return {.key = key_at(row, frame.along_m),
            .feature = road_.id.osm,
            .at = frame.at + left_of(frame.ahead) * stance.offset_m,
            .ahead = stance.ahead,
            .length_m = stance.length_m,
            .width_m = stance.width_m,
            .kind = row.kind,
            .use = is_main(road_) ? PlaceUse::kMainStreet : PlaceUse::kHomeStreet,
            .country = road_.country};
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

// The bays of a lane, and their cars within its narrowed width.
struct LaneBays {
  roads::BayRow row;
  bool is_backward = false;

  std::optional<Stance> stance(const AxisFrame& frame, double offset_m, double width_m) const {
    if (row.is_along) {
      if (width_m < std::min(row.depth_m, kLeastLane_m)) return std::nullopt;
      return Stance{offset_m, is_backward ? frame.ahead * -1.0 : frame.ahead, row.step_m, kRow_m};
    }
    // cars look away from the road
    const Vec2 right = left_of(frame.ahead) * -1.0, line = right * width_m + frame.ahead * row.rise_m;
    const Vec2 ahead = offset_m > 0 ? unit(line) * -1.0 : unit(line);
    if (row.rise_m != 0) return slanted(ahead, offset_m, width_m, length(line));
    if (width_m < kLeastSquare_m) return std::nullopt;
    return Stance{offset_m, ahead, std::min(width_m, kBayLength_m), row.step_m};
  }

 private:
  std::optional<Stance> slanted(Vec2 ahead, double offset_m, double width_m, double line_m) const {
    const double sine = width_m / line_m, cosine = std::abs(row.rise_m) / line_m;
    const double length_m = (width_m + 2 * kOverEdge_m - kSlantedPlace_m * cosine) / sine;
    if (length_m < kLeastPlace_m) return std::nullopt;
    return Stance{offset_m, ahead, std::min(length_m, kBayLength_m), kSlantedPlace_m};
  }
};

// The part of a stretch in which bays are painted whole: lines lean over its ends by half of their rise.
std::optional<Run> painted_run(const roads::RoadStretch& stretch, double rise_m) {
  if (stretch.stretch == roads::StretchKind::kZebra || stretch.stretch == roads::StretchKind::kCrossing)
    return std::nullopt;
  const double lean_m = std::abs(rise_m) / 2;
  Run run{stretch.from_m + lean_m, stretch.to_m - lean_m, stretch.zero_m};
  if (stretch.stretch == roads::StretchKind::kStart)
    run.from_m = std::max(run.from_m, run.zero_m + roads::kLastBayEnds_m);
  if (stretch.stretch == roads::StretchKind::kEnd)
    run.to_m = std::min(run.to_m, run.zero_m + roads::kLayoutLength_m - roads::kLastBayEnds_m);
  return run;
}

// Places in the i-th lane of the section.
void add_lane(const Road& road, std::size_t i, std::span<const roads::RoadStretch> stretches, Rows& rows) {
  const Lane& lane = road.section.lanes[i];
  const LaneBays bays{roads::bays_of(lane, road.side), lane.way == LaneDirection::kBackward};
  const auto stance_at = [&](const AxisFrame& frame) {
    const roads::NarrowedSection section = roads::narrowed_section_at(road, frame.along_m);
    double left_m = section.left_m;
    for (std::size_t n = 0; n < i; ++n) left_m -= section.widths_m[n];
    return bays.stance(frame, left_m - section.widths_m[i] / 2, section.widths_m[i]);
  };
  const bool is_square = !bays.row.is_along && bays.row.rise_m == 0;
  const auto finish = [&](const AxisFrame& frame, const Stance& stance, Place& place) {
    place.surface = road.surface, place.across = to_far_kerb(road, frame, stance.offset_m);
    place.may_turn = is_square;
  };
  const Row row{.number = static_cast<std::uint32_t>(i), .step_m = bays.row.step_m, .kind = PlaceKind::kLane};
  for (const roads::RoadStretch& stretch : stretches)
    if (const std::optional<Run> run = painted_run(stretch, bays.row.rise_m)) rows.add(row, *run, stance_at, finish);
}

// The width between the kerbs that is not for parking.
double width_for_driving_m(const Road& road, double along_m) {
  const roads::NarrowedSection section = roads::narrowed_section_at(road, along_m);
  double width_m = 0;
  for (std::size_t i = 0; i < section.widths_m.size(); ++i)
    if (const Lane& lane = road.section.lanes[i]; !lane.is_raised && lane.kind != LaneKind::kParking)
      width_m += section.widths_m[i];
  return width_m;
}

void add_kerb(const Road& road, bool is_left, Rows& rows) {
  const int sides = road.kerb_parking == map::kBothSides ? 2 : 1;
  const bool is_backward = map::flows_back(road.section, road.side, is_left);
  const auto stance_at = [&](const AxisFrame& frame) -> std::optional<Stance> {
    if (width_for_driving_m(road, frame.along_m) < kFreeLane_m + sides * kRow_m) return std::nullopt;
    const roads::RoadEdges edges = roads::road_edges_at(road, frame.along_m);
    const double offset_m = is_left ? edges.kerb_left_m - kRow_m / 2 : kRow_m / 2 - edges.kerb_right_m;
    return Stance{offset_m, is_backward ? frame.ahead * -1.0 : frame.ahead, kKerbPlace_m, kRow_m};
  };
  const Row row{.number = is_left ? 64u : 65u, .step_m = kKerbPlace_m, .kind = PlaceKind::kKerb};
  rows.add(row, rows.whole_way(), stance_at, [&](const AxisFrame& frame, const Stance& stance, Place& place) {
    place.surface = road.surface, place.across = to_far_kerb(road, frame, stance.offset_m);
  });
}

// Places on a car park beside the outer edge of a road.
void add_beside(const Road& road, bool is_left, bool is_square, Rows& rows) {
  constexpr double kFromEdge_m = 0.125;
  const bool is_backward = map::flows_back(road.section, road.side, is_left);
  const auto stance_at = [&](const AxisFrame& frame) -> std::optional<Stance> {
    const roads::RoadEdges edges = roads::road_edges_at(road, frame.along_m);
    const double out_m = (is_square ? kBayLength_m : kRow_m) / 2 + kFromEdge_m;
    const double offset_m = is_left ? edges.left_m + out_m : -edges.right_m - out_m;
    if (is_square) return Stance{offset_m, left_of(frame.ahead) * (is_left ? 1.0 : -1.0), kBayLength_m, kBeside_m};
    return Stance{offset_m, is_backward ? frame.ahead * -1.0 : frame.ahead, kKerbPlace_m, kRow_m};
  };
  const Row row{.number = 66u + 2 * is_left + is_square,
                .step_m = is_square ? kBeside_m : kKerbPlace_m,
                .kind = is_square ? PlaceKind::kBay : PlaceKind::kLane};
  rows.add(row, rows.whole_way(), stance_at, [&](const AxisFrame&, const Stance&, Place& place) {
    place.surface = LandCoverClass::kParking, place.may_turn = is_square;
    if (road.surface == LandCoverClass::kServiceRoad) place.use = PlaceUse::kCarPark;
  });
}

}  // namespace

std::vector<Place> places_along(const Road& road, std::span<const roads::RoadStretch> stretches, const Box2& box) {
  if (!map::is_street(road.surface) ||
      !box_of(road.axis).widened(roads::max_offset_m(road) + 2 * kBayLength_m).touches(box))
    return {};
  Rows rows(road, box);
  for (std::size_t i = 0; i < road.section.lanes.size(); ++i)
    if (road.section.lanes[i].kind == LaneKind::kParking && !road.section.lanes[i].is_raised)
      add_lane(road, i, stretches, rows);
  for (const bool is_left : {true, false}) {
    if ((road.kerb_parking & (is_left ? map::kLeftSide : map::kRightSide)) != 0) add_kerb(road, is_left, rows);
    for (const bool is_square : {true, false}) add_beside(road, is_left, is_square, rows);
  }
  return std::move(rows.places);
}

}  // namespace citykiln::cars
