// Lofts: surfaces that a cross-section (a section) sweeps along ribs. A rib is a straight line across a bridge or
// tunnel at one distance along its axis (ribs.h).
//
//     1---2          a section's corners run clockwise seen along the axis, so that faces point outwards
//     |   3----4
//     0--------5
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/structures/ribs.h"

namespace citykiln::structures {

/// A corner of a section: its distance to the left of the axis, and its height above the road, metres. Meshes are in
/// plane metres, z up.
struct Corner {
  double left_m = 0, rise_m = 0;
  bool operator==(const Corner&) const = default;
};
/// Corners of a cross-section in the plane of a rib, clockwise as seen along the axis.
using Section = std::vector<Corner>;

/// Adds the surface that the straight line from corner a to corner b sweeps, with two vertices per rib. The surface
/// faces to the left of the direction from a to b, as seen along the axis.
///
/// @param ribs  In order along the axis, at least two; here and below.
void add_band(std::span<const Rib> ribs, Corner a, Corner b, Mesh& mesh);

/// Adds an end face of a loft. The face points against the axis if `is_begin`, else along it.
/// @param section  A simple ring.
void add_cap(const Rib& rib, const Section& section, bool is_begin, Mesh& mesh);

/// Adds a closed tube: all bands of a section and both caps.
void add_tube(std::span<const Rib> ribs, const Section& section, Mesh& mesh);

/// Returns the rib at a distance along the way, interpolated between its neighbours. Distances beyond the ends give the
/// first or the last rib.
/// @param ribs  In order along the way, not empty.
Rib rib_at(std::span<const Rib> ribs, double along_m);

/// Adds a closed vertical prism.
/// @param base          Convex ring, counter-clockwise as seen from above, plane metres.
/// @param from_m, to_m  Heights of its lower and its upper end; from_m <= to_m.
void add_prism(std::span<const Vec2> base, double from_m, double to_m, Mesh& mesh);

}  // namespace citykiln::structures
