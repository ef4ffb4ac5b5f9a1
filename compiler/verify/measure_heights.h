// Consistency of heights in the recipes of a scene, for report.json. `check` measures the baked tiles as well.
#pragma once

#include <optional>

#include "compiler/ground/profiles/measure_profiles.h"
#include "compiler/verify/measure_clearances.h"
#include "compiler/verify/measure_footing.h"
#include "compiler/verify/measure_lakes.h"
#include "compiler/verify/measure_lines.h"
#include "compiler/verify/measure_road_faces.h"

namespace citykiln::verify {

struct HeightMeasures {
  Grades grades;
  Jumps jumps;
  RoadFaces road_faces;  ///< Road profiles against the graded terrain.
  Rises rises;
  Lakes lakes;      ///< Lake levels against the graded terrain along shores.
  Footing footing;  ///< Lower ends of buildings against the graded terrain.
  Clearances clearances;
};

/// Measures all chunks, each separately; objects in several chunks count in each. O(n log n).
HeightMeasures measure_heights(const scene::Scene& scene, int threads);

}  // namespace citykiln::verify
