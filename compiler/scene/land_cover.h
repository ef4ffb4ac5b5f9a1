// Makes the land cover of a chunk (the recipes of one tile) or of the whole map: polygons of land cover classes, from
// recipes.
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/pieces/pieces.h"
#include "compiler/scene/scene.h"
#include "compiler/vacant/plots.h"

namespace citykiln::scene {

/// The land cover of a tile at a tolerance.
struct LandCover {
  /// Sorted by id, class and piece; each combination occurs once.
  std::vector<ground::LandCoverPolygon> surfaces;
  /// Pieces of roads, the parts of a road's lane strips with constant markings, and panels of sports pitches.
  /// LandCoverPolygon::piece is 1 plus an index into this vector, Piece::layout an index into `layouts`. Each
  /// Piece::run belongs to one road or pitch.
  std::vector<roads::Piece> pieces;
  /// The marking layouts (patterns of painted lines) of marked pieces. Some may be equal.
  std::vector<roads::MarkingLayout> layouts;
};

/// Returns the polygons of areas, plots (vacant/plots.h), roads, junctions, traffic islands, watercourses, landforms
/// with a land cover of their own, and buildings that stand on the ground. With Detail::kRoadSurfaces roads are divided
/// into pieces and sports pitches into panels, else each road is one surface from kerb to kerb. Cannot fail. O(n log
/// n).
LandCover land_cover_of(const Header& header, const Chunk& chunk, double tolerance_m);

/// Returns the plots of ground that no lot has; none without Header::has_street_furniture. They are drawn from the
/// chunk, and their surfaces are part of land_cover_of(). O(n log n).
vacant::Plots plots_of(const Header& header, const Chunk& chunk);

/// The recipes of a chunk or of the whole map that cover the ground.
struct CoverRecipes {
  std::span<const ground::LandCoverPolygon> areas;
  std::span<const roads::Road> roads;
  std::span<const roads::Junction> junctions;  ///< Their arms are among `roads`.
  std::span<const roads::Strip> watercourses;
  std::span<const ground::Landform> landforms;
  std::vector<ground::LandCoverPolygon> footprints;
};

/// Returns the polygons with each road as one surface, whatever the tolerance. Clearances are measured with these, so
/// that they are equal on all levels.
std::vector<ground::LandCoverPolygon> coarse_land_cover(const CoverRecipes& recipes);
std::vector<ground::LandCoverPolygon> coarse_land_cover(const Chunk& chunk);

/// Returns the polygon of a junction. It covers the ends of its roads and has the id of its main road, with a part
/// number of its own.
ground::LandCoverPolygon junction_surface(const roads::Junction& junction, std::span<const roads::Road> roads,
                                          std::span<const roads::Arm> arms);
/// Returns the pavements around a junction's corners, with the junction's id. It has no rings if there are none.
ground::LandCoverPolygon corner_pavement_surface(const roads::Junction& junction, std::span<const roads::Road> roads,
                                                 std::span<const roads::Arm> arms);
/// Returns the polygon of a footprint.
ground::LandCoverPolygon footprint_surface(ObjectId id, const Polygon& footprint);
/// Returns the polygon that a building covers on the ground, without its passageways.
ground::LandCoverPolygon footprint_surface(const buildings::Building& building);

}  // namespace citykiln::scene
