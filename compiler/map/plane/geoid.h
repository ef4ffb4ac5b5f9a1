// Heights of the geoid above the ellipsoid. Heightmaps and OSM state heights above sea level, which is the geoid; 3D
// Tiles need heights above the ellipsoid.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/geometry/box.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::map {

/// The geoid over a box of the plane: heights above the ellipsoid at the points of a grid, interpolated bilinearly.
/// Beyond the grid, the nearest height on its border applies. Heights are multiples of kQuantum_m; their number is a
/// multiple of `columns`.
struct Geoid {
  Vec2 low;                             ///< The first point, plane metres.
  double step_m = 1;                    ///< > 0.
  std::size_t columns = 1;              ///< Points along x.
  std::vector<double> heights_m = {0};  ///< Row by row from the south, each from west to east.
  bool operator==(const Geoid&) const = default;
};

/// The source of the geoid's heights.
struct GeoidSource {
  std::string name;                 ///< The given text, which outputs state: a height, or the path of a grid.
  std::optional<double> level_m{};  ///< One height everywhere; empty for a grid of GeographicLib's Geoid class.
  bool operator==(const GeoidSource&) const = default;
};

/// Parses a height in metres, "47.3", or the path of a grid of GeographicLib, such as egm96-5.pgm. Error: another text.
Result<GeoidSource> parse_geoid(std::string_view text);

/// The grid step of the result of read_geoid(). GeographicLib's own grids have steps of 1' (1.8 km) or more.
inline constexpr double kGeoidStep_m = 1024;

/// Returns the height of the geoid above the ellipsoid at a point of the plane, metres.
double height_m(const Geoid& geoid, Vec2 p);

/// Returns the geoid over a box of the plane, widened by kGeoidStep_m on each side.
///
/// @param source  Grids are interpolated cubically. Empty for height 0.
///
/// Errors: a file that cannot be read as such a grid. Every CPU gives the same bytes, except for heights that fall on a
/// tie of kQuantum_m.
Result<Geoid> read_geoid(const std::optional<GeoidSource>& source, const Box2& box, const Plane& plane);

}  // namespace citykiln::map
