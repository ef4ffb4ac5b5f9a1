// How meshes are packed in a .glb, and the grids on which packed numbers lie.
#pragma once

#include "compiler/contract/tolerance.h"

namespace citykiln::exporters {

/// kDraco: KHR_draco_mesh_compression, the smallest. kMeshopt: EXT_meshopt_compression with KHR_mesh_quantization, the
/// fastest to read.
enum class Compression { kNone, kDraco, kMeshopt };

/// Places of packed meshes. One grid for all tiles and levels: origins of tiles are whole metres, so it is the plane's
/// own, and what two tiles share they still share.
inline constexpr double kPackedPosition_m = kQuantum_m;
/// On sheets and atlases: a tenth of their finest texel.
inline constexpr double kPackedUv_m = 0x1p-9;
/// Of each of the two numbers of a normal on an octahedron: at most 0.3° off.
inline constexpr int kPackedNormalBits = 10;

}  // namespace citykiln::exporters
