// Measures of the ground that are made from a baked tile's own triangles, without trusting who made them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"

namespace citykiln::verify {

/// What stands on the ground, or leaves it, and may be made of the same materials. All sorted.
struct NonGroundObjects {
  std::vector<OsmId> off_ground;    ///< Bridges, tunnels, walls: no ground, whatever they are made of.
  std::vector<OsmId> building_ids;  ///< No ground but for what lies under them, and their fields.
  std::vector<std::pair<OsmId, materials::Material>>
      land_cover_materials{};   ///< Of houses that are also a field of that material.
  std::vector<OsmId> stairs{};  ///< Ways of steps: what is of stone there is stairs.
};

/// A triangle of the ground, in plane metres.
struct GroundFace {
  std::array<Vec3, 3> corners;
  OsmId feature;
};

/// All triangles of a ground material, upright ones too.
/// @param standing  As below.
std::vector<GroundFace> ground_faces(const bake::BakedTile& tile, const NonGroundObjects& non_ground);

/// What looking straight down at a lattice of places found.
struct GroundSamples {
  std::uint64_t count = 0;
  std::uint64_t uncovered = 0;  ///< Places with no ground at all.
  Vec2 hole;                    ///< The first of those.
  double error_m = 0;           ///< Largest vertical distance between ground and heights.
  Vec2 at;                      ///< Where that is.
};

/// How far a height is off what it should be at a place of the plane, where a feature covers it.
using DeviationAt = std::function<double(Vec2 p, double z_m, OsmId feature)>;

/// Samples a random place in every square of a lattice over the box: the lowest upward triangle of a ground material
/// there is the ground.
/// @param standing  Overlooked.
/// @param a_side   Squares along each side of the box.
/// O(triangles + samples).
GroundSamples sample_ground(const bake::BakedTile& tile, const NonGroundObjects& non_ground,
                            const DeviationAt& deviation_m, const Box2& box, int a_side);

/// An edge of the ground that runs along a tile's border, in plane metres, lower end first.
using BorderEdge = std::array<Vec3, 2>;

/// Those of a tile at one of its sides, sorted.
struct BorderEdges {
  std::vector<BorderEdge> ground;   ///< Of triangles that are seen from above.
  std::vector<BorderEdge> upright;  ///< Of those that stand in the border: steps, skirts.
};

/// The edges of ground triangles that lie in the line x = at (or y = at), those straight up left out.
BorderEdges border_edges_along_x(const bake::BakedTile& tile, const NonGroundObjects& non_ground, double at);
BorderEdges border_edges_along_y(const bake::BakedTile& tile, const NonGroundObjects& non_ground, double at);

/// Whether the ground of neighbouring tiles meets: it has the same edges, or an upright face of one of them stands
/// between two, where a border between surfaces runs along the tile's.
bool borders_match(const BorderEdges& own, const BorderEdges& other);

}  // namespace citykiln::verify
