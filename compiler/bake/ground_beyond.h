// The ground under buildings that stand across the border of the extent.
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

/// Returns boxes outside of the extent that hold the footprints of buildings on the ground, as far as they are beside
/// this tile and within kBeyond_m of it.
///
/// Guarantees: corners on whole metres; no two boxes overlap, nor those of two tiles; two tiles cover the same parts of
/// the line between them; empty for tiles inside the extent. O(n²) in buildings across the border.
std::vector<Box2> ground_beyond(const scene::Header& header, const scene::Chunk& chunk);

/// What a chunk holds reaches scene::kHalo_m beyond its tile, and cells need a metre around them.
inline constexpr double kBeyond_m = scene::kHalo_m - 2;

}  // namespace citykiln::bake
