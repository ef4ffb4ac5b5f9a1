#include "compiler/ground/profiles/measure_profiles.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "compiler/ground/profiles/crossings/crossings.h"
#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/ground/profiles/smoothing/profile_knots.h"

namespace citykiln::ground {
namespace {

void measure_grade(const Profile& profile, double length_m, GradeMeasure& measure) {
  const double limit = grade_rule_of(measure.surface).limit;
  measure.length_m += length_m;
  for (std::size_t i = 1; i < profile.size(); ++i) {
    const double run_m = profile[i].at_m - profile[i - 1].at_m, rise_m = std::abs(profile[i].z_m - profile[i - 1].z_m);
    if (rise_m > limit * run_m + 2 * kKnotError_m) measure.over_m += run_m;
    if (run_m >= 2) measure.steepest = std::max(measure.steepest, rise_m / run_m);
  }
}

void measure_grades(const ProfileGraph& graph, const Profiles& profiles, ProfileMeasures& measures) {
  std::map<map::LandCoverClass, GradeMeasure> classes;
  for (const GraphWay& way : graph.ways) {
    GradeMeasure& measure = classes[way.track->surface];
    measure.surface = way.track->surface;
    measures.knots += profile_of(profiles, way).size();
    measure_grade(profile_of(profiles, way), graph.stations_of(way).back().at_m, measure);
  }
  for (const auto& [surface, measure] : classes) {
    measures.classes.push_back(measure);
    if (!has_profile(surface)) continue;
    measures.length_m += measure.length_m, measures.over_m += measure.over_m;
  }
}

void measure_jumps(const ProfileGraph& graph, const Profiles& profiles, ProfileMeasures& measures) {
  std::vector<std::pair<double, double>> between(graph.nodes.size(), {1e9, -1e9});
  for (const GraphWay& way : graph.ways) {
    for (const Station& station : graph.stations_of(way)) {
      const double z_m = height_m_of(profiles, way, station.at_m);
      auto& [low, high] = between[station.node];
      low = std::min(low, z_m), high = std::max(high, z_m);
      measures.largest_jump_m = std::max(measures.largest_jump_m, high - low);
    }
  }
}

void measure_shortfalls(std::span<const ClearanceShortfall> shortfalls, ProfileMeasures& measures) {
  measures.crossings = shortfalls.size();
  for (const ClearanceShortfall& lack : shortfalls) {
    if (lack.is_contradictory) {
      measures.contradictions += lack.shortfall_m > kShortfallMargin_m;
      continue;
    }
    measures.shortfalls += lack.shortfall_m > kShortfallMargin_m, measures.shortfalls_over_1_m += lack.shortfall_m > 1;
    measures.shortfalls_over_3_m += lack.shortfall_m > 3;
    measures.largest_shortfall_m = std::max(measures.largest_shortfall_m, lack.shortfall_m);
  }
}

}  // namespace

ProfileMeasures measure_profiles(const map::FeatureView& features, const Profiles& profiles) {
  ProfileMeasures measures;
  const ProfileGraph graph = graph_of(features, profiles.roads, {});
  measure_grades(graph, profiles, measures);
  measure_jumps(graph, profiles, measures);
  measure_shortfalls(profiles.shortfalls, measures);
  return measures;
}

}  // namespace citykiln::ground
