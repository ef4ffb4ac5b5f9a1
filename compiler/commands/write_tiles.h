// From a scene to the files of a folder: what compile and bake have in common, so that they cannot differ.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/bake/baked.h"
#include "exporters/output_folder.h"
#include "compiler/commands/run_report.h"
#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "compiler/stage_watch.h"

namespace citykiln::commands {

/// Writes scene.kiln and glb/<x>_<y>_L<n>.glb, whichever the outputs ask for, one tile at a time.
Result<Written> write_outputs(const scene::Scene& scene, const Outputs& outputs, int threads, OutputFolder& folder,
                              Report& report, const OnProgress& on_progress);

/// A tile as a .glb holds it, and the error that it states: what packing loses is in it.
struct EncodedTile {
  std::vector<std::byte> glb;
  double error_m = 0;
};
EncodedTile encode_tile(const bake::BakedTile& tile, const scene::Header& header, bool instances_as_nodes,
                        Compress compress, int threads);

/// "glb/3_-2_L0.glb".
std::string glb_name(scene::TileKey tile, std::size_t level);

/// Triangles of a baked tile, each instance's counted.
std::uint64_t triangles_of(const bake::BakedTile& tile);
std::uint64_t instances_of(const bake::BakedTile& tile);

}  // namespace citykiln::commands
