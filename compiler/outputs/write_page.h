// Writes the page of a run, which shows its tileset in a browser.
#pragma once

#include <vector>

#include "compiler/contract/result.h"
#include "compiler/map/plane/geoid.h"
#include "compiler/outputs/run_report.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "exporters/output_folder.h"

namespace citykiln::outputs {

/// Writes index.html and page/: the files of the program, page.json (sky, classes, what is assumed), the records of
/// features with their recipes, and names. The page also reads 3dtiles/ and findings.json of the same folder.
/// Returns the files that were written. Error: a file that cannot be written.
/// @param geoid  The result of geoid_of() (write_tiles3d.h).
Result<std::vector<WrittenFile>> write_page(const scene::Scene& scene, const Outputs& outputs, const map::Geoid& geoid,
                                            int threads, exporters::OutputFolder& folder);

}  // namespace citykiln::outputs
