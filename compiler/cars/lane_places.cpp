#include "compiler/cars/lane_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "compiler/cars/street_places.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/line_part.h"
#include "compiler/roads/width_limits/narrowed_section.h"

namespace citykiln::cars {
namespace {

using map::LandCoverClass;
using map::LaneDirection;
using map::LaneKind;
using roads::Road;

constexpr double kTrafficDay_h = 24, kTrafficStep_h = 3;
constexpr int kTrafficSteps = 8;
using TrafficDay = std::array<double, kTrafficSteps>;
constexpr TrafficDay kTrafficDays[] = {
#define TRAFFIC_DAY(workday, weekend) TrafficDay workday, TrafficDay weekend
#include "compiler/cars/traffic.inc"
#undef TRAFFIC_DAY
};

struct TrafficRow {
  LandCoverClass surface;
  double cars_per_km, buses, lorries;
};
constexpr TrafficRow kTraffic[] = {
#define TRAFFIC_ON(surface, cars, buses, lorries) {LandCoverClass::surface, cars, buses, lorries},
#include "compiler/cars/traffic.inc"
#undef TRAFFIC_ON
};

// The least width in which a car drives, and a bus or lorry.
constexpr double kLeastTrack_m = 2.25, kLeastWide_m = 2.875;
// The width that a place takes: a car, and room for its mirrors.
constexpr double kCarPlace_m = 2, kWidePlace_m = 2.625;
// The lengths of places: the longest car that parks, a lorry, a bus.
constexpr double kCarLong_m = 5.4375, kLorryLong_m = 6.5, kBusLong_m = 12;
// Distances from junctions, crossings, level crossings and stop lines; the part of a lane that has a queue.
constexpr double kFromEnd_m = 0.5, kFromRails_m = 8, kFromLine_m = 1, kQueueZone_m = 30;
constexpr int kMostInQueue = 4;
// The cosine of the largest bend within a place, some 10 degrees.
constexpr double kStraightLane = 0.985;
// Draws of a slot, and of a queue.
enum : std::uint32_t { kDrawTaken, kDrawUser, kDrawAt, kDrawQueue };

const TrafficRow* traffic_of(const Road& road) {
  const auto* row = std::ranges::find(kTraffic, road.surface, &TrafficRow::surface);
  return row == std::end(kTraffic) ? nullptr : row;
}

// The traffic of a lane at a place: the middle of the way that it takes, and its width.
struct Flow {
  std::uint32_t number = 0;
  double offset_m = 0, width_m = 0;
  bool is_backward = false, is_bus = false;
};

bool is_driven(const map::Lane& lane) {
  return !lane.is_raised && (lane.kind == LaneKind::kDriving || lane.kind == LaneKind::kBus);
}

bool flows_backward(const map::Lane& lane) { return lane.way == LaneDirection::kBackward; }

// The lanes with traffic at a distance along a road, left to right.
struct LanesAt {
  const Road& road;
  double left_m = 0, right_m = 0;  // the outer edges of driven lanes
  std::vector<Flow> flows{};

  LanesAt(const Road& of_road, double along_m) : road(of_road) {
    const roads::NarrowedSection section = roads::narrowed_section_at(road, along_m);
    double edge_m = section.left_m;
    bool is_first = true;
    for (std::uint32_t i = 0; i < section.widths_m.size(); ++i) {
      const map::Lane& lane = road.section.lanes[i];
      const double width_m = section.widths_m[i];
      edge_m -= width_m;
      if (!is_driven(lane)) continue;
      if (is_first) left_m = edge_m + width_m;
      is_first = false, right_m = edge_m;
      add(lane, i, edge_m + width_m / 2, width_m);
    }
    leave_parked_cars();
    join_narrow();
  }

 private:
  void add(const map::Lane& lane, std::uint32_t i, double middle_m, double width_m) {
    const Flow flow{2 * i, middle_m, width_m, flows_backward(lane), lane.kind == LaneKind::kBus};
    if (lane.way != LaneDirection::kBoth) return flows.push_back(flow);
    // traffic against the way is on the left where one drives on the right
    const bool is_left_back = road.side == map::DrivingSide::kRight;
    flows.push_back({2 * i, middle_m + width_m / 4, width_m / 2, is_left_back, false});
    flows.push_back({2 * i + 1, middle_m - width_m / 4, width_m / 2, !is_left_back, false});
  }

  // Moves lanes together between rows of cars at the kerbs.
  void leave_parked_cars() {
    const double left = left_m - ((road.kerb_parking & map::kLeftSide) != 0 ? kRow_m + 0.25 : 0),
                 right = right_m + ((road.kerb_parking & map::kRightSide) != 0 ? kRow_m + 0.25 : 0);
    if (left_m <= right_m || left <= right) return flows.clear();
    const double scale = (left - right) / (left_m - right_m);
    for (Flow& flow : flows) flow.offset_m = right + (flow.offset_m - right_m) * scale, flow.width_m *= scale;
    left_m = left, right_m = right;
  }

