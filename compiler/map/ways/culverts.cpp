#include "compiler/map/ways/culverts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/line_part.h"
#include "compiler/geometry/segment.h"

namespace citykiln::map {
namespace {

constexpr double kDamBucket_m = 64;
// A dam's foot lies up to its height beside its top, a dyke's twice as far.
double foot_m(const Landform& form) {
  return form.width_m / 2 + form.height_m * (form.kind == LandformKind::kRidge ? 2 : 1);
}

bool is_crossed_by_water(const Landform& form) {
  return form.kind == LandformKind::kDam || form.kind == LandformKind::kRidge;
}

// The distances along a line at which it crosses another.
std::vector<double> crossings_m(const Polyline& line, const std::vector<double>& along, const Polyline& other) {
  std::vector<double> crossings;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (std::size_t k = 0; k + 1 < other.size(); ++k)
      if (const auto shares = crossing_shares(line[i], line[i + 1], other[k], other[k + 1]))
        crossings.push_back(along[i] + (along[i + 1] - along[i]) * shares->first);
  return crossings;
}

// The distance at which a culvert ends that begins at a crossing: the first step along the line beyond the dam's foot.
double end_of_culvert_m(const Polyline& line, const std::vector<double>& along, double at_m, double step_m,
                        const Landform& form) {
  const double foot = foot_m(form), end_m = step_m < 0 ? 0 : along.back(), steps = 3 * foot / std::abs(step_m);
  for (double i = 0; i < steps; ++i, at_m += step_m) {
    if (step_m < 0 ? at_m <= end_m : at_m >= end_m) return end_m;
    if (distance_to_polyline(form.axis, point_at(line, along, at_m)) >= foot) return at_m;
  }
  return at_m;
}

std::vector<LinePart> merged_parts(std::vector<LinePart> parts) {
  std::ranges::sort(parts, {}, &LinePart::from_m);
  std::vector<LinePart> merged;
  for (const LinePart& part : parts)
    if (!merged.empty() && part.from_m <= merged.back().to_m)
      merged.back().to_m = std::max(merged.back().to_m, part.to_m);
    else
      merged.push_back(part);
  return merged;
}

std::vector<Waterway> split_at(const Waterway& water, const std::vector<double>& along,
                               std::span<const LinePart> culverts) {
  std::vector<Waterway> parts;
  const auto add = [&](const LinePart& part, Passage passage) {
    Polyline axis = snapped_line(points_of(water.axis, along, part));
    if (axis.size() < 2) return;
    parts.push_back(water);
    parts.back().id.part += static_cast<std::uint32_t>(parts.size() - 1);
    parts.back().axis = std::move(axis), parts.back().passage = passage;
  };
  double from_m = 0;
  for (const LinePart& culvert : culverts) {
    add({from_m, culvert.from_m}, Passage::kGround);
    add(culvert, Passage::kTunnel);
    from_m = culvert.to_m;
  }
  add({from_m, along.back()}, Passage::kGround);
  return parts;
}

// The parts of a watercourse inside the landforms that it crosses.
std::vector<LinePart> culverts_of(const Waterway& water, const std::vector<double>& along,
                                  std::span<const std::uint32_t> near, std::span<const Landform> dams) {
  constexpr double kStep_m = 0.5;
  std::vector<LinePart> culverts;
  for (const std::uint32_t i : near)
    for (const double at_m : crossings_m(water.axis, along, dams[i].axis))
      culverts.push_back({end_of_culvert_m(water.axis, along, at_m, -kStep_m, dams[i]),
                          end_of_culvert_m(water.axis, along, at_m, kStep_m, dams[i])});
  return merged_parts(std::move(culverts));
}

}  // namespace

std::vector<Waterway> with_culverts(std::vector<Waterway> waterways, std::span<const Landform> landforms) {
  std::vector<Landform> dams;
  std::ranges::copy_if(landforms, std::back_inserter(dams), is_crossed_by_water);
  std::vector<Box2> boxes;
  for (const Landform& dam : dams) boxes.push_back(box_of(dam.axis));
  const BoxGrid grid = grid_of(boxes, kDamBucket_m);
  std::vector<Waterway> all;
  for (Waterway& water : waterways) {
    const std::vector<double> along = distances_on(water.axis);
    std::vector<LinePart> culverts;
    if (water.passage == Passage::kGround)
      culverts = culverts_of(water, along, boxes_about(grid, box_of(water.axis)), dams);
    if (culverts.empty())
      all.push_back(std::move(water));
    else
      std::ranges::move(split_at(water, along, culverts), std::back_inserter(all));
  }
  return all;
}

}  // namespace citykiln::map
