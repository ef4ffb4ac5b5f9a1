// The page of a run, which shows its tileset in a browser: files that can be made one by one, so that a server makes
// them when they are asked for.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/map/plane/geoid.h"
#include "compiler/outputs/run_report.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "exporters/output_folder.h"

namespace citykiln::outputs {

/// A file of the page. `make` may be called from several threads at once, for different files too.
struct PageContent {
  std::string name;  ///< Relative to the folder of the run.
  std::function<std::string()> make;
};

/// Returns the files of the page: index.html, and in page/ the viewer's program, page.json (skies, classes,
/// assumptions), a table for each sky, the records of features with their recipes, and names. The page also reads
/// 3dtiles/ and findings.json of the run's folder. Cost: the call makes the records of all features; PageContent::make
/// takes 0.4 s of one core for the table of a sky.
///
/// @param scene, geoid  Must outlive the result. The geoid is the result of geoid_of() (write_tiles3d.h).
std::vector<PageContent> page_contents(const scene::Scene& scene, const Outputs& outputs, const map::Geoid& geoid);

/// Writes the files of the page, made in parallel. Returns the files that were written. Error: a file that cannot be
/// written.
Result<std::vector<WrittenFile>> write_page(const scene::Scene& scene, const Outputs& outputs, const map::Geoid& geoid,
                                            int threads, exporters::OutputFolder& folder);

}  // namespace citykiln::outputs
