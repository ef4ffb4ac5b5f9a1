// Boxes of ground outside the extent, under buildings that stand across its border.
//
//          extent |
//      ___________|___
//     |  building |  .|     the ground goes on below the part outside, in whole metres
//     |___________|__.|
//                 |
#pragma once

#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// Returns boxes that cover the footprints of buildings on the ground outside of the extent, beside this tile and
/// within kBeyond_m of it.
///
/// Guarantees: corners on whole metres; no two boxes overlap, also boxes of different tiles; the boxes of two tiles
/// cover the same parts of the line between them; empty for tiles inside the extent. O(n²) in buildings across the
/// border.
std::vector<Box2> ground_beyond(const scene::Header& header, const scene::Chunk& chunk);

/// The largest distance of boxes from their tile. A chunk has data up to scene::kHalo_m, and cells need a margin of a
/// metre.
inline constexpr double kBeyond_m = scene::kHalo_m - 2;

}  // namespace citykiln::bake
