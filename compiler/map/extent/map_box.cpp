#include "compiler/map/extent/map_box.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "compiler/contract/erase_repeated.h"

namespace citykiln::map {
namespace {

using source::Location;
using source::LonLatBox;
using source::OsmData;

// Long relations drag in far nodes, so this share of buildings' or roads' nodes is left out, half of it at each end.
constexpr double kLeftOutShare = 0.02;
// The number of nodes that is enough to locate the extract.
constexpr std::size_t kEnoughPoints = 400;
// See map_box().
constexpr std::size_t kStrayPerCent = 1, kStrayNodes = 8, kStrayFraction = 10;

using Cell = std::pair<std::int32_t, std::int32_t>;

Cell cell_of(Location at) {
  constexpr std::int32_t kCell_e7 = static_cast<std::int32_t>(kGroupCell_deg * 1e7);
  const auto floored = [](std::int32_t v) { return v / kCell_e7 - (v % kCell_e7 < 0); };
  return {floored(at.lon_e7), floored(at.lat_e7)};
}

template <typename Visit>
void for_each_node(const OsmData& osm, Visit visit) {
  for (const source::NodeRef& node : osm.way_nodes) visit(node.id, node.at);
  for (const source::Node& node : osm.nodes) visit(node.id, node.at);
}

struct Group {
  std::vector<Cell> cells;
  std::size_t nodes = 0;
};

// Takes the cells around a cell, and the cells around these, out of `counts`.
Group take_group(Cell first, std::map<Cell, std::size_t>& counts) {
  Group group;
  std::vector<Cell> open{first};
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    const auto found = counts.find(cell);
    if (found == counts.end()) continue;
    group.cells.push_back(cell);
    group.nodes += found->second;
    counts.erase(found);
    for (std::int32_t dx = -1; dx <= 1; ++dx)
      for (std::int32_t dy = -1; dy <= 1; ++dy) open.push_back({cell.first + dx, cell.second + dy});
  }
  return group;
}

// The cells of stray groups.
std::set<Cell> stray_cells(const OsmData& osm) {
  std::map<Cell, std::size_t> counts;
  std::size_t all = 0, largest = 0;
  for_each_node(osm, [&](std::int64_t, Location at) { ++counts[cell_of(at)], ++all; });
  std::vector<Group> groups;
  while (!counts.empty()) groups.push_back(take_group(counts.begin()->first, counts));
  for (const Group& group : groups) largest = std::max(largest, group.nodes);
  std::set<Cell> stray;
  for (const Group& group : groups)
    if (group.nodes * 100 < all * kStrayPerCent ||
        (group.nodes <= kStrayNodes && group.nodes * kStrayFraction < largest))
      stray.insert(group.cells.begin(), group.cells.end());
  return stray;
}

struct Coordinates {
  std::vector<std::int32_t> lon, lat;
  void add(Location at) { lon.push_back(at.lon_e7), lat.push_back(at.lat_e7); }
};

Coordinates coordinates_of(const OsmData& osm, std::string_view key, const std::set<Cell>& stray) {
  Coordinates places;
  for (const source::Way& way : osm.ways) {
    if (osm.value_of(way.tags, key).empty()) continue;
    for (const source::NodeRef& node : osm.nodes_of(way))
      if (!stray.contains(cell_of(node.at))) places.add(node.at);
  }
  return places;
}

double quantile_deg(std::vector<std::int32_t>& values, double share) {
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth * 1e-7;
}

LonLatBox without_outermost(Coordinates places, double share) {
  assert(!places.lon.empty());
  const double cut = share / 2;
  return {quantile_deg(places.lon, cut), quantile_deg(places.lat, cut), quantile_deg(places.lon, 1 - cut),
          quantile_deg(places.lat, 1 - cut)};
}

LonLatBox box_of_nodes(const OsmData& osm, const std::set<Cell>& stray) {
  for (const std::string_view key : {"building", "highway"}) {
    Coordinates places = coordinates_of(osm, key, stray);
    if (places.lon.size() >= kEnoughPoints) return without_outermost(std::move(places), kLeftOutShare);
  }
  Coordinates all;
  for_each_node(osm, [&](std::int64_t, Location at) {
    if (!stray.contains(cell_of(at))) all.add(at);
  });
  return all.lon.empty() ? osm.node_box : without_outermost(std::move(all), 0);
}

double away_deg(const LonLatBox& box, Location at) {
  return std::max(
      {0.0, box.west - at.lon_deg(), at.lon_deg() - box.east, box.south - at.lat_deg(), at.lat_deg() - box.north});
}

}  // namespace

MapBox map_box(const OsmData& osm) {
  if (osm.header_box) return {*osm.header_box, {}};
  const std::set<Cell> stray = stray_cells(osm);
  MapBox map{box_of_nodes(osm, stray), {}};
  if (stray.empty()) return map;
  for_each_node(osm, [&](std::int64_t id, Location at) {
    if (stray.contains(cell_of(at))) map.strays.push_back({id, away_deg(map.box, at)});
  });
  sort_unique(map.strays);
  return map;
}

}  // namespace citykiln::map
