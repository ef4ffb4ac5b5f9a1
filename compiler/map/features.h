// The map in the plane: every OSM element in use, once, with its tags read into numbers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/findings/assumption.h"
#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/countries/building_tradition.h"
#include "compiler/map/countries/country_group.h"
#include "compiler/map/cross_section.h"
#include "compiler/map/element_text.h"
#include "compiler/map/front_tags.h"
#include "compiler/map/lamps/lamp_tags.h"
#include "compiler/map/land_cover_class.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/map/plants/plant_kind.h"
#include "compiler/materials/material.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::map {

/// The side of the ground's cells. The extent and every tile consist of whole cells.
inline constexpr double kCell_m = 128;
/// The side of a tile unless the spec sets another.
inline constexpr double kDefaultTile_m = 8 * kCell_m;

/// A tagged colour, sRGB.
using Srgb = std::array<std::uint8_t, 3>;

/// Where a way runs: on the ground, on a bridge, or in a tunnel.
enum class Passage : std::uint8_t { kGround, kBridge, kTunnel };

/// The meaning of a marked node of a way.
enum class TrackPointKind : std::uint8_t {
  kZebra,          ///< A crossing with stripes along the road.
  kCrossing,       ///< A crossing marked otherwise, with signals, or unspecified.
  kSignals,        ///< Traffic signals for the road's own traffic.
  kStop,           ///< A stop sign.
  kGiveWay,        ///< A give-way sign.
  kLevelCrossing,  ///< Rails that cross a road or path; the tracks of both have the point.
  kTurningCircle,  ///< A turning circle without an island.
  kMiniRoundabout,
  kTurningLoop,    ///< A turning circle around an island.
  kPlainCrossing,  ///< A crossing on foot without paint.
  kHump,           ///< A hump or bump across the road.
  kSpeedTable,
  kSpeedCushions,  ///< Humps side by side with gaps, which buses drive over.
  kIsland,         ///< An island between the directions.
  kCount
};

/// Bits: what tags say of a crossing.
enum CrossingTrait : std::uint8_t {
  kLoweredKerb = 1,  ///< kerb=lowered: the kerb is a few centimetres high.
  kFlushKerb = 2,    ///< kerb=flush: it is as low as the carriageway.
  kRaisedKerb = 4,   ///< kerb=raised: it is as high as elsewhere.
  kTactileSlabs = 8,
  kNoTactileSlabs = 16,
  kCrossingIsland = 32,  ///< An island halfway.
};

/// A marked node of a track.
struct TrackPoint {
  std::uint32_t vertex = 0;  ///< Index into the track's axis.
  TrackPointKind kind{};
  std::int8_t facing = 0;  ///< 1 for traffic along the way, -1 against it, 0 for both or unknown.
  /// kLevelCrossing on rails: the length of rails on either side that the crossing ways cover, in quarters of a metre.
  /// Set by roads::roads_on_ground(), 0 before.
  std::uint8_t reach_quarters = 0;
  std::uint8_t traits = 0;  ///< Bits of CrossingTrait: what tags say of a crossing.
  auto operator<=>(const TrackPoint&) const = default;
};

/// Bits: the places of handrails on stairs, seen along the way.
enum Handrail : std::uint8_t { kHandrailLeft = 1, kHandrailRight = 2, kHandrailCentre = 4 };

