// Bends a baked tile from the plane onto the ellipsoid, or into a cylinder.
#pragma once

#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/bake/bounds.h"
#include "compiler/bake/place_lamps.h"
#include "compiler/map/plane/cylinder.h"
#include "compiler/map/plane/geoid.h"
#include "compiler/map/plane/globe.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The largest sag of a straight edge, as a share of the tile's tolerance.
inline constexpr double kSagShare = 0.02;

/// Returns the tile in the frame of `globe`: the run's local frame on the ellipsoid, x east, y north, z up
/// (map/plane/globe.h). Heights above the ellipsoid are the tile's heights plus the geoid's. The origin is in that
/// frame, too, in whole metres.
///
/// - Edges are halved until the sag (the distance of the straight edge from the bent one, map::sag_m()) is at most
///   kSagShare of the tolerance. A new vertex has the mean of the uvs, colours and normals of the edge's ends.
/// - Positions of ground, roads and water are multiples of kQuantum_m of the frame; others are rounded to single
///   precision from the tile's origin.
/// - Instances keep their shape; each is turned to the vertical of its place.
/// - The largest deviation of the geoid from a straight line along an edge is added to error_m. The sum is multiplied
///   by the factor of lengths at the tile's largest height; then sag and rounding are added. object_error_m becomes
///   error_m. plant_error_m is multiplied by the same factor.
///
/// Guarantees: equal positions stay equal, and equal edges are halved at equal places in all tiles, so tiles that were
/// baked separately meet as in the plane. Same bytes on every CPU. Cannot fail. Cost: 0.3 µs a vertex.
BakedTile bent(BakedTile tile, const map::Globe& globe, const map::Geoid& geoid);

/// The largest sag of an edge inside of a cylinder, as a share of the tile's tolerance.
inline constexpr double kCylinderSagShare = 0.1;

/// Returns the tile inside of a cylinder, with BakedTile::cylinder set, in the frame of map/plane/cylinder.h. The bent
/// scene is the image of the plane's full shape, point by point.
///
/// - Edges are halved until their sag (map::sag_m()) is at most kCylinderSagShare of the tolerance, as above. Edges
///   along the axis have none and stay.
/// - Normals are those of the bent surface.
/// - Positions and instances as above. An instance is turned but not bent. Its instance error is a bound of its
///   distance from the bent mesh, by its size, its height above z = 0 and the radius.
/// - error_m is multiplied by the largest factor of lengths in the tile. The larger of two values is added: the largest
///   measured sag of a triangle, and the largest instance error except of plants. Rounding is added. object_error_m
///   becomes error_m.
/// - plant_error_m is multiplied by the same factor; the largest instance error of plants is added.
///
/// Guarantees and cost as above.
BakedTile bent(BakedTile tile, const map::Cylinder& cylinder);

// Upper bounds, in metres, of the error_m of a result of bent(), known before the tile is baked.
//
// @param shape_m      A bound of the tile's error_m in the plane.
// @param tolerance_m  The tile's tolerance, which limits the sag.
// @param bounds       Bounds of the tile in the plane.

/// The bound for bent() to the ellipsoid.
double bent_error_bound_m(double shape_m, double tolerance_m, const Bounds& bounds, const map::Geoid& geoid);

/// The space that a mesh takes about its own vertical.
struct InstanceSize {
  double across_m = 0, high_m = 0;  ///< The largest distance from the vertical, and from the mesh's z = 0.
};

/// The bound for bent() into a cylinder.
/// @param largest  The largest sizes of instances of the tile that are not plants.
double bent_error_bound_m(double shape_m, double tolerance_m, const Bounds& bounds, const map::Cylinder& cylinder,
                          const InstanceSize& largest);

/// Returns a tile of a scene in the scene's world: bent() if that is the inside of a cylinder, else as it is.
BakedTile in_world(BakedTile tile, const scene::Header& header);
/// Returns lamps in the scene's world: inside of a cylinder each is moved by the offset that bending gives its glass
/// (props::glass_of()), and PlacedLamp::up is turned; else lamps are unchanged.
std::vector<PlacedLamp> in_world(std::vector<PlacedLamp> lamps, const scene::Header& header);

/// Returns a tile from the inside of a cylinder in the plane, for choosing views. Its vertices are within rounding of
/// those before bent(); halved edges stay, errors too. Returns other tiles as they are.
BakedTile flattened(BakedTile tile);

}  // namespace citykiln::bake
