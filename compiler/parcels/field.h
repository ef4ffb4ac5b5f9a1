// The field of streets: which street's edge a place belongs to.
//
//     |  piece |  piece |      each piece of an edge has the land in front of it, and a wedge where
//     |        |        |\     the edge turns outward; a place belongs to the nearest piece that it
//    ═══════════════════════   sees along a straight line square to the edge
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/parcels/parcels.h"
#include "compiler/parcels/rights_of_way.h"

namespace citykiln::parcels {

// Obstacles: the segments that hide a street from a place.

/// Segments that cannot be looked across, with an index of their boxes.
struct Obstacles {
  std::vector<std::pair<Vec2, Vec2>> segments;
  BoxGrid grid;
};

/// Returns the axes of streets and barriers and the edges of taken land.
Obstacles obstacles_of(const std::vector<Line>& lines, const std::vector<Polygon>& taken);

/// True if no obstacle crosses the segment from a to b.
bool is_seen(const Obstacles& obstacles, Vec2 a, Vec2 b);

/// Returns the distance from p to the first obstacle in the direction `towards`, or `most_m` if none is nearer.
/// @param towards  Length 1.
double distance_to_obstacle(const Obstacles& obstacles, Vec2 p, Vec2 towards, double most_m);

/// Land in front of a part of a street edge: a rectangle, or a wedge where the street edge turns outward. The distance
/// of a place p is dot(p - foot, normal). In a wedge this is up to 3.4 % less than the distance from its tip.
struct Piece {
  Vec2 foot, normal;  ///< A point of the street edge, and the direction away from it, length 1.
  Vec2 along;         ///< The direction of the street edge; {0, 0} for a wedge.
  Ring land;          ///< Convex, counter-clockwise.
  std::uint32_t street_edge = 0;
  std::uint32_t label = 0;  ///< The owner of places in it (edge_owners.h).
};

/// Pieces with an index of their boxes. The obstacles must live as long as the field.
struct Field {
  std::vector<Piece> pieces;
  BoxGrid grid;
  const Obstacles* obstacles = nullptr;
};

/// Returns the field of these pieces.
Field field_of(std::vector<Piece> pieces, const Obstacles& obstacles);

/// Appends the land in front of a part of a street edge.
/// @param from_m, to_m  Distances from the street edge's first point.
void add_piece(std::vector<Piece>& pieces, const RightsOfWay& ways, std::uint32_t street_edge, double from_m,
               double to_m, double depth_m, std::uint32_t label);
/// Appends the wedges between the ends of a street edge and of the next one, if it turns outward.
void add_wedges(std::vector<Piece>& pieces, const RightsOfWay& ways, std::uint32_t street_edge, double depth_m,
                std::uint32_t label);

/// True if no obstacle lies between a place and the piece's street edge.
bool is_seen_by(const Field& field, const Piece& piece, Vec2 p);

inline double distance_m(const Piece& piece, Vec2 p) { return dot(p - piece.foot, piece.normal); }

/// Returns the index of the nearest piece that contains p and whose street edge no obstacle hides from p; kNoIndex if
/// there is none. The lowest index of equal distances.
std::uint32_t nearest_piece(const Field& field, Vec2 p);
/// Returns nearest_piece() among the given pieces: indices, ascending. O(pieces + obstacles near the lines of sight).
std::uint32_t nearest_piece(const Field& field, std::span<const std::uint32_t> pieces, Vec2 p);
/// True if one of the given pieces contains p, is nearer than `below_m`, and no obstacle hides its street edge from p.
bool is_any_nearer(const Field& field, std::span<const std::uint32_t> pieces, Vec2 p, double below_m);
/// Returns nearest_piece() among the pieces of other street edges that are nearer than `most_m`.
std::uint32_t nearest_other(const Field& field, Vec2 p, std::uint32_t street_edge, double most_m);

/// True if p is in a convex counter-clockwise ring or on its border.
inline bool is_in_convex(std::span<const Vec2> ring, Vec2 p) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    if (twice_area(ring[j], ring[i], p) < 0) return false;
  return true;
}

}  // namespace citykiln::parcels
