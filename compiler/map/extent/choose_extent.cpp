#include "compiler/map/extent/choose_extent.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "compiler/map/extent/map_box.h"
#include "compiler/map/plane/lonlat_box.h"

namespace citykiln::map {
namespace {

using source::LonLatBox;
using source::OsmData;

bool touches(const LonLatBox& a, const LonLatBox& b) {
  return a.west <= b.east && b.west <= a.east && a.south <= b.north && b.south <= a.north;
}

LonLatBox around(const LonLatBox& a, const LonLatBox& b) {
  return {std::min(a.west, b.west), std::min(a.south, b.south), std::max(a.east, b.east), std::max(a.north, b.north)};
}

LonLatBox in_both(const LonLatBox& a, const LonLatBox& b) {
  return {std::max(a.west, b.west), std::max(a.south, b.south), std::min(a.east, b.east), std::min(a.north, b.north)};
}

double area_deg2(const LonLatBox& box) { return (box.east - box.west) * (box.north - box.south); }

bool is_far_larger(const LonLatBox& box, const LonLatBox& map) {
  const auto exceeds = [](double side, double of_map) { return side > kNeverClipped_deg && side > 2 * of_map; };
  return exceeds(box.east - box.west, map.east - map.west) || exceeds(box.north - box.south, map.north - map.south);
}

std::size_t nodes_in(const OsmData& osm) { return osm.way_nodes.size() + osm.nodes.size(); }

Error misses(const LonLatBox& asked, const LonLatBox& map) {
  const LonLatBox swapped{asked.south, asked.west, asked.north, asked.east};
  std::string message = fmt::format("lies outside of the map, which lies in {} (W,S,E,N)", text_of(map));
  if (touches(swapped, map)) message += fmt::format("; latitude and longitude swapped? Try {}", text_of(swapped));
  return {"--bbox " + text_of(asked), message};
}

// Where most nodes of a map lie: a box of kProposed_deg a side around the fullest cell of a grid of half that side.
constexpr double kProposed_deg = 0.05;

LonLatBox fullest_box(const OsmData& osm) {
  constexpr double kCell_deg = kProposed_deg / 2;
  std::map<std::pair<int, int>, std::size_t> cells;
  const auto count = [&](const source::Location& at) {
    ++cells[{static_cast<int>(std::floor(at.lon_deg() / kCell_deg)),
             static_cast<int>(std::floor(at.lat_deg() / kCell_deg))}];
  };
  for (const source::Node& node : osm.nodes) count(node.at);
  for (const source::NodeRef& node : osm.way_nodes) count(node.at);
  const auto most = std::ranges::max_element(cells, {}, [](const auto& cell) { return cell.second; });
  const double west = (most->first.first - 0.5) * kCell_deg, south = (most->first.second - 0.5) * kCell_deg;
  return {west, south, west + kProposed_deg, south + kProposed_deg};
}

// A box to compile instead of one that is too large: that of the nodes if it is far smaller, else where most nodes are.
std::string proposed_box(const Box2& extent, const OsmData& osm) {
  if (nodes_in(osm) == 0) return "give a part of it";
  const LonLatBox& nodes = osm.node_box;
  constexpr double kDegrees_m = 111320;
  const double most_deg = std::min(kMaxSide_m, std::max(extent.width(), extent.height()) / 2) / kDegrees_m;
  const bool is_small = nodes.east - nodes.west < most_deg && nodes.north - nodes.south < most_deg &&
                        nodes.east > nodes.west && nodes.north > nodes.south;
  const LonLatBox box = is_small ? nodes : fullest_box(osm);
  return fmt::format("its nodes lie in {}; try {}--bbox {}", text_of(nodes), is_small ? "" : "a part with many, ",
                     text_of(box));
}

}  // namespace

Result<LonLatBox> choose_extent(const OsmData& osm, const std::optional<LonLatBox>& asked, Report& report) {
  const MapBox map = map_box(osm);
  if (!asked) {
    for (const StrayNode& node : map.strays) report.add(Code::kStrayNode, {OsmType::kNode, node.id}, node.away_deg);
    return map.box;
  }
  if (nodes_in(osm) > 0 && !touches(*asked, around(map.box, osm.node_box))) return misses(*asked, map.box);
  if (!touches(*asked, map.box) || !is_far_larger(*asked, map.box)) return *asked;
  const LonLatBox clipped = in_both(*asked, map.box);
  report.add(Code::kBoxClipped, {}, 1 - area_deg2(clipped) / area_deg2(*asked));
  return clipped;
}

Result<Done> check_worth_baking(const Box2& extent, const OsmData& osm, bool has_box) {
  const double area_m2 = extent.width() * extent.height();
  const bool is_sparse = !has_box && area_m2 > kSparseFrom_m2 && static_cast<double>(nodes_in(osm)) < area_m2 * 1e-6;
  if (extent.width() <= kMaxSide_m && extent.height() <= kMaxSide_m && !is_sparse) return Done{};
  return Error{
      osm.file_name,
      fmt::format("the area to compile measures {:.0f} x {:.0f} km, {}, and the map has {} nodes; {} (W,S,E,N, "
                  "at most {:.0f} km a side)",
                  extent.width() / 1000, extent.height() / 1000,
                  has_box ? "by the box in the map's header or --bbox" : "by its nodes", nodes_in(osm),
                  proposed_box(extent, osm), kMaxSide_m / 1000)};
}

}  // namespace citykiln::map
