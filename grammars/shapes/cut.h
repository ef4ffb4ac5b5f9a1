// Cuts faces and solids by planes, and joins faces of one plane.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "grammars/shapes/face.h"

namespace citykiln::grammars {

/// An edge from one point to another.
using Edge3 = std::pair<Vec3, Vec3>;

/// Returns the parts of a face where dot(normal, p) >= offset.
///
///      ____          A chain is the part of a ring above the plane. Sorted along
///     /    \____     the cut, the k-th end of a chain continues at the k-th start
///   --x----x-x--x--  of one. So holes and concave faces need no case of their own.
///     \___/   \_/
///
/// Guarantees: the parts on both sides of a plane have together the area of the face and share the points of the cut,
/// bit for bit; points of the face are unchanged; a crossing depends only on its edge, so faces that share an edge
/// share the crossing. A face in the plane belongs to the side from which its normal points away, as in a solid. A face
/// that crosses itself is cut by the even-odd rule. O(n log n).
std::vector<Face> part_above(const Face& face, const CutPlane& plane);

/// Cuts a face into one part on each side of the plane, equal to the results of part_above(): `face` becomes the part
/// above and `below` the other part. Returns false and changes nothing for faces with holes or more than 16 points, and
/// for faces that rise through the plane more or less than once.
bool cut_in_two(Face& face, const CutPlane& plane, Face& below);

/// True if every edge of the faces occurs once in each direction, as on the surface of a solid. O(n log n).
bool is_closed(std::span<const Face> faces);

/// Returns the parts of faces above the plane. The part of a closed surface gets a face in the plane (a cap), so it is
/// closed too.
/// @param closed  The value of is_closed(faces). Caps have the tag kNone.
std::vector<Face> solid_above(std::span<const Face> faces, const CutPlane& plane, bool closed);

/// Returns faces with this normal, bounded by those of the edges that have no opposite edge. Leaves out edges that do
/// not form a ring within 1e-6 m. O(n²).
std::vector<Face> faces_along(std::span<const Edge3> edges, Vec3 normal);

/// Returns the union of faces of one plane that share edges.
std::vector<Face> merged(std::span<const Face> faces);

}  // namespace citykiln::grammars
