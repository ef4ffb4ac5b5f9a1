// Keys of baked tiles: a tile whose key an interrupted run has is not baked again (exporters/output_folder.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/scene/scene.h"
#include "compiler/spec.h"

namespace citykiln::commands {

/// A hash of the program: of its executable's bytes, or, where the system does not let a process read them, of its
/// version.
std::uint64_t program_hash();

/// Returns a key for every chunk and level, `chunk * levels + level`: a hash of the scene's header, the chunk's
/// recipes, the settings that change the bytes of tiles, the level, and the program. Equal keys mean equal bytes of the
/// .glb, except with probability 2^-64; none is 0. Cost: as encoding the manifest without compression.
///
/// The program counts as the bytes of its executable, so that a program that was changed never takes over the tiles of
/// the one before.
std::vector<std::uint64_t> bake_keys(const scene::Scene& scene, const Outputs& outputs, int threads);

}  // namespace citykiln::commands
