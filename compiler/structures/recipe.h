// Recipes of bridges and tunnels. A recipe is plain data from which a mesh is generated later. A span is one bridge or
// one tunnel: the whole length of an OSM way that leaves the ground.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::structures {

/// The way in which a span ends.
enum class EndKind : std::uint8_t {
  kFree,        ///< No track continues: cut square to the axis.
  kGround,      ///< On the ground, where one road continues the span: cut square to that road.
  kBesideRoad,  ///< On the ground, at a road that passes: cut square to the axis, at that road's edge.
  kJoint,       ///< Another span of its kind continues: both are mitred.
  kCount
};

/// One end of a span.
struct SpanEnd {
  EndKind kind{};
  Vec2 beyond{};     ///< kGround, kJoint: the next point of the road or span that continues. Plane metres, snapped.
  double cut_m = 0;  ///< kBesideRoad: length of the axis inside that road; a multiple of 1/4 m, below 64.
  bool operator==(const SpanEnd&) const = default;
};

/// Columns or a wall under a deck, square to its axis.
struct Pier {
  double at_m = 0;    ///< Distance from the beginning of the way; a multiple of 1/4 m.
  double foot_m = 0;  ///< Plane height of its lower end, which is below the ground; a multiple of 1/4 m.
  bool operator==(const Pier&) const = default;
};

/// A part of a deck's edge without parapet.
struct ParapetGap {
  double from_m = 0, to_m = 0;  ///< Distances from the beginning of the way; multiples of 1/4 m, from_m < to_m.
  bool operator==(const ParapetGap&) const = default;
};

/// A corner of a plate's ring.
struct PlateCorner {
  Vec3 at;                ///< Plane metres; the height of the top, a multiple of kProfileQuantum_m.
  bool has_wall = false;  ///< True if a parapet or railing stands on the edge to the next corner.
  bool operator==(const PlateCorner&) const = default;
};
/// A part of a plate: a polygon with heights.
struct PlatePart {
  std::vector<std::vector<PlateCorner>> rings;  ///< The outer ring first.
  bool is_below_road = false;                   ///< True if the road of a bridge that the plate carries lies on it.
  bool operator==(const PlatePart&) const = default;
};
/// A deck that the map has as an area. It carries one or more bridges, and is stored with the first of them.
struct Plate {
  OsmId id;
  map::LandCoverClass surface{};  ///< kUnknown: concrete.
  std::vector<PlatePart> parts;   ///< Together the whole area.
  bool operator==(const Plate&) const = default;
};

/// The thing that a bridge's road lies on.
enum class DeckForm : std::uint8_t {
  kOwn,    ///< A slab as wide as the road.
  kPlate,  ///< A plate, between the lanes of other bridges.
  kNone,   ///< The line is only the axis of a plate: it has no road.
  kCount
};

/// A bridge or a tunnel: its road over the whole length of the way. The profile states the height of the road's top.
struct Span : roads::Road {
  SpanEnd from{}, to{};                               ///< At the first and the last point of the axis.
  std::vector<Pier> piers{};                          ///< Bridges: sorted by at_m, unique.
  std::vector<ParapetGap> left_gaps{}, right_gaps{};  ///< Bridges: sorted, disjoint.
  bool is_bored = false;  ///< Tunnels: true if the tunnel lies under the terrain (is_underground() in tunnel.h). Others
                          ///< have no mesh.
  DeckForm deck{};        ///< Bridges.
  std::vector<Plate> plates{};  ///< Bridges: the plates that are stored with it, mostly none.
  std::int8_t layer = 0;  ///< The layer tag, -10 to 10. Where two spans cross, the one with the higher layer is above.
  bool operator==(const Span&) const = default;
};

/// Returns the corners of all plates that are stored with a span.
inline std::vector<Vec3> plate_corners(const Span& span) {
  std::vector<Vec3> corners;
  for (const Plate& plate : span.plates)
    for (const PlatePart& part : plate.parts)
      for (const std::vector<PlateCorner>& ring : part.rings)
        for (const PlateCorner& corner : ring) corners.push_back(corner.at);
  return corners;
}

/// True if a span ends on the ground, at an abutment or a portal.
inline bool is_on_ground(const SpanEnd& end) {
  return end.kind == EndKind::kGround || end.kind == EndKind::kBesideRoad;
}

}  // namespace citykiln::structures
