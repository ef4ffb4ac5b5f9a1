// The part of report.json about the consistency of heights.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "compiler/ground/profiles/measure_profiles.h"
#include "compiler/verify/measure_heights.h"

namespace citykiln::verify {

/// Measures of the heights in recipes, and of planned profiles if the run compiled a map.
struct HeightReport {
  HeightMeasures recipes;
  std::optional<ground::ProfileMeasures> planned{};
};

/// Returns the measures by name, in metres and counts. Every value should be 0, except lengths, shares over the grade
/// limit, and clearances.
nlohmann::ordered_json heights_json(const HeightReport& heights);

}  // namespace citykiln::verify
