#include "compiler/map/lanes/lane_roadside.h"

#include <algorithm>

#include "compiler/geometry/snap.h"
#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

struct CyclewayRow {
  std::string_view value;
  bool is_raised, is_contraflow;
};
constexpr CyclewayRow kCycleways[] = {
#define CYCLEWAY(value, is_raised, is_contraflow) {value, is_raised, is_contraflow},
#include "compiler/map/lanes/lane_rules.inc"
#undef CYCLEWAY
};

struct MeasureRow {
  std::string_view value;
  double measure;
};
constexpr MeasureRow kParkings_m[] = {
#define PARKING(value, metres) {value, metres},
#include "compiler/map/lanes/lane_rules.inc"
#undef PARKING
};
constexpr MeasureRow kParkingPlaces[] = {
#define PARKING_PLACE(value, share_inside) {value, share_inside},
#include "compiler/map/lanes/lane_rules.inc"
#undef PARKING_PLACE
};

// cycleway=* without a side applies to both sides of a two-way road. On one-way roads it applies to the traffic's side,
// and a contraflow lane to the other side.
const CyclewayRow* cycleway_beside(const LaneTags& tags, Flow flow) {
  if (const std::string_view beside = tags.beside(flow, "cycleway"); !beside.empty())
    return row_with(kCycleways, beside);
  const CyclewayRow* row = row_with(kCycleways, tags("cycleway"));
  if (row == nullptr || !tags.is_one_way()) return row;
  return row->is_contraflow == (flow == tags.only_flow()) ? nullptr : row;
}

LaneDirection cycling_way(const LaneTags& tags, Flow flow, const CyclewayRow& row) {
  const std::string_view oneway = tags.beside(flow, "cycleway", ":oneway");
  if (oneway == "-1") return LaneDirection::kBackward;
  if (oneway == "no") return LaneDirection::kBoth;
  if (!tags.is_one_way()) return way_of(flow);
  // contraflow cyclists ride on the other side
  const bool rides_against =
      row.is_contraflow || (flow != tags.only_flow() && oneway.empty() && tags("oneway:bicycle") == "no");
  return way_of(rides_against ? opposite(tags.only_flow()) : tags.only_flow());
}

double buffer_m(const LaneTags& tags, Flow flow) {
  std::string_view text = tags.beside(flow, "cycleway", ":buffer");
  if (text.empty()) text = tags("cycleway:buffer");
  if (!says_yes(text) || text == "none") return 0;
  const auto length = length_m_of(text);
  return length && *length > 0 ? std::clamp(*length, 0.1, 5.0) : kBuffer_m;
}

void add_cycleway(const LaneTags& tags, Flow flow, bool is_raised, std::vector<RoadsideLane>& lanes) {
  const CyclewayRow* row = cycleway_beside(tags, flow);
  if (row == nullptr || row->is_raised != is_raised) return;
  const LaneDirection way = cycling_way(tags, flow, *row);
  const double usual_m = way == LaneDirection::kBoth ? kTwoWayCycling_m : is_raised ? kCycleTrack_m : kCycleLane_m;
  const double width_m = snapped(tags.width_beside(flow, "cycleway").value_or(usual_m));
  if (const double buffer = snapped(buffer_m(tags, flow)); buffer > 0)
    lanes.push_back({{.kind = LaneKind::kBuffer, .width_m = buffer, .is_raised = is_raised}, is_raised ? 0 : buffer});
  lanes.push_back(
      {{.kind = LaneKind::kCycle, .way = way, .width_m = width_m, .is_raised = is_raised}, is_raised ? 0 : width_m});
}

// Parked cars face with the adjacent traffic.
LaneDirection parking_way(const LaneTags& tags, Flow flow) {
  if (tags.traffic == Traffic::kInTurns) return LaneDirection::kBoth;
  return way_of(tags.is_one_way() ? tags.only_flow() : flow);
}

struct Parking {
  double width_m, share_inside;
};

// Reads parking:<side>=place and parking:<side>:orientation=how.
std::optional<Parking> parking_by_place(const LaneTags& tags, Flow flow, std::string_view place) {
  const MeasureRow* where = row_with(kParkingPlaces, place);
  // an orientation under the wrong key
  if (const MeasureRow* how = row_with(kParkings_m, place)) return Parking{how->measure, 1};
  if (where == nullptr) return std::nullopt;
  const MeasureRow* how = row_with(kParkings_m, tags.beside(flow, "parking", ":orientation"));
  const double usual_m = how != nullptr ? how->measure : kParkings_m[0].measure;
  return Parking{tags.width_beside(flow, "parking").value_or(usual_m), where->measure};
}

