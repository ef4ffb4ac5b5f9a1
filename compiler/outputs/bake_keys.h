// Keys of baked tiles. A tile is not baked again if an earlier run wrote it with the same key
// (exporters/output_folder.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/scene/scene.h"
#include "compiler/spec.h"

namespace citykiln::outputs {

/// Returns a hash of the program's executable, or of its version if the system does not let a process read its
/// executable.
std::uint64_t program_hash();

/// Returns a key for every chunk and level, at the index `chunk * levels + level`. It is a hash of the scene's header,
/// the chunk's recipes, the settings that change the bytes of tiles, the level, and the program's executable. Equal
/// keys mean equal bytes of the .glb, except with probability 2^-64; no key is 0. Cost: encoding the manifest without
/// compression.
std::vector<std::uint64_t> bake_keys(const scene::Scene& scene, const Outputs& outputs, int threads);

}  // namespace citykiln::outputs
