#include "grammars/roofs/generate_roof.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "compiler/geometry/box.h"
#include "compiler/geometry/snap.h"
#include "grammars/roofs/apex.h"
#include "grammars/roofs/inset_facets.h"
#include "grammars/roofs/outline.h"
#include "grammars/roofs/raise_facets.h"
#include "grammars/roofs/roof_input.h"
#include "grammars/roofs/strips.h"

namespace citykiln::roofs {
namespace {

// A footprint has wings if it fills less of its box, or has a wall along the ridge between kMiddle and 1 - kMiddle of
// the width that is longer than this share of the box.
constexpr double kFillsItsBox = 0.75, kMiddle = 0.25, kLongWall = 0.15;
// Smaller bends of walls are removed before a skeleton is made: they are below the accuracy of mapping. The value does
// not depend on the tolerance, because a skeleton may change its shape for any bend, which no error could bound.
constexpr double kDrop_m = 0.03;
// A skeleton of more corners takes seconds, with exact numbers one of kMostExactCorners.
constexpr std::size_t kMostInexactCorners = 1000, kMostExactCorners = 250;
// Tests for a wrong skeleton: the largest height difference where faces meet; the largest uncovered share of the
// footprint; the largest square of the span as a share of the area, which is 1 / π for a disc and somewhat more with
// gables.
constexpr double kMostGap_m = 0.05, kMostUncovered = 0.01, kMostSpan = 0.7;

Roof finished(RaisedRoof raised, RoofForm form, double error_m) {
  raised.roof.form = form;
  raised.roof.error_m = error_m;
  return std::move(raised.roof);
}

// The error of a roof together with that of eaves left out, which overhang and lift the roof.
double with_eaves_m(const RoofInput& input, double error_m) {
  return length(Vec2{input.left_out_m.x, input.left_out_m.y + error_m});
}

// False if the roof may be flat at the tolerance. With visible eaves it may not, because they would be too high.
bool is_seen(const RoofInput& input, double rise_m) {
  return rise_m > 0 && (!input.eaves.outer.empty() || rise_m > input.tolerance_m);
}

RoofPlan plan_on(const RoofInput& input, std::vector<Facet> facets) {
  return {std::move(facets), input.eaves, kThickness_m};
}

Ring box_about(const RoofInput& input) {
  const Box2 box = box_of(input.eaves.outer.empty() ? input.footprint.outer : input.eaves.outer).widened(2);
  return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}

Roof flat_roof(const RoofInput& input, double rise_m) {
  const Facet all{.ring = box_about(input), .plane = {input.footprint.outer.front(), {}, 0}};
  return finished(raise_facets(input.footprint, plan_on(input, {all})), RoofForm::kFlat, with_eaves_m(input, rise_m));
}

// ---- one section along a line

Roof striped(const RoofInput& input) {
  const bool has_direction = input.shape.direction.has_value();
  const double rise_m = rise_of(input.shape, strip_span_m(input.shape.form, input.box, has_direction));
  if (!is_seen(input, rise_m)) return flat_roof(input, rise_m);
  const double reach_m = 2 * input.shape.overhang_m + 1;
  Strips made = strips(input.shape.form, input.box, has_direction, rise_m, reach_m, input.tolerance_m);
  const double error_m = with_eaves_m(input, made.error_m);
  return finished(raise_facets(input.footprint, plan_on(input, std::move(made.facets))), input.shape.form, error_m);
}

// ---- a section over inset facets

std::optional<Roof> over_inset(const RoofInput& input, const InsetFacets& inset, double area, double drop_m) {
  if (inset.span_m <= 0) return std::nullopt;
  const double rise_m = rise_of(input.shape, inset.span_m);
  if (!is_seen(input, rise_m)) return flat_roof(input, rise_m);
  const Section section = section_over_skeleton(input.shape.form, inset.span_m, rise_m, input.tolerance_m,
                                                knee_of(input.shape, inset.span_m));
  RoofPlan plan = plan_on(input, lift_section(inset, section, rise_m));
  const double steepest = rise_m * (section.corners[1].y / section.corners[1].x) / inset.span_m;
  plan.flush_m += drop_m * steepest;
  RaisedRoof raised = raise_facets(input.footprint, plan);
  const bool is_whole = raised.uncovered_m2 <= kMostUncovered * area + drop_m * length_m(input.footprint.outer);
  if (!is_whole || raised.largest_gap_m > kMostGap_m * std::max(1.0, steepest)) return std::nullopt;
  return finished(std::move(raised), input.shape.form, with_eaves_m(input, section.error_m));
}

// True if a direction is along the box, to its front end or to either end.
bool faces_front_end(const RoofInput& input, Vec2 outward) { return dot(outward, input.box.along) > 0.7071; }
bool faces_along_box(const RoofInput& input, Vec2 outward) {
  return faces_front_end(input, outward) || faces_front_end(input, outward * -1);
}

WingEnd end_at(const RoofInput& input, Vec2 outward) {
  const WingEnd end = form_row(input.shape.form).end;
  if (end != WingEnd::kHipAndGable) return end;
  return faces_front_end(input, outward) ? WingEnd::kGable : WingEnd::kHip;
}

std::vector<Plane> inward_planes(const Ring& ring) {
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < ring.size(); ++i)
    planes.push_back(distance_left_of(ring[i], ring[(i + 1) % ring.size()]));
  return planes;
}

// The ends of a convex footprint: the plane of a gable is left out, that of a half hip starts half way up.
void open_ends(const RoofInput& input, std::vector<Plane>& planes) {
  const double span_m = span_over(input.footprint.outer, planes);
  const auto is_gable = [&](const Plane& p) {
    const Vec2 outward = p.gradient * -1;
    return faces_along_box(input, outward) && end_at(input, outward) == WingEnd::kGable;
  };
  for (Plane& p : planes)
    if (faces_along_box(input, p.gradient * -1) && end_at(input, p.gradient * -1) == WingEnd::kHalfHip)
      p.offset += span_m / 2;
  planes.erase(std::remove_if(planes.begin(), planes.end(), is_gable), planes.end());
}

std::optional<Roof> enveloped(const RoofInput& input, const std::vector<Plane>& planes) {
  InsetFacets inset = envelope_facets(input.eaves.outer.empty() ? input.footprint.outer : box_about(input), planes);
  inset.span_m = span_over(input.footprint.outer, planes);
  return over_inset(input, inset, area_m2(input.footprint), 0);
}

std::optional<Roof> hipped_convex(const RoofInput& input) {
  std::vector<Plane> planes = inward_planes(input.footprint.outer);
  open_ends(input, planes);
  return enveloped(input, planes);
}

// The sides of a pyramid are planes through its apex: an envelope that extends over eaves.
std::optional<Roof> pyramid_convex(const RoofInput& input, Vec2 apex) {
  std::vector<Plane> planes = inward_planes(input.footprint.outer);
  const double span_m = apex_span_m(input.footprint.outer, apex);
  for (Plane& plane : planes) plane.gradient = plane.gradient * (span_m / plane.at(apex));
  return enveloped(input, planes);
}

// ---- the straight skeleton

std::size_t corner_count(const std::vector<Polygon>& polygons) {
  std::size_t count = 0;
  for (const Polygon& polygon : polygons) {
    count += polygon.outer.size();
    for (const Ring& hole : polygon.holes) count += hole.size();
  }
  return count;
}

// One piece. If the skeleton of a convex piece fails, its envelope is used, which is equal. Another piece stays
// uncovered, which over_inset() tests.
InsetFacets inset_of(const RoofInput& input, const Polygon& piece, SkeletonKernel kernel, std::uint32_t first_face) {
  InsetFacets inset = skeleton_facets(
      piece, kernel, [&](Vec2 outward) { return end_at(input, outward); }, first_face);
  if (!inset.facets.empty() || !is_convex(piece)) return inset;
  inset = envelope_facets(piece.outer, inward_planes(piece.outer));
  for (Facet& facet : inset.facets) facet.face += first_face;
  return inset;
}

InsetFacets skeleton_inset(const RoofInput& input, const std::vector<Polygon>& polygons, SkeletonKernel kernel) {
  InsetFacets all;
  std::uint32_t first_face = 0;
  const double overhang_m = input.eaves.outer.empty() ? 0 : input.shape.overhang_m;
  for (const Polygon& polygon : polygons) {
    InsetFacets inset = inset_of(input, polygon, kernel, first_face);
    first_face += static_cast<std::uint32_t>(corner_count({polygon}));
    for (Facet& facet : inset.facets) facet.plane.offset -= overhang_m, all.facets.push_back(std::move(facet));
    all.span_m = std::max(all.span_m, inset.span_m - overhang_m);
  }
  return all;
}

// The footprint in simple pieces, without small bends where it stays simple without them.
std::vector<Polygon> skeleton_plan(const RoofInput& input) {
  std::vector<Polygon> polygons = split_into_simple(input.eaves.outer.empty() ? input.footprint : input.eaves);
  for (Polygon& polygon : polygons) {
    Polygon simple = simplified(polygon, kDrop_m);
    if (is_simple_polygon(simple)) polygon = std::move(simple);
  }
  return polygons;
}

std::optional<Roof> by_skeleton(const RoofInput& input, const std::vector<Polygon>& polygons, SkeletonKernel kernel) {
  const std::size_t corners = corner_count(polygons);
  if (corners > (kernel == SkeletonKernel::kExact ? kMostExactCorners : kMostInexactCorners)) return std::nullopt;
  const InsetFacets inset = skeleton_inset(input, polygons, kernel);
  double area = 0;
  for (const Polygon& polygon : polygons) area += area_m2(polygon);
  if (inset.span_m * inset.span_m > kMostSpan * area) return std::nullopt;
  return over_inset(input, inset, area, kDrop_m);
}

std::optional<Roof> by_skeleton(const RoofInput& input) {
  const std::vector<Polygon> polygons = skeleton_plan(input);
  for (const SkeletonKernel kernel : {SkeletonKernel::kInexact, SkeletonKernel::kExact})
    if (std::optional<Roof> roof = by_skeleton(input, polygons, kernel)) return roof;
  return std::nullopt;
}

// ---- which method

// True for a long wall in the middle of the width (kMiddle, kLongWall).
bool stands_inside(const OrientedBox& box, Vec2 a, Vec2 b) {
  const double across = (box.across_m((a + b) * 0.5) - box.back_m) / box.width_m();
  return across > kMiddle && across < 1 - kMiddle && std::abs(dot(box.along, b - a)) > kLongWall * box.length_m() &&
         std::abs(dot(box.along, b - a)) > std::abs(dot(box.across, b - a));
}

bool has_wall_inside(const OrientedBox& box, const Ring& ring) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    if (stands_inside(box, ring[j], ring[i])) return true;
  return false;
}

