// Writes the clouds of a scene beside its tiles.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "compiler/verify/run_report.h"
#include "exporters/output_folder.h"

namespace citykiln::commands {

/// Writes the clouds over the scene's extent (sky::clouds_over) once, however many tiles there are: glb/clouds.glb for
/// .glb, usd/clouds.usdc and usd/clouds.vdb for USD. Writes nothing for a clear sky.
///
/// The surface has cells of kCellsOfTolerance coarsest tolerances, from kFinestCell_m on, larger for large extents (the
/// surface is to have about kMostTriangles); voxels are larger then too (kMostVoxels). Particles are as small as cells.
/// @param notes  Gets a line where the module that writes .vdb is missing; USD has the particles alone then.
Result<Done> write_clouds(const scene::Scene& scene, const Outputs& outputs, int threads,
                          exporters::OutputFolder& folder, std::vector<verify::WrittenFile>& files,
                          std::vector<std::string>& notes);

}  // namespace citykiln::commands
