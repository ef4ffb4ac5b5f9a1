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

// The places on both sides of the meridian of 0°, which is the wide gap of a map across 180°.
struct Ends {
  std::int32_t least_east = INT32_MAX, most_west = INT32_MIN;  // of longitudes of 0 and more, and below 0

  void add(std::int32_t lon_e7) {
    if (lon_e7 >= 0)
      least_east = std::min(least_east, lon_e7);
    else
      most_west = std::max(most_west, lon_e7);
  }
  double west() const { return least_east * 1e-7; }
  double east() const { return most_west * 1e-7 + 360; }
  bool are_across() const {
    return least_east != INT32_MAX && most_west != INT32_MIN && east() - west() < kWidestAcross_deg;
  }
};

template <typename Visit>
void for_each_place(const Elements& elements, Visit visit) {
  for (const osmium::Node* node : elements.nodes) visit(node->location());
  for (const osmium::Way* way : elements.ways)
    for (const osmium::NodeRef& node : way->nodes())
      if (node.location().valid()) visit(node.location());
}

std::int32_t turned(std::int32_t lon_e7) {
  return static_cast<std::int32_t>(lon_e7 + (lon_e7 < 0 ? kTurn_e7 / 2 : -kTurn_e7 / 2));
}

}  // namespace

bool is_across_180(const Elements& elements) {
  Ends ends;
  for_each_place(elements, [&](osmium::Location at) { ends.add(at.x()); });
  return ends.are_across();
}

void turn_half(Elements& elements) {
  // the elements are in buffers of their own, of which nothing else knows the places
  for (const osmium::Node* node : elements.nodes)
    const_cast<osmium::Node*>(node)->set_location({turned(node->location().x()), node->location().y()});
  for (osmium::Way* way : elements.ways)
    for (osmium::NodeRef& node : way->nodes())
      if (node.location().valid()) node.set_location({turned(node.location().x()), node.location().y()});
}

void turn_half(std::vector<Location>& places) {
  for (Location& at : places) at.lon_e7 = turned(at.lon_e7);
}

void join_across_180(OsmData& data) {
  if (data.node_box.east - data.node_box.west <= 180) return;
  Ends ends;
  for_each_location(data, [&](const Location& at) { ends.add(at.lon_e7); });
  if (!ends.are_across()) return;
  const double west = ends.west(), east = ends.east();
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