bool has_wings(const RoofInput& input) {
  const double box_m2 = input.box.width_m() * input.box.length_m();
  if (area_m2(input.footprint) < kFillsItsBox * box_m2 || has_wall_inside(input.box, input.footprint.outer))
    return true;
  return std::any_of(input.footprint.holes.begin(), input.footprint.holes.end(),
                     [&](const Ring& hole) { return has_wall_inside(input.box, hole); });
}

// An onion swells by less than this share of its radius at the eaves.
constexpr double kMostSwelling = 0.2;

std::optional<Roof> over_apex(const RoofInput& input) {
  const Ring& ring = input.footprint.outer;
  const std::optional<Vec2> apex = input.footprint.holes.empty() ? apex_of(ring) : std::nullopt;
  if (!apex) return by_skeleton(input);
  const double span_m = apex_span_m(ring, *apex), reach_m = apex_radius_m(ring, *apex);
  const double rise_m = rise_of(input.shape, span_m);
  const double seen_m = input.shape.form == RoofForm::kOnion ? std::max(rise_m, kMostSwelling * reach_m) : rise_m;
  if (!is_seen(input, seen_m)) return flat_roof(input, seen_m);
  if (!input.eaves.outer.empty() && is_convex(input.footprint)) return pyramid_convex(input, *apex);
  Roof roof = roof_over_apex(ring, *apex,
                             section_over_apex(input.shape.form, span_m, reach_m, rise_m, input.tolerance_m), rise_m);
  roof.form = input.shape.form;
  roof.error_m = with_eaves_m(input, roof.error_m);
  return roof;
}

