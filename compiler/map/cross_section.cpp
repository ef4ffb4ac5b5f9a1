#include "compiler/map/cross_section.h"

#include <algorithm>
#include <string_view>

#include "compiler/geometry/snap.h"

namespace citykiln::map {
namespace {

// One letter for each kind, in the order of LaneKind.
constexpr std::string_view kKindLetters = "dbtcpS/sfrg";
static_assert(kKindLetters.size() == static_cast<std::size_t>(LaneKind::kCount));

char letter_of(LaneDirection way) {
  return way == LaneDirection::kForward ? '^' : way == LaneDirection::kBackward ? 'v' : '-';
}

}  // namespace

bool is_soft(LaneKind kind) {
  return kind == LaneKind::kParking || kind == LaneKind::kShoulder || kind == LaneKind::kBuffer;
}

double carriageway_width_m(const CrossSection& section) {
  double sum = 0;
  for (const Lane& lane : section.lanes) sum += lane.is_raised ? 0 : lane.width_m;
  return sum;
}

double left_kerb_m(const CrossSection& section) { return section.axis_offset_m; }
double right_kerb_m(const CrossSection& section) { return carriageway_width_m(section) - section.axis_offset_m; }

double total_width_m(const CrossSection& section) {
  double sum = 0;
  for (const Lane& lane : section.lanes) sum += lane.width_m;
  return sum;
}

const Lane& lane_at_kerb(const CrossSection& section, bool is_left) {
  const auto is_level = [](const Lane& lane) { return !lane.is_raised; };
  if (is_left) return *std::ranges::find_if(section.lanes, is_level);
  return *std::find_if(section.lanes.rbegin(), section.lanes.rend(), is_level);
}

bool flows_back(const CrossSection& section, DrivingSide side, bool is_left) {
  const Lane& lane = lane_at_kerb(section, is_left);
  if (lane.way != LaneDirection::kBoth) return lane.way == LaneDirection::kBackward;
  return is_left == (side == DrivingSide::kRight);
}

Lane pavement_lane(double width_m) {
  return {.kind = LaneKind::kSidewalk, .width_m = snapped(width_m), .is_raised = true};
}

CrossSection with_pavement(CrossSection section, std::uint8_t sides, double width_m) {
  if ((sides & kLeftSide) != 0) section.lanes.insert(section.lanes.begin(), pavement_lane(width_m));
  if ((sides & kRightSide) != 0) section.lanes.push_back(pavement_lane(width_m));
  return section;
}

CrossSection with_verge(CrossSection section, std::uint8_t sides, double width_m) {
  const Lane verge{.kind = LaneKind::kVerge, .width_m = snapped(width_m), .is_raised = true};
  const auto is_level = [](const Lane& lane) { return !lane.is_raised; };
  std::vector<Lane>& lanes = section.lanes;
  if ((sides & kLeftSide) != 0) lanes.insert(std::ranges::find_if(lanes, is_level), verge);
  if ((sides & kRightSide) != 0) lanes.insert(std::find_if(lanes.rbegin(), lanes.rend(), is_level).base(), verge);
  return section;
}

std::string to_string(const CrossSection& section) {
  std::string kinds, ways;
  bool is_raised = !section.lanes.empty() && section.lanes.front().is_raised;
  for (const Lane& lane : section.lanes) {
    if (lane.is_raised != is_raised) kinds += '|', ways += '|';
    is_raised = lane.is_raised;
    kinds += kKindLetters[static_cast<std::size_t>(lane.kind)];
    ways += letter_of(lane.way);
  }
  return kinds + " " + ways;
}

}  // namespace citykiln::map