/// A way to drive, walk or ride on: road, path, rail. One polyline per way, not split at junctions.
struct Track {
  ObjectId id;
  Polyline axis;                       ///< Plane metres, snapped, no repeated neighbours, at least two points.
  std::vector<std::int64_t> node_ids;  ///< The OSM node of each axis point.
  LandCoverClass surface{};
  std::int8_t layer = 0;
  Passage passage = Passage::kGround;
  bool is_oneway = false, is_lit = false, is_rail = false;
  bool is_roundabout = false;        ///< junction=roundabout or circular.
  bool is_link = false;              ///< A ramp or slip road: highway=*_link.
  bool is_through_building = false;  ///< By tunnel=building_passage, covered=*, level=*.
  bool is_covered = false;           ///< By tunnel=building_passage, covered=*, arcade=*: buildings leave it open.
  bool is_arcade = false;            ///< By covered=arcade or colonnade, arcade=*: open on its outer side.
  bool is_indoor = false;            ///< By indoor=*, highway=corridor, a level above or below the ground.
  bool has_tagged_layer = false;
  bool is_in_earthwork = false;       ///< By cutting=* or embankment=*: it lies below or above the land beside it.
  bool has_contact_line = false;      ///< Railways: by electrified=contact_line; tramways also by electrified=yes.
  std::uint16_t step_count = 0;       ///< Steps of stairs, by step_count=*; 0: untagged.
  std::uint8_t handrails = 0;         ///< Handrails of stairs: bits of Handrail.
  double clear_m = 0;                 ///< Height below what covers it, by maxheight=* or height=*; 0: untagged.
  std::vector<TrackPoint> points;     ///< Sorted. On a closed axis, points of the end node are at vertex 0 only.
  CrossSection section;               ///< Lanes from tags and defaults.
  bool has_tagged_width = false;      ///< True if tags state the carriageway's width; else it is the class's.
  bool has_tagged_placement = false;  ///< True if tags state where the axis lies in the carriageway; else the middle.
  bool is_transition = false;         ///< True for placement=transition.
  bool has_tagged_lighting = false;   ///< True if lit=* is tagged, also as "no".
  bool has_tagged_surface = false;    ///< True if surface=* is tagged.
  std::uint8_t tagged_pavements = 0;  ///< Sides on which tags say whether there is a pavement: bits of RoadSide.
  std::uint8_t fixed_pavements = 0;   ///< Sides on which tags state a pavement's width, or that there is none.
  std::uint8_t tagged_verges = 0;     ///< Sides on which tags say whether there is a verge.
  std::uint8_t tagged_parking = 0;    ///< Sides on which tags say whether cars park.
  std::uint8_t assumed_sides = 0;     ///< Sides on which a pavement or verge is assumed.
  std::uint8_t closed_sides = 0;      ///< Sides on which houses stand in a row along the street (assume/frontages.h).
  bool is_piece = false;              ///< True for a part of a way that was cut: for assumptions, or at a street.
  DrivingSide side{};                 ///< The side on which its traffic drives.
  TreeSides trees{};                  ///< Sides with trees; left and right as seen along the axis.
  PlantKind tree_kind{};              ///< The species of these trees; kUnknown: the usual ones of towns.
  CountryGroup country{};             ///< The group at its first node.
  Assumptions assumed = kNoAssumptions;  ///< The assumptions made of it.
};

/// The outline of a building, or of a building part.
struct Footprint {
  ObjectId id;
  Polygon polygon;
  bool is_part = false;
  /// The outline that a part, or an uncovered piece (buildings/uncovered_pieces.h), belongs to; nothing: none.
  std::optional<ObjectId> outline;
  bool has_parts = false;           ///< True for an outline that parts and uncovered pieces replace: it is not built.
  double height_m = 0;              ///< Height above the ground, by tags, levels or class. > min_height_m.
  bool has_roof_in_height = false;  ///< True if height_m includes the roof (height=*); else the roof comes on top.
  double min_height_m = 0;          ///< Height of its lower end above the ground.
  double levels = 0;                ///< Storeys below the roof, counted from the ground; 0: unknown.
  double min_levels = 0;            ///< Storeys below min_height_m where no tag states metres; 0: none.
  double storey_m = 0;              ///< Height of a storey, by its building's tags or class; 0: the class's.
  bool has_default_height = false;  ///< True if height_m is the class's default; false once storeys are assumed.
  bool is_open = false;             ///< True for a roof without walls.
  bool has_roof_shape = false;      ///< True if roof.form is tagged or assumed.
  roofs::RoofShape roof;            ///< The tagged values, levels as height; no overhang.
  std::optional<Srgb> wall_colour, roof_colour;
  std::optional<materials::Material> wall_material, roof_material;
  std::uint8_t building_class = 0;       ///< A BuildingClass.
  std::uint16_t year = 0;                ///< The year in which construction began; 0: unknown.
  std::int8_t layer = 0;                 ///< By layer=*, -10 to 10.
  bool has_tagged_layer = false;         ///< True if layer=* is tagged.
  bool has_shop = false;                 ///< True if something is sold or served in it.
  CountryGroup country{};                ///< The group at its first point.
  BuildingTradition tradition{};         ///< The tradition at its first point.
  Assumptions assumed = kNoAssumptions;  ///< The assumptions made of it.
  std::string style_name{};              ///< The rule file of a facade style, by citykiln:style=*; "": none.
};

