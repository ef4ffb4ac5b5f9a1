// Lofts: a cross-section drawn along ribs.
//
//     1---2          a section's corners, clockwise as seen along the axis: its faces then look outwards
//     |   3----4
//     0--------5
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/structures/ribs.h"

namespace citykiln::structures {

struct Corner {
  double left_m = 0, rise_m = 0;  ///< From the axis, and above its road.
  bool operator==(const Corner&) const = default;
};
using Section = std::vector<Corner>;

/// The band between two corners. Seen along the axis it looks to the left of the way from a to b. Two vertices a rib.
void add_band(std::span<const Rib> ribs, Corner a, Corner b, Mesh& mesh);

/// What closes a section, a simple ring, at a rib: seen from before the begin, or from behind the end.
void add_cap(const Rib& rib, const Section& section, bool is_begin, Mesh& mesh);

/// A closed tube: all bands and both caps.
void add_tube(std::span<const Rib> ribs, const Section& section, Mesh& mesh);

/// The rib at a place between two others, straight between them; the first or the last beyond these.
Rib rib_at(std::span<const Rib> ribs, double along_m);

/// A box: its base, counter-clockwise as seen from above, from one height up to another. Closed.
void add_box(std::span<const Vec2> base, double from_m, double to_m, Mesh& mesh);

}  // namespace citykiln::structures