  // Where lanes of both directions are too narrow, traffic of one takes their middle.
  void join_narrow() {
    const bool is_narrow = std::ranges::any_of(flows, [](const Flow& f) { return f.width_m < kLeastTrack_m; });
    if (!is_narrow) return;
    const bool is_backward = RandomSequence(0, stable_id(road.id), "traffic direction").unit(0) < 0.5;
    const auto kept = std::ranges::find(flows, is_backward, &Flow::is_backward);
    if (kept == flows.end() || left_m - right_m < kLeastTrack_m) return flows.clear();
    Flow flow = *kept;
    flow.offset_m = (left_m + right_m) / 2, flow.width_m = left_m - right_m;
    flows = {flow};
  }
};

// A part of a way without cars.
struct Gap {
  double from_m = 0, to_m = 0;
};

// The end of a lane at signals.
struct StopLine {
  double at_m = 0;
  bool is_backward = false;
};

// Finds the places of one road.
class LaneFinder {
 public:
  LaneFinder(const Road& road, std::span<const roads::JunctionInterval> intervals,
             std::span<const roads::RoadStretch> stretches, const TrafficSettings& settings, const Box2& box,
             const TrafficRow& row)
      : road_(road), settings_(settings), box_(box), row_(row), along_(roads::distances_along(road)) {
    add_gaps(intervals, stretches);
    for (const roads::RoadStretch& stretch : stretches) {
      if (stretch.control != roads::Control::kSignals) continue;
      if (stretch.stretch == roads::StretchKind::kEnd) lines_.push_back({stretch.to_m, false});
      if (stretch.stretch == roads::StretchKind::kStart) lines_.push_back({stretch.from_m, true});
    }
  }

  std::vector<LanePlace> places() {
    const auto first = static_cast<std::int64_t>(std::floor(along_.front() / kSlot_m));
    const auto last = static_cast<std::int64_t>(std::floor(along_.back() / kSlot_m));
    for (std::int64_t slot = first; slot <= last; ++slot) add_slot(slot);
    for (const StopLine& line : lines_) add_queues(line);
    return std::move(places_);
  }

 private:
  void add_gaps(std::span<const roads::JunctionInterval> intervals, std::span<const roads::RoadStretch> stretches) {
    for (const roads::JunctionInterval& junction : intervals)
      gaps_.push_back({junction.at_m - junction.before_m - kFromEnd_m, junction.at_m + junction.after_m + kFromEnd_m});
    for (const roads::RoadStretch& stretch : stretches)
      if (stretch.stretch == roads::StretchKind::kZebra || stretch.stretch == roads::StretchKind::kCrossing)
        gaps_.push_back({stretch.from_m - kFromEnd_m, stretch.to_m + kFromEnd_m});
    for (const map::TrackPoint& point : road_.points)
      if (point.kind == map::TrackPointKind::kLevelCrossing)
        gaps_.push_back({along_[point.vertex] - kFromRails_m, along_[point.vertex] + kFromRails_m});
  }

  double share() const {
    return settings_.share.is_by_table ? row_.cars_per_km / 1000 * kSlot_m * traffic_share(settings_.time)
                                       : settings_.share.share;
  }

  StableId key_of(const char* purpose, std::int64_t number, std::uint32_t flow) const {
    return stable_id(stable_id(stable_id(road_.id), purpose, static_cast<std::uint64_t>(number)), "lane", flow);
  }

  LaneUser user_of(const Flow& flow, double draw) const {
    if (flow.width_m < kLeastWide_m) return LaneUser::kCar;
    if (flow.is_bus || draw * 100 < row_.buses) return LaneUser::kBus;
    return draw * 100 < row_.buses + row_.lorries ? LaneUser::kLorry : LaneUser::kCar;
  }

  static double length_of(LaneUser user) {
    return user == LaneUser::kBus ? kBusLong_m : user == LaneUser::kLorry ? kLorryLong_m : kCarLong_m;
  }

  bool is_before_line(double at_m, bool is_backward) const {
    return std::ranges::any_of(lines_, [&](const StopLine& line) {
      const double before_m = line.is_backward ? at_m - line.at_m : line.at_m - at_m;
      return line.is_backward == is_backward && before_m > 0 && before_m < kQueueZone_m;
    });
  }

  void add_slot(std::int64_t slot) {
    const double middle_m = (static_cast<double>(slot) + 0.5) * kSlot_m;
    if (middle_m < along_.front() || middle_m > along_.back() || !is_near(middle_m)) return;
    for (const Flow& flow : LanesAt(road_, middle_m).flows) {
      const StableId key = key_of("traffic slot", slot, flow.number);
      const RandomSequence draw(settings_.seed, key, "traffic");
      if (draw.unit(kDrawTaken) >= share() * (flow.is_bus ? 0.5 : 1)) continue;
      const LaneUser user = user_of(flow, draw.unit(kDrawUser));
      const double spare_m = std::max(0.0, (kSlot_m - length_of(user)) / 2 - 1);
      const double at_m = middle_m + draw.between(-spare_m, spare_m, kDrawAt);
      if (!is_before_line(at_m, flow.is_backward)) add_place(key, at_m, flow.number, user);
    }
  }

