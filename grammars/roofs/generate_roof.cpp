#include "grammars/roofs/generate_roof.h"

#include <algorithm>
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

// A footprint that fills less of its box has wings, and so has one with a wall along the ridge in the middle of its
// width, as from kMiddle to 1 - kMiddle, that is longer than this share of the box.
constexpr double kFillsItsBox = 0.75, kMiddle = 0.25, kLongWall = 0.15;
// Walls that bend less are straight to the skeleton: less than mappers see. The same at all tolerances, for a skeleton
// can change its shape where a wall moves by a hair, and no error would bound that.
constexpr double kDrop_m = 0.03;
// Beyond so many corners a skeleton takes seconds, and with exact numbers from so many.
constexpr std::size_t kMostCorners = 1000, kMostExactCorners = 250;
// A skeleton whose faces lie farther apart in height where they meet is a wrong one, and so is one that leaves this
// share of the footprint bare, or whose top lies farther inward than in a disc: its square is 1 / π of the area, and
// gables may be somewhat higher.
constexpr double kMostGap_m = 0.05, kMostBare = 0.01, kMostSpan = 0.7;

Roof finished(RaisedRoof raised, Form form, double error_m) {
  raised.roof.form = form;
  raised.roof.error_m = error_m;
  return std::move(raised.roof);
}

// Of a roof that is off by so much, together with the eaves it lacks: they stood out, and lifted it.
double with_eaves_m(const RoofInput& site, double error_m) {
  return length(Vec2{site.left_out_m.x, site.left_out_m.y + error_m});
}

// Over eaves that are seen a roof is not flat: they would hang lower.
bool is_seen(const RoofInput& site, double rise_m) {
  return rise_m > 0 && (!site.eaves.outer.empty() || rise_m > site.tolerance_m);
}

RoofPlan plan_on(const RoofInput& site, std::vector<Facet> facets) {
  return {std::move(facets), site.eaves, kThickness_m};
}

Ring box_about(const RoofInput& site) {
  const Box2 box = box_of(site.eaves.outer.empty() ? site.footprint.outer : site.eaves.outer).widened(2);
  return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}

Roof flat_roof(const RoofInput& site, double rise_m) {
  const Facet all{box_about(site), {site.footprint.outer.front(), {}, 0}, 0, 0};
  return finished(raise_facets(site.footprint, plan_on(site, {all})), Form::kFlat, with_eaves_m(site, rise_m));
}

// ---- one section along a line

Roof striped(const RoofInput& site) {
  const bool has_direction = site.shape.direction.has_value();
  const double rise_m = rise_of(site.shape, strip_span_m(site.shape.form, site.frame, has_direction));
  if (!is_seen(site, rise_m)) return flat_roof(site, rise_m);
  const double reach_m = 2 * site.shape.overhang_m + 1;
  Strips made = strips(site.shape.form, site.frame, has_direction, rise_m, reach_m, site.tolerance_m);
  const double error_m = with_eaves_m(site, made.error_m);
  return finished(raise_facets(site.footprint, plan_on(site, std::move(made.facets))), site.shape.form, error_m);
}

// ---- a section over a base

std::optional<Roof> over_base(const RoofInput& site, const InsetFacets& base, double area, double drop_m) {
  if (base.span_m <= 0) return std::nullopt;
  const double rise_m = rise_of(site.shape, base.span_m);
  if (!is_seen(site, rise_m)) return flat_roof(site, rise_m);
  const Section section =
      section_over_skeleton(site.shape.form, base.span_m, rise_m, site.tolerance_m, knee_of(site.shape, base.span_m));
  RoofPlan plan = plan_on(site, lifted(base, section, rise_m));
  const double steepest = rise_m * (section.corners[1].y / section.corners[1].x) / base.span_m;
  plan.flush_m += drop_m * steepest;
  RaisedRoof raised = raise_facets(site.footprint, plan);
  const bool is_whole = raised.uncovered_m2 <= kMostBare * area + drop_m * length_m(site.footprint.outer);
  if (!is_whole || raised.largest_gap_m > kMostGap_m * std::max(1.0, steepest)) return std::nullopt;
  return finished(std::move(raised), site.shape.form, with_eaves_m(site, section.error_m));
}

// Looks along the frame, to one end or to either.
bool looks_along(const RoofInput& site, Vec2 outward) { return dot(outward, site.frame.along) > 0.7071; }
bool looks_either_way(const RoofInput& site, Vec2 outward) {
  return looks_along(site, outward) || looks_along(site, outward * -1);
}