/// The place where a way leads through a building on the ground. The building is open there, and the way's surface
/// replaces its floor.
struct Passageway {
  ObjectId building;  ///< The footprint.
  ObjectId way;
  Polyline axis;                   ///< Plane metres, snapped; from outside the walls to outside the walls.
  double left_m = 0, right_m = 0;  ///< From the axis to the sides of the opening; multiples of 2^-10, > 0.
  double clear_m = 0;              ///< Height above the way.
  /// An arcade is open on its outer side, beyond the wall; there pillars stand, this far from the axis. 0: none.
  double pillars_left_m = 0, pillars_right_m = 0;
  double least_m = 0;  ///< The clearance below which the way cannot be used.
  bool operator==(const Passageway&) const = default;
};

/// A polygon of land or water with one class.
struct AreaFeature {
  ObjectId id;
  Polygon polygon;  ///< Trimmed to the surroundings of the extent.
  LandCoverClass surface{};
  double area_m2 = 0;  ///< Area of the whole polygon, before trimming.
  PlantTags plant_tags{};
  std::uint8_t row_heading = 0;  ///< The direction of a field's rows (map/row_direction.h).
};

/// An area that is a bridge: a surface with bridge=yes, or the outline of a bridge (man_made=bridge).
struct BridgeArea {
  ObjectId id;
  Polygon polygon;
  LandCoverClass surface{};  ///< The class of its top; kUnknown for a mere outline.
  std::int8_t layer = 0;
  bool is_outline = false;         ///< True for man_made=bridge.
  std::vector<ObjectId> tracks{};  ///< The bridges that it carries: sorted ids of tracks, at least one after
                                   ///< with_bridge_areas().
};

/// An area where sports are played.
struct SportsArea {
  ObjectId id;         ///< The id of an AreaFeature.
  std::string sports;  ///< sport=*: values separated by ";"; "parking" for bays of car parks.
};

/// A river, stream, canal or ditch as a line.
struct Waterway {
  ObjectId id;
  Polyline axis;
  double width_m = 0;
  /// The range in which the width grows downstream (ground/water/grown_widths.h); both 0 if it is tagged.
  double least_width_m = 0, most_width_m = 0;
  std::int8_t layer = 0;
  Passage passage = Passage::kGround;
};

/// The form of a barrier.
///
/// Lines of the map are never kRailing: these are assumed along drops (things/railings.h).
enum class BarrierKind : std::uint8_t { kWall, kFence, kHedge, kRetainingWall, kGuardRail, kCityWall, kRailing, kKerb };
/// The number of kinds.
inline constexpr std::size_t kBarrierKinds = 8;

/// The name of a kind in output files, such as "RetainingWall".
constexpr std::string_view name_of(BarrierKind kind) {
  constexpr std::string_view kNames[] = {"Wall",      "Fence",    "Hedge",   "RetainingWall",
                                         "GuardRail", "CityWall", "Railing", "Kerb"};
  return kNames[static_cast<std::size_t>(kind)];
}

/// The build of a fence. Fences of the map are kAny: bars up to props::kMaxRailingFence_m, boards above, mesh
/// from props::kLeastWorksFence_m on.
enum class FenceKind : std::uint8_t { kAny, kBoards, kPickets, kMesh };

