// The map in the plane: every OSM element that citykiln draws, once, with its tags already read into numbers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/heightfield.h"
#include "compiler/map/land_cover_class.h"
#include "compiler/map/lanes/lanes.h"
#include "compiler/map/plant_kind.h"
#include "compiler/materials/material.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::map {

/// A colour as tags give it, sRGB.
using Srgb = std::array<std::uint8_t, 3>;

enum class Passage : std::uint8_t { kGround, kBridge, kTunnel };

/// What a node says about the ways through it.
enum class TrackPointKind : std::uint8_t {
  kZebra,          ///< A crossing striped along the road.
  kCrossing,       ///< Marked otherwise, with signals, or nobody says how.
  kSignals,        ///< Of the road's own traffic.
  kStop,           ///< A stop sign.
  kGiveWay,        ///< A sign to give way.
  kLevelCrossing,  ///< Rails and a road or path; on the tracks of both.
  kTurningCircle,  ///< Room to turn, round or with an island.
  kMiniRoundabout,
  kCount
};

/// A node of a track with something to say.
struct TrackPoint {
  std::uint32_t vertex = 0;  ///< Of the track's axis.
  TrackPointKind kind{};
  std::int8_t facing = 0;  ///< For those who go along the way 1, against it -1, both or untold 0.
  auto operator<=>(const TrackPoint&) const = default;
};

/// A way to drive, walk or ride on: road, path, rail. One polyline a way, not split at junctions.
struct Track {
  ObjectId id;
  Polyline axis;                       ///< Plane metres, snapped, no repeated neighbours, at least two points.
  std::vector<std::int64_t> node_ids;  ///< OSM node of each axis point.
  LandCoverClass surface{};
  std::int8_t layer = 0;
  Passage passage = Passage::kGround;
  bool is_oneway = false, is_lit = false, is_rail = false;
  bool is_roundabout = false;      ///< junction=roundabout or circular.
  bool is_link = false;            ///< A ramp or slip road: highway=*_link.
  std::vector<TrackPoint> points;  ///< Sorted. Those of a closed axis at its first vertex, once.
  CrossSection section;            ///< As the tags tell it.
  DrivingSide side{};              ///< Of its traffic.
  TreeSides trees{};               ///< Left and right along the axis.
};

/// A building's outline, or a part of one.
struct Footprint {
  ObjectId id;
  Polygon polygon;
  bool is_part = false;
  bool has_parts = false;           ///< An outline that building:parts replace: not drawn.
  double height_m = 0;              ///< Above the ground; tags, else levels, else class. > min_height_m.
  bool has_roof_in_height = false;  ///< Of the highest point, as height=* tells it; else the roof comes on top.
  double min_height_m = 0;
  double levels = 0;            ///< Storeys below the roof, from the ground up; 0: nobody says.
  bool has_roof_shape = false;  ///< Whether the roof's form is.
  roofs::RoofShape roof;        ///< As far as it is told; levels as height, no overhang.
  std::optional<Srgb> wall_colour, roof_colour;
  std::optional<materials::Material> wall_material, roof_material;
  std::uint8_t building_class = 0;  ///< A BuildingClass of building_classes.h.
  std::uint16_t year = 0;           ///< In which it was begun; 0: nobody says.
  bool has_shop = false;            ///< Something is sold or served in it.
};

/// A piece of land or water with one class.
struct AreaFeature {
  ObjectId id;
  Polygon polygon;  ///< Trimmed to what is near the region.
  LandCoverClass surface{};
  double area_m2 = 0;  ///< Of the whole.
  PlantTags plant_tags{};
};

/// A river, stream, canal or ditch as a line.
struct Waterway {
  ObjectId id;
  Polyline axis;
  double width_m = 0;
  std::int8_t layer = 0;
  Passage passage = Passage::kGround;
};

enum class BarrierKind : std::uint8_t { kWall, kFence, kHedge, kRetainingWall, kGuardRail, kCityWall };

struct Barrier {
  ObjectId id;
  Polyline axis;
  BarrierKind kind{};
  double height_m = 0, width_m = 0;
};

enum class PointKind : std::uint8_t {
  kTree,  ///< Or a shrub.
  kStreetLamp,
  kBench,
  kBollard,
  kPost,
  kFountain,
  kHydrant,
  kWasteBasket,
  kMast,
  kChimney,
  kFlagpole,
  kShop,      ///< Or another place where one is served.
  kEntrance,  ///< Of a building.
  kAddress    ///< A house number.
};

struct PointFeature {
  ObjectId id;
  Vec2 at;
  PointKind kind{};
  double height_m = 0;     ///< 0: not tagged.
  PlantTags plant_tags{};  ///< Trees and shrubs.
};

/// Trees in a line.
struct TreeRow {
  ObjectId id;
  Polyline axis;
  double height_m = 0;   ///< 0: not tagged.
  double spacing_m = 0;  ///< Likewise.
  PlantTags plant_tags{};
};

/// A line above the ground, below which no tall trees are let grow.
struct PowerLine {
  ObjectId id;
  Polyline axis;
  double corridor_m = 0;  ///< How wide the lane is in which none stand.
};

/// Everything citykiln draws, each vector sorted by id, all coordinates snapped to 2^-10 m.
struct Features {
  Box2 region;  ///< What is compiled: whole cells of 128 m around the box asked for.
  std::vector<Track> tracks;
  std::vector<Footprint> footprints;
  std::vector<AreaFeature> areas;  ///< Sea included, closed along the region.
  std::vector<Waterway> waterways;
  std::vector<Barrier> barriers;
  std::vector<PointFeature> points;
  std::vector<TreeRow> tree_rows;
  std::vector<PowerLine> power_lines;
};

}  // namespace citykiln::map
