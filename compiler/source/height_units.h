// The units of heights that files declare, by their usual names. A header, since the module that reads heightmaps uses
// it too.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace citykiln::source {

/// A name of a unit, in lower case, without spaces and signs.
struct HeightUnitName {
  std::string_view name;
  double metres;
};

inline constexpr double kFoot_m = 0.3048, kSurveyFoot_m = 1200.0 / 3937;

inline constexpr HeightUnitName kHeightUnitNames[] = {{"m", 1},
                                                      {"metre", 1},
                                                      {"metres", 1},
                                                      {"meter", 1},
                                                      {"meters", 1},
                                                      {"ft", kFoot_m},
                                                      {"foot", kFoot_m},
                                                      {"feet", kFoot_m},
                                                      {"internationalfoot", kFoot_m},
                                                      {"internationalfeet", kFoot_m},
                                                      {"ftus", kSurveyFoot_m},
                                                      {"usft", kSurveyFoot_m},
                                                      {"footus", kSurveyFoot_m},
                                                      {"surveyfoot", kSurveyFoot_m},
                                                      {"surveyfeet", kSurveyFoot_m},
                                                      {"ussurveyfoot", kSurveyFoot_m},
                                                      {"ussurveyfeet", kSurveyFoot_m},
                                                      {"ussurveyft", kSurveyFoot_m},
                                                      {"yd", 0.9144},
                                                      {"yard", 0.9144},
                                                      {"yards", 0.9144},
                                                      {"km", 1000},
                                                      {"kilometre", 1000},
                                                      {"kilometer", 1000},
                                                      {"dm", 0.1},
                                                      {"decimetre", 0.1},
                                                      {"decimeter", 0.1},
                                                      {"cm", 0.01},
                                                      {"centimetre", 0.01},
                                                      {"centimeter", 0.01},
                                                      {"centimetres", 0.01},
                                                      {"centimeters", 0.01},
                                                      {"mm", 0.001},
                                                      {"millimetre", 0.001},
                                                      {"millimeter", 0.001}};

/// Returns a unit in metres: "ft", "foot" and "feet" are 0.3048. Capitals, spaces and signs do not matter. Nothing for
/// names that are unknown.
inline std::optional<double> unit_of_heights_m(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c - 'A' + 'a');
    if (c >= 'a' && c <= 'z') letters += c;
  }
  for (const HeightUnitName& unit : kHeightUnitNames)
    if (unit.name == letters) return unit.metres;
  return std::nullopt;
}

}  // namespace citykiln::source
