#include "compiler/verify/heights_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace citykiln::verify {
namespace {

using OrderedJson = nlohmann::ordered_json;

double share(double part, double whole) { return whole > 0 ? part / whole : 0; }

OrderedJson clearances_of(const Clearances& measured) {
  return {{"crossings", measured.crossings},
          {"shortfalls", measured.shortfalls.size()},
          {"shortfalls_over_1_m", measured.count_over(1)},
          {"shortfalls_over_3_m", measured.count_over(3)},
          {"largest_shortfall_m", measured.largest_m()},
          {"contradictions", measured.contradictions.size()}};
}

OrderedJson clearances_of(const ground::ProfileMeasures& planned) {
  return {{"crossings", planned.crossings},
          {"shortfalls", planned.shortfalls},
          {"shortfalls_over_1_m", planned.shortfalls_over_1_m},
          {"shortfalls_over_3_m", planned.shortfalls_over_3_m},
          {"largest_shortfall_m", planned.largest_shortfall_m},
          {"contradictions", planned.contradictions}};
}

}  // namespace

nlohmann::ordered_json heights_json(const HeightReport& heights) {
  const HeightMeasures& m = heights.recipes;
  OrderedJson json = {{"graded_length_m", m.grades.length_m},
                      {"length_over_grade_limit_m", m.grades.over_m},
                      {"share_over_grade_limit", share(m.grades.over_m, m.grades.length_m)},
                      {"largest_height_step_m", m.jumps.largest_m},
                      {"largest_gap_road_to_ground_m", m.road_faces.largest_gap_m},
                      {"watercourses_flowing_uphill", m.rises.rising},
                      {"largest_uphill_rise_m", m.rises.largest_m},
                      {"lakes_not_level", m.lakes.not_level},
                      {"buildings_above_ground", m.footing.floating.size()},
                      {"largest_gap_below_building_m", std::max(0.0, m.footing.largest_gap_m)}};
  json["clearances"] = clearances_of(m.clearances);
  if (heights.planned) json["planned_clearances"] = clearances_of(*heights.planned);
  return json;
}

}  // namespace citykiln::verify
