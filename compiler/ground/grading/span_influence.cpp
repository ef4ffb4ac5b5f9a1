#include "compiler/ground/grading/span_influence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace citykiln::ground {
namespace {

constexpr double kInfinity_m = std::numeric_limits<double>::infinity();
// Clear heights for cars and lorries, trains, people, and of the ramps of garages.
constexpr double kRoadBore_m = 5, kRailBore_m = 6, kPathBore_m = 2.75, kServiceBore_m = 3;

// A place as seen from a span's segment.
struct SpanView {
  double z_m = 0;       ///< Height of the road.
  double beside_m = 0;  ///< Distance beyond its edges, square to it.
  double before_m = 0;  ///< Distance beyond the way's ends, along it.
  double inside_m = 0;  ///< Distance to the nearer end of the way.
};

// True for most segments; decided without division, hence with some slack.
bool is_out_of_reach(const GradedSegment& s, const SegmentLine& line, double run, double aside) {
  constexpr double kSlack_m = 0x1p-10;
  const double far = (std::max(s.left_m, s.right_m) + kGrading_m + kSlack_m) * line.length_m;
  return std::abs(aside) > far || run < -far || run > line.length2_m2 + far;
}

std::optional<SpanView> view_of(const SpanInfluenceIndex& spans, std::uint32_t number, Vec2 p) {
  const GradedSegment& s = spans.roads.segments[number];
  const SegmentLine& line = spans.roads.lines[number];
  const double run = dot(p - s.from, line.along), aside = cross(line.along, p - s.from), long_m = line.length_m;
  if (is_out_of_reach(s, line, run, aside)) return std::nullopt;
  const double at_m = run / long_m, aside_m = aside / long_m;
  const double half_m = aside_m >= 0 ? s.left_m : s.right_m;
  const double outside_m = std::max({0.0, -at_m, at_m - long_m});
  const bool is_end = (at_m < 0 && s.from_m == 0) || (at_m > long_m && s.to_m == spans.long_m[s.road]);
  // beyond a bend of the axis the next segment is nearer; places between the two count as beside both
  const double from_bend_m = is_end ? std::abs(aside_m) : length(Vec2{aside_m, outside_m});
  const double beside_m = std::max(0.0, from_bend_m - half_m), before_m = is_end ? outside_m : 0;
  if (beside_m >= kGrading_m || before_m >= kGrading_m) return std::nullopt;
  const double share = std::clamp(at_m / long_m, 0.0, 1.0), way_m = s.from_m + (s.to_m - s.from_m) * share;
  const Knot knot = knot_on(spans.roads, number, share);
  return SpanView{knot.z_m + knot.tilt * std::clamp(aside_m, -s.right_m, s.left_m), beside_m, before_m,
                  std::min(way_m, spans.long_m[s.road] - way_m)};
}

}  // namespace

double bore_height_m(map::LandCoverClass surface) {
  const map::LandCoverGroup group = map::values_of(surface).group;
  if (group == map::LandCoverGroup::kRail) return kRailBore_m;
  if (surface == map::LandCoverClass::kServiceRoad) return kServiceBore_m;
  return group == map::LandCoverGroup::kPath ? kPathBore_m : kRoadBore_m;
}

SpanInfluenceIndex index_span_influence(std::span<const roads::Road> spans) {
  std::vector<roads::Road> graded;
  for (const roads::Road& span : spans)
    if (!span.profile.empty()) graded.push_back(span);
  SpanInfluenceIndex made{index_road_influence(graded, false), {}, {}};
  for (const roads::Road& span : graded) {
    made.long_m.push_back(roads::distances_along(span).back());
    made.height_m.push_back(bore_height_m(span));
  }
  return made;
}

double max_land_under_decks_m(const SpanInfluenceIndex& decks, Vec2 p) {
  double most_m = kInfinity_m;
  for (const std::uint32_t i : boxes_about(decks.roads.grid, p)) {
    const std::optional<SpanView> view = view_of(decks, i, p);
    if (!view) continue;
    const double away_m = view->beside_m + view->before_m;
    const double room_m = std::min(kDeckClearance_m, kDeckClearanceSlope * view->inside_m);
    most_m = std::min(most_m, view->z_m - room_m + kDeckClearanceSlope * away_m);
  }
  return most_m;
}

BoreCover bore_cover_at(const SpanInfluenceIndex& bores, Vec2 p) {
  BoreCover over{-kInfinity_m};
  for (const std::uint32_t i : boxes_about(bores.roads.grid, p)) {
    const std::optional<SpanView> view = view_of(bores, i, p);
    if (!view) continue;
    const double roof_m = view->z_m + bores.height_m[bores.roads.segments[i].road] + kBoreCover_m;
    over.least_m =
        std::max(over.least_m, roof_m - kPortalWallSlope * view->before_m - kDeckClearanceSlope * view->beside_m);
    const double higher_m = kPortalWall_m - kPortalWallSlope * view->before_m - kPortalWallSideSlope * view->beside_m;
    if (higher_m > over.higher_m) over.higher_m = higher_m, over.roof_m = roof_m;
  }
  return over;
}

double ceiling_in_mouth_m(const SpanInfluenceIndex& bores, Vec2 a, Vec2 b, double within_m) {
  const Vec2 middle = (a + b) * 0.5;
  double ceiling_m = -kInfinity_m;
  for (const std::uint32_t i : boxes_about(bores.roads.grid, middle)) {
    const GradedSegment& s = bores.roads.segments[i];
    const double long_m = bores.long_m[s.road];
    for (const bool is_begin : {true, false}) {
      if (is_begin ? s.from_m != 0 : s.to_m != long_m) continue;
      const Vec2 mouth = is_begin ? s.from : s.to, in = unit(is_begin ? s.to - s.from : s.from - s.to);
      const double off_m = std::abs(dot(middle - mouth, in)),
                   aside_m = cross(is_begin ? in : in * -1.0, middle - mouth);
      const bool is_across = std::abs(dot(unit(b - a), in)) < 0.5;
      if (!is_across || off_m > within_m || aside_m > s.left_m || aside_m < -s.right_m) continue;
      const Knot knot = knot_at(bores.roads.profiles[s.road], is_begin ? 0 : long_m);
      ceiling_m = std::max(ceiling_m, knot.z_m + bores.height_m[s.road]);
    }
  }
  return ceiling_m;
}

}  // namespace citykiln::ground