End end_at(const RoofInput& site, Vec2 outward) {
  switch (site.shape.form) {
    case Form::kGabled:
    case Form::kGambrel:
    case Form::kRound:
    case Form::kCrossGabled:
      return End::kGable;
    case Form::kHalfHipped:
      return End::kHalfHip;
    case Form::kSideHipped:
      return looks_along(site, outward) ? End::kGable : End::kHip;
    default:
      return End::kHip;
  }
}

std::vector<Plane> inward_planes(const Ring& ring) {
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < ring.size(); ++i)
    planes.push_back(distance_left_of(ring[i], ring[(i + 1) % ring.size()]));
  return planes;
}

// Over a convex footprint ends need no skeleton: a gable's plane is left out, half a hip's starts half way up.
void open_ends(const RoofInput& site, std::vector<Plane>& planes) {
  const double span_m = span_over(site.footprint.outer, planes);
  const auto is_gable = [&](const Plane& p) {
    const Vec2 outward = p.gradient * -1;
    return looks_either_way(site, outward) && end_at(site, outward) == End::kGable;
  };
  for (Plane& p : planes)
    if (looks_either_way(site, p.gradient * -1) && end_at(site, p.gradient * -1) == End::kHalfHip)
      p.offset += span_m / 2;
  planes.erase(std::remove_if(planes.begin(), planes.end(), is_gable), planes.end());
}

std::optional<Roof> enveloped(const RoofInput& site, const std::vector<Plane>& planes) {
  InsetFacets base = envelope_facets(site.eaves.outer.empty() ? site.footprint.outer : box_about(site), planes);
  base.span_m = span_over(site.footprint.outer, planes);
  return over_base(site, base, area_m2(site.footprint), 0);
}

std::optional<Roof> hipped_convex(const RoofInput& site) {
  std::vector<Plane> planes = inward_planes(site.footprint.outer);
  open_ends(site, planes);
  return enveloped(site, planes);
}

// A pyramid's sides are planes through its top: an envelope that eaves can stand out from.
std::optional<Roof> pyramid_convex(const RoofInput& site, Vec2 apex) {
  std::vector<Plane> planes = inward_planes(site.footprint.outer);
  const double span_m = apex_span_m(site.footprint.outer, apex);
  for (Plane& plane : planes) plane.gradient = plane.gradient * (span_m / plane.at(apex));
  return enveloped(site, planes);
}

// ---- the straight skeleton

std::size_t corners_of(const std::vector<Polygon>& polygons) {
  std::size_t count = 0;
  for (const Polygon& polygon : polygons) {
    count += polygon.outer.size();
    for (const Ring& hole : polygon.holes) count += hole.size();
  }
  return count;
}

// One piece: where a skeleton fails over a convex one, its envelope is the same; over another it stays bare, which is
// looked at when all is laid together.
InsetFacets base_over(const RoofInput& site, const Polygon& piece, SkeletonKernel kernel, std::uint32_t first_face) {
  InsetFacets base = skeleton_facets(
      piece, kernel, [&](Vec2 outward) { return end_at(site, outward); }, first_face);
  if (!base.facets.empty() || !is_convex(piece)) return base;
  base = envelope_facets(piece.outer, inward_planes(piece.outer));
  for (Facet& facet : base.facets) facet.face += first_face;
  return base;
}

InsetFacets skeleton_base(const RoofInput& site, const std::vector<Polygon>& polygons, SkeletonKernel kernel) {
  InsetFacets all;
  std::uint32_t first_face = 0;
  const double overhang_m = site.eaves.outer.empty() ? 0 : site.shape.overhang_m;
  for (const Polygon& polygon : polygons) {
    InsetFacets base = base_over(site, polygon, kernel, first_face);
    first_face += static_cast<std::uint32_t>(corners_of({polygon}));
    for (Facet& facet : base.facets) facet.plane.offset -= overhang_m, all.facets.push_back(std::move(facet));
    all.span_m = std::max(all.span_m, base.span_m - overhang_m);
  }
  return all;
}

// The footprint in simple pieces, and without bends that do not matter where it stays simple without them.
std::vector<Polygon> skeleton_plan(const RoofInput& site) {
  std::vector<Polygon> polygons = split_into_simple(site.eaves.outer.empty() ? site.footprint : site.eaves);
  for (Polygon& polygon : polygons) {
    Polygon simple = simplified(polygon, kDrop_m);
    if (is_simple_polygon(simple)) polygon = std::move(simple);
  }
  return polygons;
}

std::optional<Roof> by_skeleton(const RoofInput& site, const std::vector<Polygon>& polygons, SkeletonKernel kernel) {
  const std::size_t corners = corners_of(polygons);
  if (corners > (kernel == SkeletonKernel::kExact ? kMostExactCorners : kMostCorners)) return std::nullopt;
  const InsetFacets base = skeleton_base(site, polygons, kernel);
  double area = 0;
  for (const Polygon& polygon : polygons) area += area_m2(polygon);
  if (base.span_m * base.span_m > kMostSpan * area) return std::nullopt;
  return over_base(site, base, area, kDrop_m);
}