/// A wall, fence, hedge or similar as a line.
struct Barrier {
  ObjectId id;
  Polyline axis;  ///< Plane metres, snapped.
  BarrierKind kind{};
  double height_m = 0, width_m = 0;
  FenceKind fence = FenceKind::kAny;  ///< The build of a kFence.
  bool operator==(const Barrier&) const = default;
};

/// The form of the land that an object makes.
enum class LandformKind : std::uint8_t {
  kWall,   ///< A retaining wall: the land is higher on one side.
  kStep,   ///< A cliff or bank: a step without a wall.
  kRidge,  ///< A dyke: a crest with slopes on both sides.
  kDam,    ///< A dam across a valley.
  kDeck    ///< A pier, breakwater, quay or weir: level, above water.
};

/// A line along which the land is shaped.
struct Landform {
  ObjectId id;
  Polyline axis;
  LandformKind kind{};
  double height_m = 0;      ///< Above the foot, the ground or the water; 0: as the terrain rises.
  bool has_height = false;  ///< True if height_m is tagged; else it is the kind's.
  double width_m = 0;       ///< Width of its top, or thickness of a wall or cliff.
  LandCoverClass surface = LandCoverClass::kUnknown;  ///< On its top; kUnknown: the land cover about it.
};

/// The form of a point object.
enum class PointKind : std::uint8_t {
  kTree,  ///< A tree or shrub.
  kStreetLamp,
  kShop,      ///< A shop, a place where something is served, an office, a workshop.
  kEntrance,  ///< A building's entrance.
  kAddress    ///< A house number.
};

/// An object that is mapped as a point.
struct PointFeature {
  ObjectId id;
  Vec2 at;
  PointKind kind{};
  double height_m = 0;     ///< 0: untagged.
  PlantTags plant_tags{};  ///< Tags of trees and shrubs.
  LampTags lamp_tags{};    ///< Tags of street lamps.
  /// The front of a shop, restaurant, office or workshop, also where it is an entrance or an address too.
  std::optional<FrontTags> front{};
};

/// The way that a thing's node belongs to.
struct ThingWay {
  ObjectId id;  ///< OsmType::kNone: none.
  Vec2 along;   ///< Its direction there, or a power line's, or across a fence; length 1.
  LandCoverClass surface{};
  DrivingSide side{};
  Passage passage = Passage::kGround;
  bool is_oneway = false;
  bool is_nearer_to_end = false;  ///< True if the end of the way is nearer to the node than its start.
};

/// Bits: the equipment of a stop of buses or trams.
enum StopEquipment : std::uint8_t { kStopShelter = 1, kStopBench = 2, kStopBin = 4 };

/// A thing, by a row of the table of things (things/thing_table.h): a point, or a part of a line or an area.
struct ThingFeature {
  ObjectId id;
  Vec2 at;
  std::string kind;   ///< The name of its row.
  std::string value;  ///< The value of the tag that the row tests first.
  double width_m = 0, depth_m = 0, height_m = 0;
  std::optional<Vec2> along{};  ///< The direction of its width if its line or area says it; length 1.
  std::optional<Srgb> colour{};
  std::string material{};               ///< material=*, by thing_materials.inc; other words in lower case.
  std::string text{};                   ///< Digits that it shows, such as those of maxspeed=*.
  std::uint16_t capacity = 0;           ///< 0: untagged.
  std::uint8_t stop_has = 0;            ///< Bits of StopEquipment, by shelter=yes, bench=yes, bin=yes of stops.
  std::optional<double> bearing_deg{};  ///< direction=*, clockwise of north.
  std::int8_t facing = 0;               ///< 1 if it is for traffic along its way, -1 against it, 0 unknown.
  ThingWay way{};
  CountryGroup country{};
  bool is_in_way = false;   ///< True if it may stand in a carriageway, by its row.
  bool is_on_roof = false;  ///< True if tags say that it stands on a roof, whatever its row says.
  bool has_height = false;  ///< True if height_m is tagged; else it is that of its row.
  double min_height_m = 0;  ///< min_height=*, the height of its lower end above the ground; 0: untagged.
  /// The direction that equipment of a sports pitch or a parked car faces, length 1; it is not moved.
  std::optional<Vec2> faces{};
};

