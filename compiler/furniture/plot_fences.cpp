#include "compiler/furniture/plot_fences.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/things/facing.h"
#include "compiler/things/yard_kinds.h"

namespace citykiln::furniture {
namespace {

using map::LandCoverGroup;

constexpr double kPanel_m = 3.5, kPanelDepth_m = 0.3, kSiteFence_m = 2, kSchoolFence_m = 1.5, kInside_m = 0.4;
constexpr double kCraneWidth_m = 50, kCraneDepth_m = 5, kCraneHeight_m = 38, kCraneInside_m = 12;
constexpr std::uint32_t kCraneTries = 24;

// True for ground on which a panel may stand.
bool is_fenced_ground(const roadside::TileRecipes& recipes, Vec2 p) {
  if (!recipes.land_cover.box.contains(p)) return false;
  const std::uint32_t top = ground::land_cover_at(recipes.land_cover, p);
  if (top == ground::kNoLandCover) return true;
  const LandCoverGroup group = map::values_of(recipes.land_cover.surfaces[top].surface).group;
  return group == LandCoverGroup::kTown || group == LandCoverGroup::kIndustry || group == LandCoverGroup::kGrassland ||
         group == LandCoverGroup::kUnknown;
}

struct Fencer {
  const roadside::TileRecipes& recipes;
  const Box2& box;
  std::vector<things::Thing>& made;

  void add(const lots::Yard& plot, Vec2 at, Vec2 faces, things::Form form) {
    if (!box.contains_half_open(at)) return;
    form.country = plot.country;
    made.push_back({.id = derived_id({plot.building.osm, 0}, static_cast<std::uint32_t>(made.size())),
                    .at = snapped(at),
                    .direction = things::nearest_direction(faces),
                    .form = std::move(form)});
  }

  void add_panels(const lots::Yard& plot, Vec2 a, Vec2 b, double height_m) {
    const auto count = static_cast<int>(std::floor(distance(a, b) / kPanel_m));
    const Vec2 along = unit(b - a), inward = left_of(along);
    const double step_m = count == 0 ? 0 : distance(a, b) / count;
    for (int i = 0; i < count; ++i) {
      const Vec2 at = a + along * ((i + 0.5) * step_m) + inward * kInside_m;
      const auto is_free = [&](double share) { return is_fenced_ground(recipes, at + along * (share * kPanel_m)); };
      if (!is_free(-0.5) || !is_free(0) || !is_free(0.5)) continue;
      add(plot, at, inward * -1.0,
          {.kind = std::string(things::kSiteFence),
           .width_m = kPanel_m,
           .depth_m = snapped(kPanelDepth_m),
           .height_m = height_m});
    }
  }

  void add_crane(const lots::Yard& plot, std::uint64_t seed) {
    const RandomSequence draw(seed, stable_id(plot.building), "crane");
    if (area_m2(plot.polygon) < kLeastCraneSite_m2 || draw.unit(0) < 0.5) return;
    const Box2 around = box_of(plot.polygon.outer);
    for (std::uint32_t i = 1; i <= kCraneTries; ++i) {
      const Vec2 at{draw.between(around.min.x, around.max.x, 3 * i),
                    draw.between(around.min.y, around.max.y, 3 * i + 1)};
      const bool is_inside = contains(plot.polygon, at) && distance_to_ring(plot.polygon.outer, at) >= kCraneInside_m;
      if (!is_inside || !is_fenced_ground(recipes, at)) continue;
      const double turn = draw.unit(2) * things::kDirections;
      add(plot, at, things::unit_vector(static_cast<std::uint16_t>(turn)),
          {.kind = std::string(things::kSiteCrane),
           .width_m = kCraneWidth_m,
           .depth_m = kCraneDepth_m,
           .height_m = kCraneHeight_m});
      return;
    }
  }
};

}  // namespace

std::vector<things::Thing> plot_fences(const roadside::TileRecipes& recipes, std::uint64_t seed, const Box2& box) {
  std::vector<things::Thing> made;
  Fencer fencer{recipes, box, made};
  for (const lots::Yard& plot : recipes.plots) {
    const bool is_school = plot.kind == lots::LotKind::kSchool;
    if (!is_school && plot.kind != lots::LotKind::kSite) continue;
    const Ring& ring = plot.polygon.outer;
    for (std::size_t i = is_school ? 1 : 0; i < ring.size(); ++i)
      fencer.add_panels(plot, ring[i], ring[(i + 1) % ring.size()], is_school ? kSchoolFence_m : kSiteFence_m);
    if (!is_school) fencer.add_crane(plot, seed);
  }
  return made;
}

}  // namespace citykiln::furniture
