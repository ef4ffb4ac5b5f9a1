// What covers the ground: polygons of land cover classes, made of the recipes of a chunk or of the whole map.
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/pieces/pieces.h"
#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// The land cover of a tile at a tolerance.
struct LandCover {
  /// Sorted by id, class and piece, each combination of them once.
  std::vector<ground::LandCoverPolygon> surfaces;
  /// Pieces of roads by LandCoverPolygon::piece - 1. Piece::pattern indexes `layouts`; a run belongs to one road.
  std::vector<roads::Piece> pieces;
  /// Of marked pieces; some may be equal.
  std::vector<roads::MarkingLayout> layouts;
};

/// Returns the polygons of areas, roads, junctions, traffic islands, watercourses and buildings that stand on the
/// ground. With Detail::kRoadSurfaces roads are divided into pieces, else each is one surface from kerb to kerb.
/// Total. O(n log n).
LandCover land_cover_of(const Header& header, const Chunk& chunk, double tolerance_m);

/// The recipes that cover the ground, of a chunk or of the whole map.
struct CoverRecipes {
  std::span<const ground::LandCoverPolygon> areas;
  std::span<const roads::Road> roads;
  std::span<const roads::Junction> junctions;  ///< Their arms are among `roads`.
  std::span<const roads::Strip> watercourses;
  std::vector<ground::LandCoverPolygon> footprints;
};

/// Returns the same polygons with every road as one surface, whatever the tolerance: for clearances, which must be the
/// same on all levels.
std::vector<ground::LandCoverPolygon> coarse_land_cover(const CoverRecipes& recipes);
std::vector<ground::LandCoverPolygon> coarse_land_cover(const Chunk& chunk);

/// The polygon of a junction. It lies over the strips of its roads and has the id of its main road.
ground::LandCoverPolygon junction_surface(const roads::Junction& junction, std::span<const roads::Road> roads,
                                          std::span<const roads::Arm> arms);
/// The pavements around a junction's corners, with the junction's id; no rings where there are none.
ground::LandCoverPolygon corner_pavement_surface(const roads::Junction& junction, std::span<const roads::Road> roads,
                                                 std::span<const roads::Arm> arms);
/// The polygon that a building on the ground covers.
ground::LandCoverPolygon footprint_surface(ObjectId id, const Polygon& footprint);

}  // namespace citykiln::scene