std::optional<Roof> shaped(const RoofInput& input) {
  switch (form_row(input.shape.form).method) {
    case Method::kFlat:
      return flat_roof(input, 0);
    case Method::kStrips:
      return striped(input);
    case Method::kStripsOrSkeleton:
      return has_wings(input) ? by_skeleton(input) : striped(input);
    case Method::kApex:
      return over_apex(input);
    case Method::kSkeleton:
      return is_convex(input.footprint) ? hipped_convex(input) : by_skeleton(input);
  }
  return std::nullopt;
}

}  // namespace

Roof generate_roof(const Polygon& footprint, const RoofShape& shape, double tolerance_m, OsmId object, Report& report) {
  assert(tolerance_m > 0 && shape.form < RoofForm::kCount);
  Polygon polygon = cleaned(footprint);
  if (polygon.outer.empty()) {
    report.add(Code::kRoofFallback, object, 0);
    return {};
  }
  const RoofInput input = roof_input(std::move(polygon), shape, tolerance_m);
  // between walls closer than the grid nothing is left
  if (std::optional<Roof> roof = shaped(input); roof && !roof->triangles.empty()) return std::move(*roof);
  report.add(Code::kRoofFallback, object, area_m2(input.footprint));
  return flat_roof(input, 0);
}

std::optional<Roof> roof_by_skeleton(const Polygon& footprint, const RoofShape& shape, double tolerance_m,
                                     SkeletonKernel kernel) {
  Polygon polygon = cleaned(footprint);
  if (polygon.outer.empty()) return std::nullopt;
  const RoofInput input = roof_input(std::move(polygon), shape, tolerance_m);
  return by_skeleton(input, skeleton_plan(input), kernel);
}

}  // namespace citykiln::roofs
