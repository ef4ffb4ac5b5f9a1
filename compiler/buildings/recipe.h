// The recipe of a building: a footprint extruded between two heights, with a roof and a facade style. A snapped
// coordinate is rounded to the grid of the plane, 2^-10 m.
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

/// The facade styles, one per row of styles.inc, which names the rule file that generates the facade. The order is part
/// of the manifest format: append only.
enum class Style : std::uint8_t {
#define STYLE(name, rules) name,
#include "compiler/buildings/styles.inc"
#undef STYLE
  kCount
};

/// The number of equal parts of an edge in which door positions are stored.
inline constexpr std::uint32_t kDoorSlots = 16;

/// The attributes of one edge of the outer ring, from its vertex to the next.
struct FacadeEdge {
  bool faces_street = false;
  /// The number of storeys, from the floor up, that lie below the ground along the edge, or along its beginning.
  std::uint8_t buried_storeys = 0;
  std::uint16_t doors = 0;  ///< Bit i: a door in the i-th of kDoorSlots equal parts of the edge.
  bool operator==(const FacadeEdge&) const = default;
};

/// A place on an edge where the number of buried storeys changes: it holds up to the next one, or to the edge's end.
struct BuriedFrom {
  std::uint32_t edge = 0;  ///< Index into the outer ring.
  double from_m = 0;       ///< Distance along the edge, > 0. Snapped.
  std::uint8_t storeys = 0;
  bool operator==(const BuriedFrom&) const = default;
};

/// A part of an edge along which another building is adjacent.
struct PartyWall {
  std::uint32_t edge = 0;       ///< Index into the outer ring.
  double from_m = 0, to_m = 0;  ///< Distances along the edge, from_m < to_m. Snapped.
  /// The height of the neighbour's eaves. The neighbour's walls begin no higher than this building's walls. Snapped.
  double top_m = 0;
  bool is_hidden = false;  ///< Both walls lie in one plane, so neither is visible.
  /// The wall above top_m has windows, since both buildings are parts of one building.
  bool has_windows_above = false;
  bool operator==(const PartyWall&) const = default;
};

/// Places of fronts along an edge are whole multiples of this.
inline constexpr double kFrontStep_m = 0.125;

/// A shop front: a part of the ground floor of an edge.
struct Front {
  std::uint32_t edge = 0;       ///< Index into the outer ring.
  double from_m = 0, to_m = 0;  ///< Distances along the edge, from_m < to_m. Whole multiples of kFrontStep_m.
  map::FrontKind kind{};
  std::optional<map::FrontHours> hours{};  ///< Set if tagged; else those of the kind count.
  bool is_assumed = false;
  bool operator==(const Front&) const = default;
};

/// The opening for a way that leads through a building on the ground (map::Passageway): everything below top_m, between
/// the sides of a strip along the axis.
struct Passageway {
  ObjectId way;
  Polyline axis;                                   ///< Plane metres, snapped, at least two points.
  double left_m = 0, right_m = 0;                  ///< From the axis to the sides. Snapped, their sum > 0.
  double top_m = 0;                                ///< The height of the ceiling. Snapped.
  double pillars_left_m = 0, pillars_right_m = 0;  ///< From the axis to the pillars of an arcade; 0: none. Snapped.
  bool operator==(const Passageway&) const = default;
};

/// The recipe of a building or building part.
struct Building {
  ObjectId id;
  Polygon footprint;             ///< Plane metres, snapped.
  double bottom_m = 0;           ///< The lower end of the walls, below the lowest ground if stands_on_ground. Snapped.
  double floor_m = 0;            ///< The height from which storeys count. bottom_m <= floor_m <= eaves. Snapped.
  double top_m = 0;              ///< The highest point of the roof. > bottom_m. Snapped.
  bool stands_on_ground = true;  ///< False if min_height lifts it off the ground, and for roofs without walls.
  materials::Material wall{}, roof{};
  /// The tagged colours; if unset, the colour of the material, varied by the seed.
  std::optional<map::Srgb> wall_colour, roof_colour;
  /// The roof. height_m is the rise from the eaves to top_m, 0 for flat roofs; angle and levels are not set. Snapped.
  roofs::RoofShape roof_shape;
  Style style{};
  std::uint8_t building_class = 0;  ///< A map::BuildingClass.
  std::uint8_t levels = 1;          ///< Storeys between floor and eaves, at least 1.
  std::uint16_t year = 0;           ///< Year of construction; 0 if unknown.
  bool has_shop = false;
  map::CountryGroup country{};
  Assumptions assumed = kNoAssumptions;    ///< The assumptions made of it.
  std::vector<FacadeEdge> facade_edges{};  ///< One per edge of the outer ring, or empty.
  std::vector<BuriedFrom> buried_from{};   ///< On long edges along a slope. Sorted by edge, then from_m.
  std::vector<PartyWall> party_walls{};    ///< Sorted by edge, then from_m. No two overlap.
  std::vector<Vec2> posts{};               ///< Centres of the posts below bottom_m (posts.h), snapped.
  double post_foot_m = 0;                  ///< The lower end of the posts, below the ground. Snapped. 0: no posts.
  std::vector<Passageway> passageways{};   ///< Sorted by way. They may overlap.
  std::vector<Front> fronts{};             ///< Sorted by edge, then from_m. No two overlap.
  bool operator==(const Building&) const = default;
};

/// Returns the height of the eaves, plane metres.
inline double eaves_m(const Building& building) { return building.top_m - building.roof_shape.height_m; }
/// Returns the height of one storey.
inline double storey_m(const Building& building) { return (eaves_m(building) - building.floor_m) / building.levels; }

}  // namespace citykiln::buildings
