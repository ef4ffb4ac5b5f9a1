// What covers a chunk's ground, from its recipes.
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/pieces/pieces.h"
#include "compiler/scene/scene.h"

namespace citykiln::scene {

struct LandCover {
  std::vector<ground::LandCoverPolygon>
      surfaces;  ///< Sorted by id, then class, then piece. Each id, class and piece once.
  std::vector<roads::Piece>
      pieces;  ///< LandCoverPolygon::piece 1, 2 …; pattern is one of `patterns`, run of one road alone.
  std::vector<roads::MarkingLayout> layouts;  ///< Of marked pieces; some may be equal.
};

/// Everything that covers the ground: surfaces, roads, the islands between them, junctions, streams, the footprints of
/// buildings that stand on it. With Detail::kRoadSurfaces roads come in pieces. Total. O(n log n).
LandCover land_cover_of(const Header& header, const Chunk& chunk, double tolerance_m);

/// The same with every road as one surface from kerb to kerb: for clearances, which no tolerance may change.
std::vector<ground::LandCoverPolygon> coarse_land_cover(const Chunk& chunk);

/// The ground that a junction covers: it lies over the strips of its roads, and is named after its main road.
ground::LandCoverPolygon junction_surface(const roads::Junction& junction, std::span<const roads::Road> roads,
                                          std::span<const roads::Arm> arms);
/// The pavements round its corners, of the same id; without rings where there are none.
ground::LandCoverPolygon corner_pavement_surface(const roads::Junction& junction, std::span<const roads::Road> roads,
                                                 std::span<const roads::Arm> arms);
/// The ground that a building covers.
ground::LandCoverPolygon footprint_surface(const buildings::Building& building);

}  // namespace citykiln::scene
