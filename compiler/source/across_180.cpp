#include "compiler/source/across_180.h"

#include <algorithm>
#include <cstdint>

namespace citykiln::source {
namespace {

constexpr std::int64_t kTurn_e7 = 3600000000;

template <typename Visit>
void for_each_location(OsmData& data, Visit visit) {
  for (Node& node : data.nodes) visit(node.at);
  for (NodeRef& node : data.way_nodes) visit(node.at);
  for (Location& point : data.ring_points) visit(point);
}

struct Ends {
  std::int32_t least_east = INT32_MAX, most_west = INT32_MIN;  // of longitudes of 0 and more, and below 0
};

}  // namespace

void join_across_180(OsmData& data) {
  if (data.node_box.east - data.node_box.west <= 180) return;
  Ends ends;
  for_each_location(data, [&](const Location& at) {
    if (at.lon_e7 >= 0)
      ends.least_east = std::min(ends.least_east, at.lon_e7);
    else
      ends.most_west = std::max(ends.most_west, at.lon_e7);
  });
  if (ends.least_east == INT32_MAX || ends.most_west == INT32_MIN) return;
  const double west = ends.least_east * 1e-7, east = ends.most_west * 1e-7 + 360;
  if (!(east - west < kWidestAcross_deg)) return;
  for_each_location(data, [&](Location& at) {
    if (at.lon_e7 < 0) at.lon_e7 = static_cast<std::int32_t>(at.lon_e7 + kTurn_e7);
  });
  data.node_box.west = west, data.node_box.east = east;
  if (!data.header_box) return;
  // libosmium sorts the sides of a box
  LonLatBox& box = *data.header_box;
  if (box.east - box.west > 180) box = {box.east, box.south, box.west + 360, box.north};
  if (!(box.east > box.west && box.east - box.west < kWidestAcross_deg)) data.header_box.reset();
}

}  // namespace citykiln::source
