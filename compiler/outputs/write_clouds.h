// Writes the clouds of a scene to files beside its tiles.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/outputs/run_report.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "exporters/output_folder.h"

namespace citykiln::outputs {

/// Writes the clouds over the scene's extent (sky::clouds_over) once for all tiles: glb/clouds.glb for .glb,
/// usd/clouds.usdc and usd/clouds.vdb for USD. Writes nothing for a clear sky.
///
/// The cells of the surface are kCellsOfTolerance times the coarsest tolerance, at least kFinestCell_m, and larger if
/// the surface would have more than about kMostTriangles. Voxels are as large, or larger if there would be more than
/// kMostVoxels. Particles are as small as cells.
/// @param notes  Gets a line if the module that writes .vdb is missing; USD then has only the particles.
Result<Done> write_clouds(const scene::Scene& scene, const Outputs& outputs, int threads,
                          exporters::OutputFolder& folder, std::vector<WrittenFile>& files,
                          std::vector<std::string>& notes);

}  // namespace citykiln::outputs
