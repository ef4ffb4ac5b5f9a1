// A building: a footprint between two heights, a roof over it, and the style of its walls.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/features.h"
#include "compiler/materials/material.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::buildings {

/// Rows of styles.inc: the rules by which walls become facades. The order is part of the manifest's format: add at the
/// end.
enum class Style : std::uint8_t {
#define STYLE(name, rules) name,
#include "compiler/buildings/styles.inc"
#undef STYLE
  kCount
};

inline constexpr std::uint32_t kDoorSlots = 16;

/// What lies before the wall over an edge of the outer ring, from its vertex to the next.
struct FacadeEdge {
  bool faces_street = false;
  std::uint8_t buried_storeys = 0;  ///< Counted from the floor: the ground along the wall is so high.
  /// Where doors are told to be: bit i says in the i-th of kDoorSlots equal parts of the edge.
  std::uint16_t doors = 0;
  bool operator==(const FacadeEdge&) const = default;
};

/// A stretch of a wall that another building stands against.
struct PartyWall {
  std::uint32_t edge = 0;       ///< Of the outer ring.
  double from_m = 0, to_m = 0;  ///< Along it. from_m < to_m. Snapped.
  double top_m = 0;             ///< Up to where the other wall goes; it begins no higher than this building. Snapped.
  bool is_hidden = false;       ///< The two are one plane: nothing can be seen between them.
  bool has_windows_above = false;  ///< Both are parts of one building.
  bool operator==(const PartyWall&) const = default;
};

struct Building {
  ObjectId id;
  Polygon footprint;             ///< Plane metres, snapped. Where stands_on_ground, a surface of class kBuilding too.
  double bottom_m = 0;           ///< Lower end of the walls: under the lowest ground for what stands on it. Snapped.
  double floor_m = 0;            ///< From where storeys count. bottom_m <= floor_m <= eaves. Snapped.
  double top_m = 0;              ///< Of the highest point. > bottom_m. Snapped.
  bool stands_on_ground = true;  ///< False where min_height lifts it.
  materials::Material wall{}, roof{};
  std::optional<map::Srgb> wall_colour, roof_colour;  ///< As tagged; else the material's, varied by the seed.
  /// Its height is decided: 0 where flat, else to the top from the eaves, where walls end. Direction and lengths are
  /// snapped; neither angle nor levels.
  roofs::RoofShape roof_shape;
  Style style{};
  std::uint8_t building_class = 0;  ///< A map::BuildingClass.
  std::uint8_t levels = 1;          ///< Storeys between floor and eaves, at least 1.
  std::uint16_t year = 0;           ///< 0: nobody says.
  bool has_shop = false;
  std::vector<FacadeEdge> fronts{};      ///< One an edge of the outer ring; none where nothing is to be said of any.
  std::vector<PartyWall> party_walls{};  ///< Sorted by edge, then from_m; of one edge they do not overlap.
  bool operator==(const Building&) const = default;
};

inline double eaves_m(const Building& building) { return building.top_m - building.roof_shape.height_m; }
inline double storey_m(const Building& building) { return (eaves_m(building) - building.floor_m) / building.levels; }

}  // namespace citykiln::buildings
