// Faces: the plane divided by rights-of-way, taken land, footprints and the borders of lots, cell by cell.
//
// All lines are snap-rounded together (geometry/arrangement.h), so faces cover the extent and share no area, whatever
// the lines are. A point inside each face says what it is.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/parcels/empty_lots.h"
#include "compiler/parcels/field.h"
#include "compiler/parcels/rights_of_way.h"

namespace citykiln::parcels {

/// The side of the cells of faces. Cells begin at whole multiples of it.
inline constexpr double kFaceCell_m = 128;

/// The place of a face: the first of these in which it lies.
enum class FaceKind : std::uint8_t {
  kOutside,  ///< Outside of the extent.
  kLine,     ///< A right-of-way (RightOfWayPiece).
  kTaken,    ///< Taken land (Layout::taken).
  kLand      ///< Land for lots.
};

/// A face. Where it lies is found for a point inside it.
struct Face {
  FaceKind kind = FaceKind::kLand;
  std::uint32_t label = 0;             ///< Whom land belongs to (edge_owners.h); for kLand only.
  std::uint32_t footprint = kNoIndex;  ///< The footprint that it lies in, the first of several.
  double area_m2 = 0;
};

/// An edge of a face, which lies to its left. Points are on the plane's grid of kQuantum_m.
struct FaceEdge {
  GridPoint from, to;
  std::uint32_t face = 0;
  std::uint32_t beyond = kNoIndex;  ///< The face on the other side; kNoIndex at the outermost cells.
  Border border;                    ///< The border along it, kInner for borders of lots and cells.
};

struct Faces {
  std::vector<Face> faces;
  std::vector<FaceEdge> edges;  ///< Sorted by (from, to).
};

/// The lines that divide the plane, in plane metres. Refers to its parts.
struct Layout {
  Box2 extent;
  std::span<const RightOfWayPiece> ways;
  std::span<const Polygon> taken;
  std::span<const Footprint> footprints;
  std::span<const std::pair<Vec2, Vec2>> borders;
  const Field* field = nullptr;
  const Splits* splits = nullptr;  ///< Null: no lots are split.
};

/// Returns the faces of all cells that the extent touches. Edges between cells are edges of faces, too. Cannot fail.
/// Cost: that of arrange() and of a triangulation.
Faces faces_of(const Layout& layout, int threads);

}  // namespace citykiln::parcels
