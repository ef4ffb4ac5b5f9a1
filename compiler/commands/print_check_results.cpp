#include "compiler/commands/print_check_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compiler/ground/grading/bend_points.h"

namespace citykiln::commands {
namespace {

using Json = nlohmann::ordered_json;

Json print_check(const verify::Check& check, const Console& console) {
  const bool holds = check.failures.empty();
  console.print_line(
      fmt::format("{} {}: {}", holds ? "holds " : "BROKEN", check.claim,
                  holds ? fmt::format("not falsified by {} tests", check.tests) : check.failures.front()));
  if (check.failures.size() > 1)
    console.print_line(fmt::format("       and {} breaches more", check.failures.size() - 1));
  return {{"claim", check.claim}, {"tests", check.tests}, {"failures", check.failures}};
}

Json print_measure(const verify::Grades& grades, const Console& console) {
  console.print_line(fmt::format("stated {:.1f} km of {:.1f} km of graded roads are over their class's limit",
                                 grades.over_m / 1000, grades.length_m / 1000));
  return {{"print_measure", "length of graded roads over their class's limit"},
          {"length_m", grades.length_m},
          {"over_m", grades.over_m}};
}

Json print_measure(const verify::Clearances& c, const Console& console) {
  console.print_line(fmt::format(
      "stated {} of {} crossings lack clearance, {} over 1 m, {} over 3 m; most, {:.2f} m, {} over {} at {}, {}",
      c.shortfalls, c.crossings, c.shortfalls_over_1_m, c.shortfalls_over_3_m, c.largest_shortfall_m,
      to_string(c.upper), to_string(c.lower), c.at.x, c.at.y));
  return {{"print_measure", "crossings that lack clearance"},
          {"crossings", c.crossings},
          {"shortfalls", c.shortfalls},
          {"shortfalls_over_1_m", c.shortfalls_over_1_m},
          {"shortfalls_over_3_m", c.shortfalls_over_3_m},
          {"largest_shortfall_m", c.largest_shortfall_m},
          {"upper", to_string(c.upper)},
          {"lower", to_string(c.lower)},
          {"at", {c.at.x, c.at.y}}};
}

Json print_measure(const verify::ReferenceErrors& f, const Console& console) {
  const double share = static_cast<double>(f.over) / static_cast<double>(std::max<std::uint64_t>(f.places, 1));
  console.print_line(
      fmt::format("stated {:.2f} % of {} places stray from the carved heights by over {} m, the worst by {:.2f} m at "
                  "{:.2f}, {:.2f}",
                  100 * share, f.places, 2 * ground::kReferenceError_m, f.largest_m, f.at.x, f.at.y));
  return {{"print_measure", "places where the triangulated ground strays from the carved heights"},
          {"places", f.places},
          {"over", f.over},
          {"largest_m", f.largest_m}};
}

}  // namespace

void print(const verify::CheckResults& results, const Console& console) {
  Json json = Json::array();
  for (const verify::Check* check : verify::all_of(results)) json.push_back(print_check(*check, console));
  json.push_back(print_measure(results.grades, console));
  json.push_back(print_measure(results.clearances, console));
  json.push_back(print_measure(results.reference_errors, console));
  console.print_json(json.dump(1));
}

}  // namespace citykiln::commands
