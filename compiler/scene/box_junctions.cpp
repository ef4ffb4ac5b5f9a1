#include "compiler/scene/box_junctions.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/contract/derived_id.h"
#include "compiler/roads/network.h"

namespace citykiln::scene {
namespace {

using map::LandCoverClass;
using roads::Road;

bool is_main(const Road& road) {
  return road.surface == LandCoverClass::kPrimaryRoad || road.surface == LandCoverClass::kSecondaryRoad ||
         road.surface == LandCoverClass::kTertiaryRoad;
}

bool has_signals_near(const Road& road, const roads::Arm& arm, const roads::Cut& cut) {
  constexpr double kBefore_m = 20;
  if (cut.length_m == roads::kWholeLink_m || road.points.empty()) return false;
  const std::vector<double> along = roads::distances_along(road);
  return std::ranges::any_of(road.points, [&](const map::TrackPoint& point) {
    return point.kind == map::TrackPointKind::kSignals &&
           std::abs(along[point.vertex] - along[arm.vertex]) <= cut.length_m + kBefore_m;
  });
}

bool has_box(const roads::Junction& junction, std::span<const Road> roads, std::span<const roads::Arm> arms) {
  if (arms.size() < 3 || arms.size() != junction.cuts.size()) return false;
  if (roads[arms[0].road].country != map::CountryGroup::kBritishIsles) return false;
  if (std::ranges::count_if(arms, [&](const roads::Arm& arm) { return is_main(roads[arm.road]); }) < 3) return false;
  for (std::size_t a = 0; a < arms.size(); ++a)
    if (has_signals_near(roads[arms[a].road], arms[a], junction.cuts[a])) return true;
  return false;
}

// Lines that rise to the right, or to the left, over the whole panel.
void add_diagonals(bool to_right, roads::Marks& marks) {
  constexpr double kHalfLine_m = 0.1;  // across the panel: 0.14 m across the line
  constexpr int kLines = static_cast<int>(kBoxPanel_m / kBoxLines_m), kOver = 5;
  for (int k = -kOver; k < kLines; ++k) {
    const double shift_m = k * kBoxLines_m, low_m = std::max(0.0, -shift_m),
                 high_m = std::min(roads::kLayoutLength_m, kBoxPanel_m - shift_m);
    const auto u_m = [&](double v_m, double side) {
      const double u = std::clamp(shift_m + v_m + side * kHalfLine_m, 0.0, kBoxPanel_m);
      return to_right ? u : kBoxPanel_m - u;
    };
    marks.push_back(
        {{{u_m(low_m, -1), low_m}, {u_m(low_m, 1), low_m}, {u_m(high_m, 1), high_m}, {u_m(high_m, -1), high_m}},
         roads::kYellow});
  }
}

roads::MarkingLayout box_layout(LandCoverClass surface) {
  roads::MarkingLayout layout{.surface = surface, .lanes = {}, .panel = {}, .panel_m = kBoxPanel_m};
  add_diagonals(true, layout.panel), add_diagonals(false, layout.panel);
  return layout;
}

// The frame of a panel over a ring, along a direction; none if the ring is wider than the panel.
std::optional<roads::PieceFrame> frame_over(std::span<const Ring> rings, Vec2 along) {
  Box2 turned;
  for (const Ring& ring : rings)
    for (const Vec2 p : ring) turned.grow({dot(p, along), dot(p, left_of(along))});
  if (turned.is_empty() || turned.height() > kBoxPanel_m) return std::nullopt;
  const double middle_m = (turned.min.y + turned.max.y) / 2, length_m = turned.width();
  const roads::PieceEnd start{.left_m = kBoxPanel_m / 2, .right_m = -kBoxPanel_m / 2};
  roads::PieceEnd end = start;
  end.left_along_m = end.right_along_m = end.v_m = length_m;
  return roads::PieceFrame{.at = along * turned.min.x + left_of(along) * middle_m,
                           .along = along,
                           .width_m = kBoxPanel_m,
                           .start = start,
                           .end = end};
}

}  // namespace

void add_box_junctions(std::span<const Road> roads, std::span<const roads::Junction> junctions, std::uint32_t first_run,
                       LandCover& cover) {
  const auto arms = roads::arms_of(junctions, roads);
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    if (arms[j].empty() || !has_box(junctions[j], roads, arms[j])) continue;
    const ObjectId id = junction_id(roads::main_road(roads, arms[j]).id);
    const auto polygon = std::ranges::find_if(cover.surfaces, [&](const ground::LandCoverPolygon& surface) {
      return surface.id == id && surface.piece == 0 && surface.area_m2 == ground::kJunctionArea_m2;
    });
    if (polygon == cover.surfaces.end()) continue;
    const Polyline out = roads::arm_axis(roads, arms[j][0], 1);
    const auto frame = frame_over(polygon->rings, unit(out.back() - out.front()));
    if (!frame) continue;
    cover.pieces.push_back({.surface = polygon->surface,
                            .ring = polygon->rings.front(),
                            .frame = *frame,
                            .layout = static_cast<std::uint32_t>(cover.layouts.size()),
                            .run = first_run++});
    cover.layouts.push_back(box_layout(polygon->surface));
    polygon->piece = static_cast<std::uint32_t>(cover.pieces.size());
  }
}

}  // namespace citykiln::scene