// Reads parking:lane:<side>=how and parking:lane:<side>:how=place.
std::optional<Parking> parking_by_lane(const LaneTags& tags, Flow flow) {
  const std::string_view value = tags.beside(flow, "parking:lane");
  const MeasureRow* how = row_with(kParkings_m, value);
  if (how == nullptr) return std::nullopt;
  const MeasureRow* where = row_with(kParkingPlaces, tags.beside(flow, "parking:lane", std::string(":").append(value)));
  return Parking{how->measure, where != nullptr ? where->measure : 1};
}

void add_parking(const LaneTags& tags, Flow flow, std::vector<RoadsideLane>& lanes) {
  const std::string_view place = tags.beside(flow, "parking");
  const auto parking = place.empty() ? parking_by_lane(tags, flow) : parking_by_place(tags, flow, place);
  if (!parking) return;
  const double width_m = snapped(parking->width_m);
  lanes.push_back({{.kind = LaneKind::kParking, .way = parking_way(tags, flow), .width_m = width_m},
                   snapped(width_m * parking->share_inside)});
}

// True where a value ("both", "yes", "left;right") includes the flow's side. With `yes_is_both`, yes on a one-way road
// means both sides.
bool names_side(const LaneTags& tags, Flow flow, std::string_view value, bool yes_is_both) {
  value = value.substr(0, value.find(';'));
  if (value == "both" || value == tags.roadside(flow)) return true;
  return value == "yes" && (yes_is_both || !tags.is_one_way() || flow == tags.only_flow());
}

bool has_shoulder(const LaneTags& tags, Flow flow) {
  const std::string_view beside = tags.beside(flow, "shoulder");
  if (!beside.empty()) return says_yes(beside) && beside != "none";
  return names_side(tags, flow, tags("shoulder"), false) || tags.beside(flow, "cycleway") == "shoulder";
}

// True where tags give a flow a pavement or verge; a one-way road has them on both sides.
bool is_beside(const LaneTags& tags, Flow flow, std::string_view key) {
  const std::string_view beside = tags.beside(flow, key);
  if (!beside.empty()) return beside == "yes" || beside == "both" || beside == tags.roadside(flow);
  return names_side(tags, flow, tags(key), true);
}

void add_verge(const LaneTags& tags, Flow flow, std::vector<RoadsideLane>& lanes) {
  if (!is_beside(tags, flow, "verge")) return;
  const double width_m = snapped(tags.width_beside(flow, "verge").value_or(kVerge_m));
  lanes.push_back({{.kind = LaneKind::kVerge, .width_m = width_m, .is_raised = true}, 0});
}

}  // namespace

bool says_pavement(const LaneTags& tags, Flow flow) {
  return !tags.beside(flow, "sidewalk").empty() || !tags("sidewalk").empty();
}

bool fixes_pavement(const LaneTags& tags, Flow flow) {
  if (!says_pavement(tags, flow)) return false;
  if (is_beside(tags, flow, "sidewalk")) return tags.width_beside(flow, "sidewalk").has_value();
  const std::string_view beside = tags.beside(flow, "sidewalk");
  return (beside.empty() ? tags("sidewalk") : beside) != "separate";
}

bool says_verge(const LaneTags& tags, Flow flow) {
  return !tags.beside(flow, "verge").empty() || !tags("verge").empty();
}

bool says_parking(const LaneTags& tags, Flow flow) {
  return !tags.beside(flow, "parking").empty() || !tags.beside(flow, "parking:lane").empty();
}

std::vector<RoadsideLane> roadside_of(const LaneTags& tags, const LaneClass& lane_class, Flow flow,
                                      bool has_cycle_lane) {
  std::vector<RoadsideLane> lanes;
  if (!has_cycle_lane) add_cycleway(tags, flow, false, lanes);
  add_parking(tags, flow, lanes);
  if (has_shoulder(tags, flow)) {
    const double usual_m = lane_class.is_motorway ? kMotorwayShoulder_m : kShoulder_m;
    const double width_m = snapped(tags.width_beside(flow, "shoulder").value_or(usual_m));
    lanes.push_back({{.kind = LaneKind::kShoulder, .way = parking_way(tags, flow), .width_m = width_m}, 0});
  }
  add_verge(tags, flow, lanes);
  add_cycleway(tags, flow, true, lanes);
  if (is_beside(tags, flow, "sidewalk")) {
    const double width_m = tags.width_beside(flow, "sidewalk").value_or(kSidewalk_m);
    lanes.push_back({pavement_lane(width_m), 0});
  }
  return lanes;
}

}  // namespace citykiln::map
