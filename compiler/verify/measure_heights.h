// How well a scene's recipes agree about heights: what report.json says. `check` measures the baked tiles as well.
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
  RoadFaces road_faces;  ///< Profiles against the graded terrain.
  Rises rises;
  Lakes lakes;      ///< Levels against the graded terrain, along shores.
  Footing footing;  ///< Buildings' lower ends against the graded terrain.
  Clearances clearances;
};

/// Of all chunks; what crosses their borders counts in each. O(n log n), each chunk by itself.
HeightMeasures measure_heights(const scene::Scene& scene, int threads);

}  // namespace citykiln::verify
