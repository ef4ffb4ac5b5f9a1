#include "compiler/commands/print_check_results.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "compiler/ground/grading/bend_points.h"
#include "compiler/ground/profiles/crossings/ground_crossings.h"

namespace citykiln::commands {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson print_check(const verify::Check& check, const Console& console) {
  const bool holds = check.failures.empty();
  console.print_line(
      fmt::format("{} {}: {}", holds ? "holds" : "FAILS", check.claim,
                  holds ? fmt::format("not falsified by {} tests", check.tests) : check.failures.front().text));
  if (check.failures.size() > 1)
    console.print_line(fmt::format("      and {} more failures", check.failures.size() - 1));
  OrderedJson failures = OrderedJson::array();
  for (const verify::Failure& failure : check.failures) failures.push_back(failure.text);
  return {{"guarantee", check.claim}, {"tests", check.tests}, {"failures", std::move(failures)}};
}

OrderedJson print_measure(const verify::Grades& grades, const Console& console) {
  console.print_line(fmt::format("info  {:.1f} km of {:.1f} km of graded roads exceed the grade limit of their class",
                                 grades.over_m / 1000, grades.length_m / 1000));
  return {{"measure", "length of graded roads over the grade limit of their class"},
          {"length_m", grades.length_m},
          {"over_m", grades.over_m}};
}

OrderedJson shortfall_json(const verify::ClearanceShortfall& s) {
  return {{"missing_m", s.missing_m},
          {"upper", to_string(s.upper)},
          {"lower", to_string(s.lower)},
          {"at", {s.at.x, s.at.y}},
          {"tags", s.tags}};
}

OrderedJson shortfall_json(std::span<const verify::ClearanceShortfall> shortfalls) {
  OrderedJson json = OrderedJson::array();
  for (const verify::ClearanceShortfall& s : shortfalls) json.push_back(shortfall_json(s));
  return json;
}

// Shortfalls that the map's tags cause are counted separately.
OrderedJson print_measure(const verify::Clearances& c, const Console& console) {
  const verify::ClearanceShortfall worst = c.shortfalls.empty() ? verify::ClearanceShortfall{} : c.shortfalls.front();
  console.print_line(fmt::format(
      "info  {} of {} crossings have too little clearance, {} by over 1 m, {} by over 3 m; the largest shortfall is "
      "{:.2f} m, {} over {} at {}, {}",
      c.shortfalls.size(), c.crossings, c.count_over(1), c.count_over(3), worst.missing_m, to_string(worst.upper),
      to_string(worst.lower), worst.at.x, worst.at.y));
  console.print_line(
      fmt::format("info  {} more have too little clearance because the map's tags do not say which line is above",
                  c.contradictions.size()));
  return {{"measure", "crossings with too little clearance"},
          {"crossings", c.crossings},
          {"shortfalls", c.shortfalls.size()},
          {"shortfalls_over_1_m", c.count_over(1)},
          {"shortfalls_over_3_m", c.count_over(3)},
          {"largest_shortfall_m", worst.missing_m},
          {"upper", to_string(worst.upper)},
          {"lower", to_string(worst.lower)},
          {"at", {worst.at.x, worst.at.y}},
          {"places", shortfall_json(c.shortfalls)},
          {"contradictions", shortfall_json(c.contradictions)}};
}

// The count of all, and the worst of those over the limit of their kind.
OrderedJson print_measure(std::size_t earthworks, std::span<const verify::DeepEarthwork> over, const Console& console) {
  constexpr std::size_t kPrinted = 5;
  const auto unexplained = std::ranges::count_if(
      over, [](const verify::DeepEarthwork& deep) { return deep.reason >= verify::EarthworkReason::kNone; });
  console.print_line(
      fmt::format("info  {} of {} cuts and fills of over 0.5 m exceed the limit of their kind; no "
                  "finding, landform, bridge or tunnel explains {} of them",
                  over.size(), earthworks, unexplained));
  OrderedJson places = OrderedJson::array();
  for (std::size_t i = 0; i < over.size(); ++i) {
    const verify::Earthwork& e = over[i].earthwork;
    if (i < kPrinted)
      console.print_line(fmt::format("      {} of {:.1f} m of {} {}, limit {} m, at {:.0f}, {:.0f}",
                                     e.depth_m > 0 ? "cut" : "fill", std::abs(e.depth_m), e.line, to_string(e.id),
                                     verify::earthwork_limit_m(e.line), e.at.x, e.at.y));
    places.push_back({{"line", e.line},
                      {"id", to_string(e.id)},
                      {"depth_m", e.depth_m},
                      {"at", {e.at.x, e.at.y}},
                      {"reason", name_of(over[i].reason)}});
  }
  if (over.size() > kPrinted) console.print_line(fmt::format("      and {} more", over.size() - kPrinted));
  return {{"measure", "cuts and fills over the limit of their kind"},
          {"earthworks", earthworks},
          {"unexplained", unexplained},
          {"over", std::move(places)}};
}

OrderedJson print_measure(std::span<const verify::CrossingStep> steps, const Console& console) {
  constexpr std::size_t kPrinted = 5;
  console.print_line(fmt::format(
      "info  {} pairs of ways on the ground cross without a common node at heights that differ by over {} m",
      steps.size(), ground::kSmallStep_m));
  OrderedJson places = OrderedJson::array();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const verify::CrossingStep& s = steps[i];
    if (i < kPrinted)
      console.print_line(fmt::format("      {:.1f} m between {} and {} at {:.0f}, {:.0f}", s.step_m, to_string(s.first),
                                     to_string(s.second), s.at.x, s.at.y));
    places.push_back({{"first", to_string(s.first)},
                      {"second", to_string(s.second)},
                      {"step_m", s.step_m},
                      {"at", {s.at.x, s.at.y}}});
  }
  if (steps.size() > kPrinted) console.print_line(fmt::format("      and {} more", steps.size() - kPrinted));
  return {{"measure", "steps where ways on the ground cross"}, {"places", std::move(places)}};
}

