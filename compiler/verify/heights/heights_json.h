// The part of report.json about the consistency of heights.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "compiler/ground/profiles/measure_profiles.h"
#include "compiler/verify/heights/measure_clearances.h"
#include "compiler/verify/heights/measure_footing.h"
#include "compiler/verify/heights/measure_lakes.h"
#include "compiler/verify/heights/measure_lines.h"
#include "compiler/verify/heights/measure_road_faces.h"

namespace citykiln::verify {

// Measures whether the heights in the recipes of a scene are consistent, for report.json. `check` also measures the
// baked tiles.

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

/// Measures of the heights in recipes, and of planned profiles if the run compiled a map.
struct HeightReport {
  HeightMeasures recipes;
  std::optional<ground::ProfileMeasures> planned{};
};

/// Returns the measures by name, in metres and counts. Every value should be 0, except lengths, shares over the grade
/// limit, and clearances.
nlohmann::ordered_json heights_json(const HeightReport& heights);

}  // namespace citykiln::verify