/// A front that buildings are to have (buildings/planning/fronts.h).
struct FrontPoint {
  ObjectId id;  ///< The point's; of an assumed front, the footprint's.
  Vec2 at;      ///< In, or beside, its building.
  FrontTags tags;
  bool is_assumed = false;
};

/// A line of trees.
struct TreeRow {
  ObjectId id;
  Polyline axis;
  double height_m = 0;   ///< 0: untagged.
  double spacing_m = 0;  ///< 0: untagged.
  PlantTags plant_tags{};
};

/// The class of a line in the air: power=line hangs on pylons, power=minor_line on poles; an aerialway has cables.
enum class PowerLineKind : std::uint8_t { kLine, kMinorLine, kAerialway };

/// A power line or an aerialway. Tall trees below it are cleared.
struct PowerLine {
  ObjectId id;
  Polyline axis;
  double corridor_m = 0;  ///< The width of the cleared corridor.
  PowerLineKind kind{};
  std::vector<std::int64_t> node_ids{};  ///< The OSM node of each axis point.
  std::uint8_t cables = 0;               ///< Conductors, by cables=* or three for each of circuits=*; 0: untagged.
  std::uint8_t bundle = 0;               ///< Wires of one conductor, by wires=*; 0: untagged.
  double voltage_kv = 0;                 ///< The highest of voltage=*; 0: untagged.
};

/// All features, each vector of objects sorted by id. Mapped coordinates are multiples of kMapStep_m, computed ones of
/// kQuantum_m.
struct Features {
  Box2 extent;  ///< The extent of the compile: the cells of 128 m that contain the requested box.
  std::vector<Track> tracks;
  std::vector<Footprint> footprints;
  std::vector<AreaFeature> areas;  ///< Includes the sea, closed around the extent.
  std::vector<SportsArea> sports_areas{};
  std::vector<BridgeArea> bridge_areas{};
  std::vector<Polyline> coasts{};  ///< Coastlines as mapped, also beyond the extent; the sea is on their right.
  std::vector<Waterway> waterways;
  std::vector<Barrier> barriers;
  std::vector<Landform> landforms;
  std::vector<PointFeature> points;
  std::vector<ThingFeature> things{};
  /// Things outside of the extent that are nodes of power lines: wires hang on them, but they are not built.
  std::vector<ThingFeature> supports_beyond{};
  std::vector<TreeRow> tree_rows;
  std::vector<PowerLine> power_lines;
  std::vector<ElementText> texts{};  ///< Names and tags of the features' elements, sorted by id.
};

/// The features that a stage reads: lists of the map, or lists that an earlier stage has made in their place. Refers to
/// the lists, which must outlive it.
struct FeatureView {
  Box2 extent;
  std::span<const Track> tracks;
  std::span<const Footprint> footprints;
  std::span<const AreaFeature> areas;
  std::span<const SportsArea> sports_areas;
  std::span<const BridgeArea> bridge_areas;
  std::span<const Waterway> waterways;
  std::span<const Barrier> barriers;
  std::span<const Landform> landforms;
  std::span<const PointFeature> points;
  std::span<const ThingFeature> things;
  std::span<const ThingFeature> supports_beyond;
  std::span<const FrontPoint> fronts{};  ///< Sorted by id, then by position. None unless they are assumed.
  std::span<const TreeRow> tree_rows;
  std::span<const PowerLine> power_lines;

  FeatureView(const Features& map)  // NOLINT: implicit, so that the map as it is can be read
      : extent(map.extent),
        tracks(map.tracks),
        footprints(map.footprints),
        areas(map.areas),
        sports_areas(map.sports_areas),
        bridge_areas(map.bridge_areas),
        waterways(map.waterways),
        barriers(map.barriers),
        landforms(map.landforms),
        points(map.points),
        things(map.things),
        supports_beyond(map.supports_beyond),
        tree_rows(map.tree_rows),
        power_lines(map.power_lines) {}
};

}  // namespace citykiln::map
