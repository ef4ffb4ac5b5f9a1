// Lofts: surfaces of cross-sections that are swept along ribs.
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

/// A point of a cross-section: its distances to the left of the axis and above the road.
struct Corner {
  double left_m = 0, rise_m = 0;
  bool operator==(const Corner&) const = default;
};
using Section = std::vector<Corner>;

/// Adds the surface that the line from a to b sweeps, with two vertices per rib. Seen along the axis, it faces to the
/// left of the direction from a to b.
void add_band(std::span<const Rib> ribs, Corner a, Corner b, Mesh& mesh);

/// Adds an end face of a loft. It faces backwards at the begin and forwards at the end. The section is a simple ring.
void add_cap(const Rib& rib, const Section& section, bool is_begin, Mesh& mesh);

/// Adds a closed tube: all bands of a section and both caps.
void add_tube(std::span<const Rib> ribs, const Section& section, Mesh& mesh);

/// Returns the rib at a distance along the way, interpolated between its neighbours. Before the first rib and after the
/// last one it returns these.
/// @param ribs  Not empty.
Rib rib_at(std::span<const Rib> ribs, double along_m);

/// Adds a closed prism over a convex base, counter-clockwise seen from above. from_m <= to_m.
void add_box(std::span<const Vec2> base, double from_m, double to_m, Mesh& mesh);

}  // namespace citykiln::structures
