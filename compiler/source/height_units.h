// The units of heights that files declare, by their usual names. Header-only, since the GDAL module uses it too.
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
                                                      {"usfoot", kSurveyFoot_m},
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
                                                      {"kilometres", 1000},
                                                      {"kilometers", 1000},
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

/// Returns the metres of a unit by its name, such as 0.3048 for "ft", "Foot" and "feet". Capitals, spaces and
/// punctuation do not matter. Returns nothing for unknown names, and for those with digits or letters beyond ASCII.
inline std::optional<double> unit_of_heights_m(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    if ((c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80) return std::nullopt;
    if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c - 'A' + 'a');
    if (c >= 'a' && c <= 'z') letters += c;
  }
  for (const HeightUnitName& unit : kHeightUnitNames)
    if (unit.name == letters) return unit.metres;
  return std::nullopt;
}

}  // namespace citykiln::source
