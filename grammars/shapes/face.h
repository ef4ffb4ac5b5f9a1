// Faces: flat polygons in space, and what is done with them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/geometry/vec.h"
#include "grammars/shapes/ring3.h"

namespace citykiln::grammars {

/// What made a face, for comp(f); kNone: its direction decides.
enum class FaceTag : std::uint8_t { kNone, kTop, kSide, kBottom, kVertical, kInside, kBorder };

/// Plane metres, z up. Outer counter-clockwise seen from where the normal points, holes clockwise.
struct Face {
  Ring3 outer;
  std::vector<Ring3> holes;
  FaceTag tag = FaceTag::kNone;
  bool street = false;                     ///< Stands along the street.
  std::vector<std::uint8_t> street_edges;  ///< Per edge of `outer`; or empty: none runs along the street.
  bool operator==(const Face&) const = default;
};

/// All that lies where dot(normal, p) = offset. `normal` has length 1.
struct CutPlane {
  Vec3 normal;
  double offset_m = 0;
};

/// Nearer to a plane than this is on it: far above what rounding moves in a city, far below what one sees.
inline constexpr double kOnPlane_m = 0x1p-24;

/// Twice the area, as a vector along the normal. O(n).
Vec3 area_vector_m2(std::span<const Vec3> ring);
Vec3 area_vector_m2(const Face& face);
/// Of length 1; {0, 0, 0} for a face without area.
Vec3 normal_of(const Face& face);
double area_m2(const Face& face);
Face reversed(const Face& face);
/// How far its corners lie apart along its normal; 0 if that is no more than kOnPlane_m. Roofs' are rounded, so that
/// they are flat to a millimetre: pieces of one lie so far from it as others would triangulate it. O(n).
double bend_m(const Face& face);

/// Calls `with` on every vertex.
template <typename Visitor>
void each_vertex(Face& face, Visitor with) {
  for (Vec3& p : face.outer) with(p);
  for (Ring3& hole : face.holes)
    for (Vec3& p : hole) with(p);
}
template <typename Visitor>
void each_vertex(const Face& face, Visitor with) {
  each_vertex(const_cast<Face&>(face), [&](const Vec3& p) { with(p); });
}

std::size_t vertex_count(std::span<const Face> faces);

/// A right-handed frame of the face's plane: x along its first edge with a length, in the plane; z its normal; origin
/// its first point.
struct FaceFrame {
  Vec3 origin, x, y, z;
  Vec2 to_plane(Vec3 p) const { return {dot(p - origin, x), dot(p - origin, y)}; }
  Vec3 to_space(Vec2 p) const { return origin + x * p.x + y * p.y; }
};
FaceFrame frame_of(const Face& face);
Polygon flat(const Face& face, const FaceFrame& frame);
/// Back into space; points that lie within `snap_m` of a vertex of `like` become that vertex, bit for bit.
Face lifted(const Polygon& polygon, const FaceFrame& frame, const Face& like, double snap_m);

}  // namespace citykiln::grammars
