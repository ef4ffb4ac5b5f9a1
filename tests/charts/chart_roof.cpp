// Failures and cost of roofs by straight skeletons, over the corners of a map's footprints: a floating-point kernel, an
// exact kernel, and citykiln's combination.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "grammars/roofs/generate_roof.h"
#include "tests/charts/chart.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

using roofs::RoofForm;

constexpr double kRoofTolerance_m = 0.02;

/// Upper limits of the classes of footprints by corners; each class begins above the limit before.
constexpr std::size_t kCorners[] = {3, 6, 10, 16, 28, 64};
/// The largest number of footprints measured in a class, evenly chosen, since the exact kernel is slow.
constexpr std::size_t kMost = 300;

/// One form for each use of the skeleton: hips only, gables at the ends, two slopes in each face.
constexpr RoofForm kForms[] = {RoofForm::kHipped, RoofForm::kGabled, RoofForm::kMansard};

using Roofer = bool (*)(const Polygon& footprint, const roofs::RoofShape& shape);

template <SkeletonKernel kernel>
bool by_kernel(const Polygon& footprint, const roofs::RoofShape& shape) {
  return roofs::roof_by_skeleton(footprint, shape, kRoofTolerance_m, kernel).has_value();
}

bool as_built(const Polygon& footprint, const roofs::RoofShape& shape) {
  Report report;
  roofs::generate_roof(footprint, shape, kRoofTolerance_m, {}, report);
  return report.diagnoses().empty();
}

struct RoofMethod {
  const char* name;
  Roofer roof;
};
constexpr RoofMethod kRoofMethods[] = {{"inexact skeleton", by_kernel<SkeletonKernel::kInexact>},
                                       {"exact skeleton", by_kernel<SkeletonKernel::kExact>},
                                       {"as citykiln builds it", as_built}};

std::size_t corners_of(const Polygon& footprint) {
  std::size_t count = footprint.outer.size();
  for (const Ring& hole : footprint.holes) count += hole.size();
  return count;
}

using Classes = std::array<std::vector<Polygon>, std::size(kCorners)>;

Classes by_corners(const scene::Scene& scene) {
  Classes classes;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const buildings::Building& building : chunk.buildings) {
      const auto at = std::lower_bound(std::begin(kCorners), std::end(kCorners), corners_of(building.footprint));
      if (at != std::begin(kCorners)) classes[at - std::begin(kCorners) - 1].push_back(building.footprint);
    }
  return classes;
}

/// At most kMost footprints, evenly chosen.
std::vector<Polygon> some_of(const std::vector<Polygon>& all) {
  std::vector<Polygon> some;
  const std::size_t count = std::min(kMost, all.size());
  for (std::size_t i = 0; i < count; ++i) some.push_back(all[i * all.size() / count]);
  return some;
}

struct Outcome {
  double failed_percent = 0, us = 0;
};

Outcome outcome_of(const RoofMethod& method, RoofForm form, const std::vector<Polygon>& footprints) {
  roofs::RoofShape shape;
  shape.form = form;
  const Stopwatch watch;
  const auto failed = std::ranges::count_if(footprints, [&](const Polygon& f) { return !method.roof(f, shape); });
  const double us = watch.microseconds();
  const auto count = static_cast<double>(footprints.size());
  return {100 * static_cast<double>(failed) / count, us / count};
}

double mean_corners(const std::vector<Polygon>& footprints) {
  double sum = 0;
  for (const Polygon& footprint : footprints) sum += static_cast<double>(corners_of(footprint));
  return sum / static_cast<double>(footprints.size());
}

void measure_roofs(const RoofMethod& method, RoofForm form, const Classes& classes, Series& failures, Series& time) {
  failures.name = time.name = fmt::format("{}: {}", roofs::name_of(form), method.name);
  for (const std::vector<Polygon>& footprints : classes) {
    if (footprints.empty()) continue;
    const Outcome outcome = outcome_of(method, form, footprints);
    failures.points.emplace_back(mean_corners(footprints), outcome.failed_percent);
    time.points.emplace_back(mean_corners(footprints), outcome.us);
  }
}

}  // namespace

Result<std::vector<Chart>> chart_roof(const ChartRequest& request) {
  const Result<scene::Scene> scene = compile_first_map(request);
  if (!scene) return scene.error();
  Classes classes = by_corners(*scene);
  std::size_t count = 0;
  for (std::vector<Polygon>& footprints : classes) count += (footprints = some_of(footprints)).size();
  if (count == 0) return Error{request.maps.front(), "has no buildings"};
  const Axis corners{"corners of the footprint, mean of the class", true};
  Chart failures{"roof_failures", fmt::format("Roofs that fail: {} footprints", count), corners, {"share (%)"}, {}};
  Chart time{"roof_time", "Time for a roof", corners, {"microseconds", true}, {}};
  for (const RoofForm form : kForms)
    for (const RoofMethod& method : kRoofMethods)
      measure_roofs(method, form, classes, failures.series.emplace_back(), time.series.emplace_back());
  return std::vector{failures, time};
}

}  // namespace citykiln::charts
