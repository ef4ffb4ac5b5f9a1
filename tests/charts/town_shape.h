// The measures of a town's shape: streets, junctions, blocks, lots and buildings, of mapped and of invented towns.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/geometry/polygon.h"
#include "compiler/invent/invented_map.h"

namespace citykiln::charts {

/// Streets for cars and buildings, in metres about the middle of the map.
struct TownMap {
  std::string name;
  Box2 extent;
  std::vector<Polyline> streets;  ///< Streets meet where they share a point.
  std::vector<Ring> buildings;    ///< Counter-clockwise.
  std::vector<double> heights_m;  ///< One for each building whose storeys or height are stated.
};

/// The measures, each a distribution.
enum class TownMeasure { kStreetDensity, kDegree, kBlockArea, kLotFront, kFootprintArea, kHeight, kCount };

/// The values of a measure, sorted.
using TownValues = std::vector<double>;

/// Reads a map. Errors: those of source::read_osm().
Result<TownMap> read_town_map(const std::string& path, int threads);

/// Returns the streets and buildings of an invented map.
TownMap town_map_of(const invent::InventedMap& map, double side_m, std::string name);

/// Returns the values of all measures: kilometres of street a square kilometre in squares of 256 m with five buildings
/// or more; arms of junctions, and 1 for dead ends; areas of blocks up to 20 ha, fronts of lots with buildings
/// (parcels), and areas of footprints from 10 m²; heights at 3 m a storey. Cost: that of parcels/divide.h.
std::vector<TownValues> measure_town(const TownMap& map, int threads);

/// Returns the largest difference of the cumulative distributions of two sorted samples, 0 … 1 (Kolmogorov); 1 if one
/// sample is empty. O(n).
double kolmogorov_distance(const TownValues& a, const TownValues& b);

}  // namespace citykiln::charts
