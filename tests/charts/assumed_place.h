// Leaves tags of a map out and assumes again what they say, for the chart of assumptions.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "compiler/contract/findings/assumption.h"
#include "compiler/contract/result.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/map/plane/plane.h"
#include "compiler/source/osm_data.h"
#include "compiler/source/raster.h"

namespace citykiln::charts {

/// The kind of tags or elements that is left out of a map.
enum class LeftOut : std::uint8_t {
  kPavements,  ///< sidewalk=*, with all its sides.
  kLamps,      ///< lit=* and street lamps.
  kWidths,     ///< width=*, est_width=*, width:lanes=*.
  kHeights,    ///< Heights and storeys of buildings and of their roofs.
  kCourts,     ///< Small areas of grass and paving: their class becomes kUnknown.
  kFields,     ///< Borders between neighbouring fields (assumed_lands.h), in all of the map.
  kTrees,      ///< Trees, rows of trees and tree_lined=*.
  kHedges,     ///< Hedges.
  kFrontages   ///< Small areas of grass and paving, in all of the map: their class becomes kUnknown.
};

/// True for elements whose tags are left out.
using IsOut = std::function<bool(OsmId)>;

/// A map whose tags are known.
struct Place {
  std::string name;  ///< The name of the file, without endings.
  source::OsmData osm;
  source::LonLatBox box;
  LonLat origin;
  map::Features mapped;  ///< The features by their tags, without assumptions.
  map::Heightfield heights;
};

/// Makes the class of areas of LeftOut::kCourts unknown.
void hide_courts(map::Features& features, const IsOut& is_out);
/// Makes the class of all areas of LeftOut::kFrontages unknown.
void hide_frontages(map::Features& features);

/// Reads a map. Its land is level where none of the heightmaps covers it. Errors: those of source::read_osm().
Result<Place> read_place(const std::string& path, std::span<const source::Raster> heightmaps, int threads);

/// Returns the features of a place without what is left out, with assumptions, and with widths fitted as in a compile.
/// Fields, and hedges beside roads, are assumed only where borders of fields or hedges are left out.
/// @param on  The assumptions; none: what is built where nothing is assumed.
map::Features guessed(const Place& place, LeftOut kind, const IsOut& is_out, Assumptions on);

}  // namespace citykiln::charts
