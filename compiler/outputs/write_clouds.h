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
/// The cells of the surface are 4 times the coarsest tolerance, within 40 to 400 m, and larger if the surface would
/// have more than some 400,000 triangles. Voxels are cells rounded to whole metres, doubled until there are at most
/// some 4 million. The smallest particles have a radius of half a cell.
/// @param notes  Gets a line if the module that writes .vdb is missing; USD then has only the particles.
Result<Done> write_clouds(const scene::Scene& scene, const Outputs& outputs, int threads,
                          exporters::OutputFolder& folder, std::vector<WrittenFile>& files,
                          std::vector<std::string>& notes);

}  // namespace citykiln::outputs
