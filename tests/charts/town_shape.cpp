#include "tests/charts/town_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"
#include "compiler/parcels/divide.h"
#include "compiler/source/read_osm.h"

namespace citykiln::charts {
namespace {

constexpr double kDensityCell_m = 256;
constexpr std::size_t kBuiltUp = 5;
constexpr double kLargestBlock_m2 = 2e5;
constexpr double kLeastFootprint_m2 = 10;
constexpr double kStorey_m = 3;
constexpr double kStreetHalf_m = 5;

bool is_car_street(std::string_view highway) {
  constexpr std::array kStreets = {"trunk",       "primary",      "secondary",    "tertiary",
                                   "residential", "unclassified", "living_street"};
  return std::ranges::find(kStreets, highway) != kStreets.end();
}

/// Metres about a place, by a cylindrical projection: exact enough for statistics.
struct LocalMetres {
  double lon_deg, lat_deg, per_lon_m;
  Vec2 operator()(source::Location at) const {
    return snapped(Vec2{(at.lon_deg() - lon_deg) * per_lon_m, (at.lat_deg() - lat_deg) * 111200.0});
  }
};

LocalMetres metres_about(const source::LonLatBox& box) {
  const double lat_deg = (box.south + box.north) / 2;
  return {(box.west + box.east) / 2, lat_deg, 111320.0 * std::cos(lat_deg * kPi / 180)};
}

// the stated height, or that of the stated storeys; 0 if neither is stated
double height_of(std::string_view height, std::string_view storeys) {
  if (const double stated_m = std::atof(std::string(height).c_str()); stated_m > 0) return stated_m;
  return std::atof(std::string(storeys).c_str()) * kStorey_m;
}

void add_building(TownMap& map, Ring ring, double height_m) {
  ring = without_repeats(ring);
  if (ring.size() < 3 || signed_area_m2(ring) < kLeastFootprint_m2) return;
  map.buildings.push_back(std::move(ring));
  if (height_m > 0) map.heights_m.push_back(height_m);
}

void read_buildings(const source::OsmData& osm, const LocalMetres& metres, TownMap& map) {
  for (const source::Area& area : osm.areas) {
    const std::string_view building = osm.value_of(area.tags, "building");
    if (building.empty() || building == "no") continue;
    const double height_m = height_of(osm.value_of(area.tags, "height"), osm.value_of(area.tags, "building:levels"));
    for (const source::AreaRing& ring : osm.rings_of(area)) {
      if (!ring.is_outer) continue;
      Ring points;
      for (const source::Location& at : osm.points_of(ring)) points.push_back(metres(at));
      add_building(map, std::move(points), height_m);
    }
  }
}

void read_streets(const source::OsmData& osm, const LocalMetres& metres, TownMap& map) {
  for (const source::Way& way : osm.ways) {
    if (!is_car_street(osm.value_of(way.tags, "highway"))) continue;
    Polyline axis;
    for (const source::NodeRef& node : osm.nodes_of(way)) axis.push_back(metres(node.at));
    if (axis.size() > 1) map.streets.push_back(std::move(axis));
  }
}

std::string value_of_key(const invent::Tags& tags, std::string_view key) {
  for (const auto& [k, value] : tags)
    if (k == key) return value;
  return {};
}

// ---- measures

using CellKey = std::pair<int, int>;

CellKey density_cell_of(Vec2 p) {
  return {static_cast<int>(std::floor(p.x / kDensityCell_m)), static_cast<int>(std::floor(p.y / kDensityCell_m))};
}

// a street's length is counted in pieces of at most 8 m, each in the cell of its middle
void add_lengths(const Polyline& street, std::map<CellKey, double>& lengths_m) {
  for (std::size_t i = 0; i + 1 < street.size(); ++i) {
    const double whole_m = distance(street[i], street[i + 1]);
    const int pieces = 1 + static_cast<int>(whole_m / 8);
    for (int k = 0; k < pieces; ++k)
      lengths_m[density_cell_of(street[i] + (street[i + 1] - street[i]) * ((k + 0.5) / pieces))] += whole_m / pieces;
  }
}

TownValues street_densities(const TownMap& map) {
  std::map<CellKey, double> lengths_m;
  std::map<CellKey, std::size_t> buildings;
  for (const Polyline& street : map.streets) add_lengths(street, lengths_m);
  for (const Ring& ring : map.buildings) ++buildings[density_cell_of(ring[0])];
  TownValues densities;
  for (const auto& [cell, count] : buildings)
    if (count >= kBuiltUp) densities.push_back(lengths_m[cell] / 1000 / (kDensityCell_m * kDensityCell_m / 1e6));
  return densities;
}

TownValues degrees(const TownMap& map) {
  std::map<Vec2, int> arms;
  for (const Polyline& street : map.streets)
    for (std::size_t i = 0; i < street.size(); ++i) arms[street[i]] += i == 0 || i + 1 == street.size() ? 1 : 2;
  TownValues values;
  for (const auto& [place, count] : arms) {
    const double border_m = std::min({place.x - map.extent.min.x, map.extent.max.x - place.x,
                                      place.y - map.extent.min.y, map.extent.max.y - place.y});
    if (count != 2 && border_m > 20) values.push_back(std::min(count, 6));
  }
  return values;
}

parcels::Land land_of(const TownMap& map) {
  parcels::Land land;
  land.extent = map.extent;
  std::uint64_t number = 0;
  for (const Polyline& street : map.streets)
    land.lines.push_back({stable_id(StableId{0}, "street", number++), street, kStreetHalf_m, kStreetHalf_m,
                          parcels::LineKind::kStreet, 0, 0});
  for (const Ring& ring : map.buildings)
    land.footprints.push_back({stable_id(StableId{0}, "building", number++), ring});
  return land;
}

}  // namespace

Result<TownMap> read_town_map(const std::string& path, int threads) {
  Report report;
  const Result<source::OsmData> osm = source::read_osm(path, threads, report);
  if (!osm) return osm.error();
  TownMap map;
  map.name = std::filesystem::path(path).stem().stem().string();
  const LocalMetres metres = metres_about(osm->header_box.value_or(osm->node_box));
  read_streets(*osm, metres, map);
  read_buildings(*osm, metres, map);
  for (const Ring& ring : map.buildings)
    for (const Vec2 p : ring) map.extent.grow(p);
  if (map.extent.is_empty()) return Error{path, "has no building; the chart invented needs towns"};
  map.extent = {{std::floor(map.extent.min.x), std::floor(map.extent.min.y)},
                {std::ceil(map.extent.max.x), std::ceil(map.extent.max.y)}};
  return map;
}

TownMap town_map_of(const invent::InventedMap& invented, double side_m, std::string name) {
  TownMap map;
  map.name = std::move(name);
  const double half_m = std::floor(side_m / 2);
  map.extent = {{-half_m, -half_m}, {half_m, half_m}};
  for (const invent::InventedLine& line : invented.lines)
    if (is_car_street(value_of_key(line.tags, "highway"))) map.streets.push_back(line.axis);
  for (const invent::InventedArea& area : invented.areas)
    if (!value_of_key(area.tags, "building").empty())
      add_building(map, area.polygon.outer,
                   height_of(value_of_key(area.tags, "height"), value_of_key(area.tags, "building:levels")));
  return map;
}

std::vector<TownValues> measure_town(const TownMap& map, int threads) {
  std::vector<TownValues> values(static_cast<std::size_t>(TownMeasure::kCount));
  const auto of = [&](TownMeasure measure) -> TownValues& { return values[static_cast<std::size_t>(measure)]; };
  of(TownMeasure::kStreetDensity) = street_densities(map);
  of(TownMeasure::kDegree) = degrees(map);
  const parcels::Parcels parcels = parcels::divide(land_of(map), threads);
  for (const parcels::Block& block : parcels.blocks)
    if (const double block_m2 = area_m2(block.polygon); !block.is_at_extent && block_m2 < kLargestBlock_m2)
      of(TownMeasure::kBlockArea).push_back(block_m2);
  for (const parcels::Lot& lot : parcels.lots)
    if (!lot.footprints.empty()) of(TownMeasure::kLotFront).push_back(lot.frontage.length_m);
  for (const Ring& ring : map.buildings) of(TownMeasure::kFootprintArea).push_back(signed_area_m2(ring));
  of(TownMeasure::kHeight) = map.heights_m;
  for (TownValues& sample : values) std::ranges::sort(sample);
  return values;
}

double kolmogorov_distance(const TownValues& a, const TownValues& b) {
  if (a.empty() || b.empty()) return 1;
  double most = 0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double value = std::min(a[i], b[j]);
    while (i < a.size() && a[i] == value) ++i;
    while (j < b.size() && b[j] == value) ++j;
    most = std::max(most, std::abs(static_cast<double>(i) / static_cast<double>(a.size()) -
                                   static_cast<double>(j) / static_cast<double>(b.size())));
  }
  return most;
}

}  // namespace citykiln::charts
