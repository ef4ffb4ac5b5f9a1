#include "compiler/ground/landforms/landform_index.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/segment.h"

namespace citykiln::ground {
namespace {

constexpr double kFormBucket_m = 32;
// Beyond its free end a step fans out and vanishes within this distance.
constexpr double kFreeEnd_m = 8;
// Walls are at least this thick on each side, so that the land in them is no vertical face.
constexpr double kLeastHalf_m = 0.125;
// Slopes of dykes, of dams, and of the ground beside a pier's landward end.
constexpr double kRidgeSlope = 0.5, kDamSlope = 2, kApronSlope = 0.25;

// The banks of level areas, and the distance to which an area counts as beside another.
constexpr double kLevelBank = 0.25, kBesideLevel_m = 1;

bool is_area(const Landform& form) { return is_area(form.kind); }

// A landform as seen from a place: the nearest point of its axis.
struct FormView {
  double away_m = std::numeric_limits<double>::infinity();
  double left_m = 0;    ///< Distance to the left of the segment's line; negative to its right.
  double beyond_m = 0;  ///< Distance beyond an end of the axis, along it.
  Knot knot;
};

FormView view_of_area(const Landform& form, Vec2 p) {
  FormView view{.knot = form.profile.front()};
  const bool is_inside = winding_number(form.axis, p) != 0;
  view.away_m = is_inside ? 0 : distance_to_ring(form.axis, p);
  return view;
}

FormView view_of_segment(const LandformIndex& index, LandformIndex::Piece piece, Vec2 p) {
  const Landform& form = index.forms[piece.form];
  const std::vector<double>& along_m = index.along_m[piece.form];
  const std::size_t s = piece.segment, last = form.axis.size() - 2;
  const Vec2 a = form.axis[s], b = form.axis[s + 1], along = unit(b - a);
  const double share = nearest_share(a, b, p), run_m = dot(p - a, along), long_m = distance(a, b);
  FormView view{.away_m = distance(p, a + (b - a) * share),
                .knot = knot_at(form.profile, along_m[s] + (along_m[s + 1] - along_m[s]) * share)};
  // beside a bend, a place is as far to the side as from the bend itself
  const bool is_before = run_m < 0 && s == 0, is_after = run_m > long_m && s == last;
  const double side_m = cross(along, p - a);
  view.beyond_m = is_before ? -run_m : is_after ? run_m - long_m : 0;
  view.left_m = is_before || is_after ? side_m : std::copysign(view.away_m, side_m);
  return view;
}

// The steps at a place, by weights that are largest beside the nearest one.
struct StepSum {
  double weight = 0, moved_m = 0, most_share = 0;
  std::optional<StepSide> nearest;
};

double step_share(double away_m) { return std::clamp((kLandformReach_m - away_m) / (kLandformReach_m / 2), 0.0, 1.0); }

void add_step(const Landform& form, const FormView& view, double terrain_m, StepSum& sum) {
  const double half_m = std::max(kLeastHalf_m, (form.left_m + form.right_m) / 2);
  const double left_z_m = view.knot.z_m + view.knot.tilt * form.left_m,
               right_z_m = view.knot.z_m - view.knot.tilt * form.right_m;
  const double top_m = std::max(left_z_m, right_z_m), foot_m = std::min(left_z_m, right_z_m), rise_m = top_m - foot_m;
  const double moved_m = rise_m * step_share(view.away_m);
  const double up_m = std::max(terrain_m, std::min(top_m, terrain_m + moved_m)),
               down_m = std::min(terrain_m, std::max(foot_m, terrain_m - moved_m));
  const double to_high_m = left_z_m >= right_z_m ? view.left_m : -view.left_m;
  const double share = (std::clamp(to_high_m / (half_m + view.beyond_m), -1.0, 1.0) + 1) / 2;
  const double end_share = std::max(0.0, 1 - view.beyond_m / kFreeEnd_m);
  const double near_m2 = view.away_m * view.away_m + half_m * half_m, weight = end_share / (near_m2 * near_m2);
  sum.weight += weight;
  sum.moved_m += weight * (down_m + (up_m - down_m) * share - terrain_m);
  sum.most_share = std::max(sum.most_share, end_share);
  if (!sum.nearest || view.away_m < sum.nearest->away_m)
    sum.nearest = StepSide{view.away_m, rise_m * end_share * step_share(view.away_m), share};
}

// The level areas at a place, by weights that are largest in the nearest one.
struct LevelSum {
  double weight = 0, moved_m = 0;
};

double plane_m(const Landform& form, Vec2 p) {
  const Vec2 off = p - form.axis.front();
  const double north = form.profile.size() > 1 ? form.profile[1].tilt : 0;
  return form.profile[0].z_m + form.profile[0].tilt * off.x + north * off.y;
}

// Beside the area the land lies between banks that start at the plane, and meet the terrain within kLandformReach_m.
void add_level(const Landform& form, double away_m, Vec2 p, double terrain_m, LevelSum& sum) {
  const double to_plane_m = plane_m(form, p) - terrain_m, off_m = std::abs(to_plane_m);
  const double bank_m = std::max(kLevelBank * away_m, off_m * away_m / kLandformReach_m);
  const double near_m2 = away_m * away_m + kBesideLevel_m * kBesideLevel_m;
  const double weight = std::max(0.0, 1 - away_m / kLandformReach_m) / (near_m2 * near_m2);
  sum.weight += weight;
  sum.moved_m += weight * std::copysign(std::max(0.0, off_m - bank_m), to_plane_m);
}

// The height of a ridge or deck with its sloping sides.
double with_sides_m(const Landform& form, const FormView& view) {
  const double half_m = is_area(form) ? 0 : std::max(form.left_m, form.right_m);
  return view.knot.z_m - side_slope(form.kind) * std::max(0.0, view.away_m - half_m);
}

bool is_level(const Landform& form) { return form.kind == LandformKind::kLevel; }

// Calls each(form, view) once for each landform near p that is wanted, with the nearest of its pieces; trimmed runs
// count as one.
template <typename IsWanted, typename Each>
void for_each_form(const LandformIndex& index, Vec2 p, IsWanted is_wanted, Each each) {
  const std::span<const std::uint32_t> near = boxes_about(index.grid, p);
  for (std::size_t i = 0; i < near.size();) {
    const Landform& form = index.forms[index.pieces[near[i]].form];
    if (!is_wanted(form)) {
      ++i;
      continue;
    }
    FormView best;
    for (; i < near.size() && index.forms[index.pieces[near[i]].form].id == form.id; ++i) {
      const LandformIndex::Piece& piece = index.pieces[near[i]];
      if (!piece.reach.contains(p)) continue;
      const FormView view = is_area(form) ? view_of_area(form, p) : view_of_segment(index, piece, p);
      if (view.away_m < best.away_m) best = view;
    }
    const double half_m = is_area(form) ? 0 : std::max(form.left_m, form.right_m);
    if (best.away_m < half_m + kLandformReach_m) each(form, best);
  }
}

// The terrain with the planes of level areas, before other landforms.
double with_level_areas_m(const LandformIndex& index, Vec2 p, double terrain_m) {
  LevelSum sum;
  for_each_form(index, p, is_level,
                [&](const Landform& form, const FormView& view) { add_level(form, view.away_m, p, terrain_m, sum); });
  return sum.weight > 0 ? terrain_m + sum.moved_m / sum.weight : terrain_m;
}

double form_reach_m(const Landform& form) {
  return kLandformReach_m + (is_area(form) ? 0 : std::max(form.left_m, form.right_m));
}

}  // namespace

double side_slope(LandformKind kind) {
  if (kind == LandformKind::kRidge) return kRidgeSlope;
  return kind == LandformKind::kDam ? kDamSlope : kApronSlope;
}

LandformIndex index_landforms(std::span<const Landform> forms) {
  LandformIndex index{{forms.begin(), forms.end()}, {}, {}, {}, false};
  std::vector<Box2> boxes;
  for (std::uint32_t f = 0; f < forms.size(); ++f) {
    const Landform& form = forms[f];
    index.has_level = index.has_level || form.kind == LandformKind::kLevel;
    index.along_m.push_back(roads::distances_along(form.axis, form.start_along_m));
    // in a foreign manifest a landform may have no height
    if (form.profile.empty()) continue;
    const std::size_t count = is_area(form) ? 1 : form.axis.size() - 1;
    for (std::uint32_t s = 0; s < count; ++s) {
      const Box2 box = is_area(form) ? box_of(form.axis) : box_of_segment(form.axis[s], form.axis[s + 1]);
      index.pieces.push_back({f, s, box.widened(form_reach_m(form))});
      boxes.push_back(index.pieces.back().reach);
    }
  }
  index.grid = grid_of(boxes, kFormBucket_m);
  return index;
}

LandformHeights landform_heights(const LandformIndex& index, Vec2 p, double terrain_m) {
  LandformHeights heights{.land_m = terrain_m};
  if (index.pieces.empty()) return heights;
  if (index.has_level) terrain_m = heights.land_m = with_level_areas_m(index, p, terrain_m);
  StepSum steps;
  double ridge_m = -std::numeric_limits<double>::infinity();
  for_each_form(index, p, std::not_fn(is_level), [&](const Landform& form, const FormView& view) {
    if (form.kind == LandformKind::kStep)
      add_step(form, view, terrain_m, steps);
    else if (form.kind == LandformKind::kRidge || form.kind == LandformKind::kDam)
      ridge_m = std::max(ridge_m, with_sides_m(form, view));
    else
      heights.deck_m = std::max(heights.deck_m, with_sides_m(form, view));
  });
  if (steps.weight > 0) heights.land_m += steps.moved_m / steps.weight * steps.most_share;
  heights.land_m = std::max(heights.land_m, ridge_m);
  heights.step = steps.nearest;
  return heights;
}

double with_landforms_m(const LandformIndex& index, Vec2 p, double terrain_m) {
  const LandformHeights heights = landform_heights(index, p, terrain_m);
  return std::max(heights.land_m, heights.deck_m);
}

}  // namespace citykiln::ground