// Ways into walls without an opening for them; some end inside, others lack a tag or a finding says more.
OrderedJson print_measure(std::span<const verify::WayIntoWall> ways, const Console& console) {
  const auto worst = std::ranges::max_element(ways, {}, &verify::WayIntoWall::area_m2);
  console.print_line(fmt::format(
      "info  {} pairs of a way and a building meet without an opening{}", ways.size(),
      worst == ways.end()
          ? ""
          : fmt::format(", the worst {} into {} by {:.1f} m² of wall at {:.0f}, {:.0f}", to_string(worst->way),
                        to_string(worst->building), worst->area_m2, worst->at.x, worst->at.y)));
  OrderedJson places = OrderedJson::array();
  for (const verify::WayIntoWall& w : ways)
    places.push_back({{"way", to_string(w.way)},
                      {"building", to_string(w.building)},
                      {"area_m2", w.area_m2},
                      {"at", {w.at.x, w.at.y}}});
  return {{"measure", "ways that meet a building without an opening"}, {"places", std::move(places)}};
}

OrderedJson print_measure(std::span<const verify::BlankWall> walls, const Console& console) {
  double sum_m2 = 0;
  OrderedJson places = OrderedJson::array();
  for (const verify::BlankWall& w : walls) {
    sum_m2 += w.area_m2;
    places.push_back({{"building", to_string(w.building)}, {"area_m2", w.area_m2}, {"at", {w.at.x, w.at.y}}});
  }
  const auto worst = std::ranges::max_element(walls, {}, &verify::BlankWall::area_m2);
  console.print_line(fmt::format(
      "info  {} buildings with windows have {:.0f} m² of blank wall more than a storey above the ground{}",
      walls.size(), sum_m2,
      worst == walls.end() ? ""
                           : fmt::format(", the worst {} with {:.0f} m² at {:.0f}, {:.0f}", to_string(worst->building),
                                         worst->area_m2, worst->at.x, worst->at.y)));
  return {{"measure", "blank walls more than a storey above the ground"},
          {"area_m2", sum_m2},
          {"places", std::move(places)}};
}

OrderedJson print_measure(const verify::ReferenceErrors& f, const Console& console) {
  const double share = static_cast<double>(f.over) / static_cast<double>(std::max<std::uint64_t>(f.places, 1));
  console.print_line(
      fmt::format("info  {:.2f} % of {} places on the ground mesh deviate by over {} m, the largest by {:.2f} m at "
                  "{:.2f}, {:.2f}",
                  100 * share, f.places, 2 * ground::kReferenceError_m, f.largest_m, f.at.x, f.at.y));
  return {{"measure", "places where the ground mesh deviates from the graded terrain"},
          {"places", f.places},
          {"over", f.over},
          {"largest_m", f.largest_m}};
}

OrderedJson print_folder(const verify::CheckResults& results, const Console& console) {
  if (!results.unlisted.empty())
    console.print_line(fmt::format("info  {} files in the folder are not of the run: {}", results.unlisted.size(),
                                   fmt::join(results.unlisted, ", ")));
  if (results.has_unfinished_run)
    console.print_line("info  a later run into the folder was interrupted; the same command goes on with it");
  return {{"measure", "files in the folder that are not of the run"},
          {"names", results.unlisted},
          {"has_unfinished_run", results.has_unfinished_run}};
}

}  // namespace

void print(const verify::CheckResults& results, const Console& console) {
  OrderedJson json = OrderedJson::array();
  for (const verify::Check* check : verify::all_of(results)) json.push_back(print_check(*check, console));
  json.push_back(print_folder(results, console));
  json.push_back(print_measure(results.grades, console));
  json.push_back(print_measure(results.clearances, console));
  json.push_back(print_measure(results.crossing_steps, console));
  json.push_back(print_measure(results.earthworks.size(), results.deep_earthworks, console));
  json.push_back(print_measure(results.ways_into_walls, console));
  json.push_back(print_measure(results.blank_walls, console));
  json.push_back(print_measure(results.reference_errors, console));
  console.print_json(json.dump(1));
}

}  // namespace citykiln::commands