  // The cars that wait at a line; by half of the time signals are green.
  void add_queues(const StopLine& line) {
    const auto number = static_cast<std::int64_t>(std::floor(line.at_m * 4 + 0.5));
    const double back = line.is_backward ? 1 : -1, first_m = line.at_m + back * (kFromLine_m + kCarLong_m / 2);
    if (first_m < along_.front() || first_m > along_.back() || !is_near(line.at_m)) return;
    for (const Flow& flow : LanesAt(road_, first_m).flows) {
      if (flow.is_backward != line.is_backward) continue;
      const StableId lane = key_of("traffic queue", number, flow.number);
      const double draw = 2 * RandomSequence(settings_.seed, lane, "traffic").unit(kDrawQueue) - 1;
      const int waiting = static_cast<int>(std::ceil(draw * kMostInQueue * std::min(1.0, 4 * share())));
      for (int i = 0; i < waiting; ++i)
        add_place(stable_id(lane, "car", static_cast<std::uint64_t>(i)), first_m + back * kQueue_m * i, flow.number,
                  LaneUser::kCar);
    }
  }

  bool is_near(double at_m) const {
    return box_.widened(roads::max_offset_m(road_) + kQueueZone_m).contains(point_at(road_.axis, along_, at_m));
  }

  bool is_in_gap(double from_m, double to_m) const {
    return std::ranges::any_of(gaps_, [&](const Gap& gap) { return from_m < gap.to_m && to_m > gap.from_m; });
  }

  void add_place(StableId key, double at_m, std::uint32_t number, LaneUser user) {
    const double half_m = length_of(user) / 2, from_m = at_m - half_m, to_m = at_m + half_m;
    if (from_m < along_.front() || to_m > along_.back() || is_in_gap(from_m, to_m)) return;
    const Vec2 a = point_at(road_.axis, along_, from_m), b = point_at(road_.axis, along_, at_m),
               c = point_at(road_.axis, along_, to_m);
    if (dot(unit(b - a), unit(c - b)) < kStraightLane) return;
    const LanesAt lanes(road_, at_m);
    const auto flow = std::ranges::find(lanes.flows, number, &Flow::number);
    const double width_m = user == LaneUser::kCar ? kCarPlace_m : kWidePlace_m;
    if (flow == lanes.flows.end() || flow->width_m < width_m + 0.25) return;
    const Vec2 ahead = unit(c - a), at = b + left_of(ahead) * flow->offset_m;
    if (!box_.contains(at)) return;
    const roads::RoadEdges edges = roads::road_edges_at(road_, at_m);
    places_.push_back({{.key = key,
                        .feature = road_.id.osm,
                        .at = at,
                        .ahead = flow->is_backward ? ahead * -1.0 : ahead,
                        .length_m = 2 * half_m,
                        .width_m = width_m,
                        .kind = PlaceKind::kLane,
                        .use = PlaceUse::kMainStreet,
                        .country = road_.country,
                        .surface = road_.surface,
                        .across = left_of(ahead) * (edges.kerb_left_m - flow->offset_m)},
                       user});
  }

  const Road& road_;
  const TrafficSettings& settings_;
  const Box2& box_;
  const TrafficRow& row_;
  std::vector<double> along_;
  std::vector<Gap> gaps_{};
  std::vector<StopLine> lines_{};
  std::vector<LanePlace> places_{};
};

}  // namespace

double traffic_share(buildings::WeekTime time) {
  const double at = time.hours / kTrafficStep_h;
  const int before = static_cast<int>(std::floor(at));
  const auto share_at = [](int step) {
    const bool is_weekend = step / kTrafficSteps % 7 >= 5;
    return kTrafficDays[is_weekend ? 1 : 0][static_cast<std::size_t>(step % kTrafficSteps)];
  };
  return share_at(before) * (1 - (at - before)) + share_at(before + 1) * (at - before);
}

std::vector<LanePlace> lane_places(const Road& road, std::span<const roads::JunctionInterval> intervals,
                                   std::span<const roads::RoadStretch> stretches, const TrafficSettings& settings,
                                   const Box2& box) {
  static_assert(kTrafficDay_h == kTrafficStep_h * kTrafficSteps);
  const TrafficRow* row = traffic_of(road);
  const bool is_near = box_of(road.axis).widened(roads::max_offset_m(road) + kQueueZone_m).touches(box);
  if (row == nullptr || !is_near || road.is_roundabout) return {};
  return LaneFinder(road, intervals, stretches, settings, box, *row).places();
}

}  // namespace citykiln::cars
