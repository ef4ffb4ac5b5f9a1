// The ways of packing meshes in a .glb, and the grids of packed attributes.
#pragma once

#include "compiler/contract/tolerance.h"

namespace citykiln::exporters {

/// kDraco: KHR_draco_mesh_compression, the smallest. kMeshopt: EXT_meshopt_compression with KHR_mesh_quantization, the
/// fastest to read.
enum class Compression { kNone, kDraco, kMeshopt };

/// Step of positions: one grid for all tiles and levels. Origins of tiles are whole metres, so it is the plane's own
/// grid, and positions that two tiles share stay equal.
inline constexpr double kPackedPosition_m = kQuantum_m;
/// Step of uvs on atlases: a tenth of their finest texel.
inline constexpr double kPackedUv_m = 0x1p-9;
/// Bits of each of the two coordinates of an octahedral normal: an error of at most 0.3°.
inline constexpr int kPackedNormalBits = 10;

}  // namespace citykiln::exporters
