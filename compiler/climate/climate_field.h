// The climate of an extent: classes at the nodes of a grid of the plane, and between them by interpolation. Part of the
// manifest, so that a tile needs neither the table of the Earth nor a map projection.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/climate/climate_mix.h"
#include "compiler/geometry/box.h"

namespace citykiln::climate {

/// The spacing of the grid, in metres: less than a third of half a degree, over which classes change.
inline constexpr double kNodeSpacing_m = 16384;

/// Up to four classes of a node, in units of 1/255, which add up to 255. Unused entries have share 0.
struct ClimateNode {
  std::array<ClimateClass, 4> classes{};
  std::array<std::uint8_t, 4> shares{};
  bool operator==(const ClimateNode&) const = default;
};

/// The classes of an extent. A node's classes depend on its place alone.
struct ClimateField {
  ClimateClass own{};                            ///< The class of the plane's origin, which decides the season.
  std::int32_t first_column = 0, first_row = 0;  ///< The first node is at these multiples of kNodeSpacing_m.
  std::int32_t columns = 0;
  std::vector<ClimateNode> nodes;  ///< Rows of `columns` nodes from south to north.
  bool operator==(const ClimateField&) const = default;
};

struct Degrees {
  double lon = 0, lat = 0;
};

/// Returns the climate of an extent.
/// @param degrees_of  The longitude and latitude of a point of the plane.
ClimateField make_climate_field(const Box2& extent, const std::function<Degrees(Vec2)>& degrees_of);

/// Returns a field that is one class everywhere.
ClimateField uniform_climate(ClimateClass climate);

/// True if a field is one that make_climate_field() can return: for fields read from a file.
bool is_sound(const ClimateField& field);

/// Returns the classes at a point of the plane, by bilinear interpolation; beyond the grid those of its edge.
/// @param field  is_sound() holds.
ClimateMix climate_mix_at(const ClimateField& field, Vec2 at);

}  // namespace citykiln::climate