std::optional<Roof> by_skeleton(const RoofInput& site) {
  const std::vector<Polygon> polygons = skeleton_plan(site);
  for (const SkeletonKernel kernel : {SkeletonKernel::kInexact, SkeletonKernel::kExact})
    if (std::optional<Roof> roof = by_skeleton(site, polygons, kernel)) return roof;
  return std::nullopt;
}

// ---- which method

// A wall under the middle of the roof.
bool stands_inside(const OrientedBox& frame, Vec2 a, Vec2 b) {
  const double across = (frame.across_m((a + b) * 0.5) - frame.back_m) / frame.width_m();
  return across > kMiddle && across < 1 - kMiddle && std::abs(dot(frame.along, b - a)) > kLongWall * frame.length_m() &&
         std::abs(dot(frame.along, b - a)) > std::abs(dot(frame.across, b - a));
}

bool has_wall_inside(const OrientedBox& frame, const Ring& ring) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    if (stands_inside(frame, ring[j], ring[i])) return true;
  return false;
}

bool has_wings(const RoofInput& site) {
  const double box_m2 = site.frame.width_m() * site.frame.length_m();
  if (area_m2(site.footprint) < kFillsItsBox * box_m2 || has_wall_inside(site.frame, site.footprint.outer)) return true;
  return std::any_of(site.footprint.holes.begin(), site.footprint.holes.end(),
                     [&](const Ring& hole) { return has_wall_inside(site.frame, hole); });
}

// An onion swells by less than this share of its neck.
constexpr double kMostSwelling = 0.2;

std::optional<Roof> poled(const RoofInput& site) {
  const Ring& ring = site.footprint.outer;
  const std::optional<Vec2> apex = site.footprint.holes.empty() ? apex_of(ring) : std::nullopt;
  if (!apex) return by_skeleton(site);
  const double span_m = apex_span_m(ring, *apex), reach_m = apex_radius_m(ring, *apex);
  const double rise_m = rise_of(site.shape, span_m);
  const double seen_m = site.shape.form == Form::kOnion ? std::max(rise_m, kMostSwelling * reach_m) : rise_m;
  if (!is_seen(site, seen_m)) return flat_roof(site, seen_m);
  if (!site.eaves.outer.empty() && is_convex(site.footprint)) return pyramid_convex(site, *apex);
  Roof roof = roof_over_apex(ring, *apex, section_over_apex(site.shape.form, span_m, reach_m, rise_m, site.tolerance_m),
                             rise_m);
  roof.form = site.shape.form;
  roof.error_m = with_eaves_m(site, roof.error_m);
  return roof;
}

std::optional<Roof> shaped(const RoofInput& site) {
  switch (site.shape.form) {
    case Form::kFlat:
      return flat_roof(site, 0);
    case Form::kSkillion:
    case Form::kSaltbox:
    case Form::kDoubleSaltbox:
    case Form::kSawtooth:
    case Form::kGabledRow:
      return striped(site);
    case Form::kGabled:
    case Form::kGambrel:
    case Form::kRound:
    case Form::kCrossGabled:
      return has_wings(site) ? by_skeleton(site) : striped(site);
    case Form::kPyramidal:
    case Form::kCone:
    case Form::kDome:
    case Form::kOnion:
      return poled(site);
    default:
      return is_convex(site.footprint) ? hipped_convex(site) : by_skeleton(site);
  }
}

}  // namespace

Roof generate_roof(const Polygon& footprint, const RoofShape& shape, double tolerance_m, OsmId object, Report& report) {
  Polygon polygon = cleaned(footprint);
  if (polygon.outer.empty()) {
    report.add(Code::kRoofFallback, object, 0);
    return {};
  }
  const RoofInput site = roof_input(std::move(polygon), shape, tolerance_m);
  // walls closer than the grid leave nothing between them
  if (std::optional<Roof> roof = shaped(site); roof && !roof->triangles.empty()) return std::move(*roof);
  report.add(Code::kRoofFallback, object, area_m2(site.footprint));
  return flat_roof(site, 0);
}

std::optional<Roof> roof_by_skeleton(const Polygon& footprint, const RoofShape& shape, double tolerance_m,
                                     SkeletonKernel kernel) {
  Polygon polygon = cleaned(footprint);
  if (polygon.outer.empty()) return std::nullopt;
  const RoofInput site = roof_input(std::move(polygon), shape, tolerance_m);
  return by_skeleton(site, skeleton_plan(site), kernel);
}

}  // namespace citykiln::roofs
