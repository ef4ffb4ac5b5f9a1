// Measures whether the heights in the recipes of a scene are consistent, for report.json. `check` also measures the
// baked tiles.
#pragma once

#include <optional>

#include "compiler/ground/profiles/measure_profiles.h"
#include "compiler/verify/measure_clearances.h"
#include "compiler/verify/measure_footing.h"
#include "compiler/verify/measure_lakes.h"
#include "compiler/verify/measure_lines.h"
#include "compiler/verify/measure_road_faces.h"

namespace citykiln::verify {

/// The consistency of the heights in the recipes of a scene.
struct HeightMeasures {
  Grades grades;
  Jumps jumps;
  RoadFaces road_faces;  ///< Road profiles compared with the graded terrain.
  Rises rises;
  Lakes lakes;      ///< Lake levels compared with the graded terrain along shores.
  Footing footing;  ///< Lower ends of buildings compared with the graded terrain.
  Clearances clearances;
};

/// Measures road faces, rises, lakes and footing chunk by chunk: an object in several chunks counts in each. Grades of
/// a road or span count once, as measure_grades() says. Jumps and clearances are those of the whole scene. O(n log n).
HeightMeasures measure_heights(const scene::Scene& scene, int threads);

}  // namespace citykiln::verify
