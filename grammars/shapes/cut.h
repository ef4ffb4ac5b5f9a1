// Faces and solids cut by planes.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "grammars/shapes/face.h"

namespace citykiln::grammars {

using Edge3 = std::pair<Vec3, Vec3>;

/// The parts of a face on the side the plane's normal points to; with dot(normal, p) >= offset.
///
///      ____          ends of chains and their beginnings, each sorted along the
///     /    \____     cut, belong together in turn: so holes and concave faces fall
///   --x----x-x--x--  into the right parts without a look at their shapes
///     \___/   \_/
///
/// Guarantees: the parts on both sides of a plane have the face's area and share the cut's points, bit for bit; points
/// of the face stay as they are; a crossing depends on its edge alone, so faces that share an edge share the crossing.
/// A face in the plane goes to the side its normal turns its back on, as a solid's faces must. Total: a face that
/// crosses itself is cut by the even-odd rule. O(n log n).
std::vector<Face> part_above(const Face& face, const CutPlane& plane);

/// Cuts a face that the plane divides in one part on either side: `face` becomes that above, `below` the other, as
/// part_above() makes them. False, and nothing is done, for faces with holes or many points, and for those that come
/// up through the plane not just once.
bool cut_in_two(Face& face, const CutPlane& plane, Face& below);

/// True if every edge of the faces runs once each way: the surface of a solid. O(n log n).
bool is_closed(std::span<const Face> faces);

/// The part of faces above the plane; of a closed surface with a cap in the plane, so that it is closed again.
/// @param closed  As is_closed() says of `faces`. Caps are tagged kNone.
std::vector<Face> solid_above(std::span<const Face> faces, const CutPlane& plane, bool closed);

/// The rings that run along all edges whose opposites are not there too, put together to faces with this normal.
/// What does not close within 1e-6 m is left out. O(n²).
std::vector<Face> faces_along(std::span<const Edge3> edges, Vec3 normal);

/// Faces of one plane that share edges, as one: all edges of which there is no opposite.
std::vector<Face> merged(std::span<const Face> faces);

}  // namespace citykiln::grammars
