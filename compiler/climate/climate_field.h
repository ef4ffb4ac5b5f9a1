// The climate of an extent: classes at the nodes of a grid of the plane, and between them by interpolation. Part of the
// manifest, so that a tile needs neither the table of the Earth nor a map projection.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/climate/climate_mix.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/lonlat.h"

namespace citykiln::climate {

/// The spacing of the grid in metres. A cell of the table is half a degree, 55 km from north to south, so three nodes
/// cross it.
inline constexpr double kNodeSpacing_m = 16384;

/// Up to four classes of a node, in units of 1/255, which add up to 255. Unused entries have share 0.
struct ClimateNode {
  std::array<ClimateClass, 4> classes{};
  std::array<std::uint8_t, 4> shares{};
  bool operator==(const ClimateNode&) const = default;
};

/// The classes of an extent. A node's classes depend on its place alone.
struct ClimateField {
  ClimateClass origin_class{};  ///< The class at the plane's origin. Season, snow and leaf colours follow it.
  std::int32_t first_column = 0, first_row = 0;  ///< The first node is at these multiples of kNodeSpacing_m.
  std::int32_t columns = 0;
  std::vector<ClimateNode> nodes;  ///< Rows of `columns` nodes from south to north.
  bool operator==(const ClimateField&) const = default;
};

/// Returns the climate of an extent widened by 1024 m, in metres of the plane. Cost: one climate_mix_at() a node.
/// @param degrees_of  The longitude and latitude of a point of the plane.
ClimateField make_climate_field(const Box2& extent, const std::function<LonLat(Vec2)>& degrees_of);

/// Returns a field that is one class everywhere.
ClimateField uniform_climate(ClimateClass climate);

/// True if climate_mix_at() can read the field: known classes, shares that add up to 255, complete rows, and at most
/// 1024 rows and columns. For fields read from a file.
bool is_sound(const ClimateField& field);

/// Returns the classes at a point of the plane, by bilinear interpolation; beyond the grid those of its edge.
/// @param field  is_sound() holds.
ClimateMix climate_mix_at(const ClimateField& field, Vec2 at);

}  // namespace citykiln::climate
