// The houses of a tile: levels that show facades as pictures share what these are made of, and a tile has one atlas.
#pragma once

#include <span>

#include "compiler/bake/firing.h"
#include "compiler/bake/levels.h"

namespace citykiln::bake {

/// The houses of those levels that show facades as pictures. The others' are made when they are fired.
void expand_imprinted(const scene::Header& header, const scene::Chunk& chunk, std::span<Level> levels, int threads);

/// Account "bake/building".
void fire_houses(Firing& firing, Level& level, int threads, Report& report);

}  // namespace citykiln::bake
