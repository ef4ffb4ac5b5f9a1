#include "compiler/ground/landforms/plan_landforms.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/geometry/snap.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/cover/strip_cover.h"
#include "compiler/ground/height_layer.h"
#include "compiler/ground/landforms/landform_index.h"
#include "compiler/ground/landforms/level_areas.h"
#include "compiler/ground/water/water_height.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;

// Knots of landforms are at most this far apart.
constexpr double kFormKnotStep_m = 8;
// Heights of ridges and decks that are not tagged are those of map/line_rules.inc; decks without water are as high as
// this above the ground.
constexpr double kDryDeck_m = 0.5;
// A tagged height that exceeds the rise of the terrain by more than this is reported.
constexpr double kMissingRise_m = 1;
// The highest retaining wall of a height that is not tagged.
constexpr double kMostWall_m = 15;
// Lower steps are left to the terrain.
constexpr double kLeastStep_m = 0.25;

// A place on an axis where a height is decided.
struct FormPlace {
  double at_m;
  Vec2 at, left;
};

std::vector<FormPlace> places_along(const Polyline& axis) {
  const std::vector<double> along_m = roads::distances_along(axis, 0);
  std::vector<FormPlace> places;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const Vec2 left = left_of(unit(axis[i + 1] - axis[i]));
    const double long_m = along_m[i + 1] - along_m[i];
    const auto count = static_cast<int>(std::ceil(long_m / kFormKnotStep_m));
    for (int k = 0; k < count; ++k) {
      const double share = static_cast<double>(k) / count;
      places.push_back({along_m[i] + long_m * share, axis[i] + (axis[i + 1] - axis[i]) * share, left});
    }
  }
  places.push_back({along_m.back(), axis.back(), places.back().left});
  return places;
}

// Adds a knot; distances are whole eighths of a metre and increase.
void add_knot(Profile& profile, double at_m, double z_m, double tilt) {
  const double eighth_m = snapped_to(0.125, at_m);
  if (!profile.empty() && profile.back().at_m >= eighth_m) return;
  profile.push_back({eighth_m, snapped_to(kProfileQuantum_m, z_m), snapped_to(kTiltQuantum, tilt)});
}

struct TerrainAcross {
  const map::Heightfield& heights;
  FormPlace place;

  double at(double left_m) const { return map::height_m_at(heights, place.at + place.left * left_m); }
};

// How much more the terrain rises to the left than the slopes on both sides explain.
double excess_rise_m(const TerrainAcross& terrain) {
  constexpr double kNear_m = kLandformReach_m, kFar_m = 2 * kLandformReach_m;
  const double rise_m = terrain.at(kNear_m) - terrain.at(-kNear_m);
  const double outside_m = terrain.at(kFar_m) - terrain.at(kNear_m) + terrain.at(-kNear_m) - terrain.at(-kFar_m);
  return rise_m >= 0 ? std::clamp(rise_m - outside_m, 0.0, rise_m) : std::clamp(rise_m - outside_m, rise_m, 0.0);
}

// The rise to the left: no more than that of the terrain. A height that is not tagged gives way to a step that the
// terrain shows.
double step_rise_m(const TerrainAcross& terrain, const map::Landform& form) {
  const double excess_m = excess_rise_m(terrain);
  if (form.height_m == 0) return excess_m;
  if (!form.has_height && std::abs(excess_m) > form.height_m) return std::clamp(excess_m, -kMostWall_m, kMostWall_m);
  const double rise_m = terrain.at(kLandformReach_m) - terrain.at(-kLandformReach_m);
  return std::clamp(rise_m, -form.height_m, form.height_m);
}

double step_middle_m(const TerrainAcross& terrain, double rise_m) {
  const double here_m = terrain.at(0), both_m = (terrain.at(kLandformReach_m) + terrain.at(-kLandformReach_m)) / 2;
  return std::clamp(both_m, here_m - std::abs(rise_m) / 2, here_m + std::abs(rise_m) / 2);
}

// The profile of a step; empty if the terrain does not rise across it.
Profile step_profile(const map::Landform& form, const map::Heightfield& heights, Report& report) {
  Profile profile;
  double most_m = 0;
  for (const FormPlace& place : places_along(form.axis)) {
    const TerrainAcross terrain{heights, place};
    const double rise_m = step_rise_m(terrain, form);
    most_m = std::max(most_m, std::abs(rise_m));
    add_knot(profile, place.at_m, step_middle_m(terrain, rise_m), rise_m / form.width_m);
  }
  if (form.has_height && form.height_m - most_m > kMissingRise_m)
    report.add(Code::kStepLowered, form.id.osm, form.height_m - most_m);
  if (most_m < kLeastStep_m) profile.clear();
  return profile;
}

Profile ridge_profile(const map::Landform& form, double height_m, const map::Heightfield& heights) {
  const double aside_m = std::min(form.width_m / 2 + height_m / side_slope(LandformKind::kRidge), kLandformReach_m);
  Profile profile;
  for (const FormPlace& place : places_along(form.axis)) {
    const TerrainAcross terrain{heights, place};
    add_knot(profile, place.at_m, (terrain.at(aside_m) + terrain.at(-aside_m)) / 2 + height_m, 0);
  }
  return profile;
}

// A dam spans a valley: it is level, as high as the lower one of its ends, or by its height above its lowest place.
Profile dam_profile(const map::Landform& form, const map::Heightfield& heights) {
  double low_m = map::height_m_at(heights, form.axis.front());
  for (const FormPlace& place : places_along(form.axis)) low_m = std::min(low_m, map::height_m_at(heights, place.at));
  const double ends_m =
      std::min(map::height_m_at(heights, form.axis.front()), map::height_m_at(heights, form.axis.back()));
  Profile profile;
  add_knot(profile, 0, form.has_height ? low_m + form.height_m : std::max(ends_m, low_m + form.height_m), 0);
  return profile;
}

// Water about decks: with its heights, and without. Water without a height lies on the terrain.
struct WaterAbout {
  WaterIndex known;
  std::vector<LandCoverPolygon> unknown{};
  LandCoverIndex unknown_index{};
};

WaterAbout water_about(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                       const Box2& box) {
  WaterAbout water{index_waters(surfaces, streams, box)};
  for (const LandCoverPolygon& surface : surfaces)
    if (layer_of(surface) == HeightLayer::kWater && !surface.level_m) water.unknown.push_back(surface);
  for (const roads::Strip& stream : streams)
    if (stream.profile.empty()) water.unknown.push_back(surface_of(stream));
  water.unknown_index = index_land_cover(water.unknown, box);
  return water;
}

std::optional<double> water_at_m(const WaterAbout& water, const map::Heightfield& heights, Vec2 at) {
  if (const auto z_m = water_m(water.known, at)) return z_m;
  const bool is_near =
      !water.unknown.empty() && clearance_m(water.unknown_index, at, 0, kStandingInfluence_m) < kStandingInfluence_m;
  return is_near ? std::optional(map::height_m_at(heights, at)) : std::nullopt;
}

// The highest water along a line or ring; empty without water.
std::optional<double> water_along_m(const WaterAbout& water, const map::Heightfield& heights, const Polyline& axis) {
  std::optional<double> most_m;
  for (const FormPlace& place : places_along(axis)) {
    if (!heights.box().contains(place.at)) continue;
    const std::optional<double> z_m = water_at_m(water, heights, place.at);
    if (z_m && (!most_m || *z_m > *most_m)) most_m = z_m;
  }
  return most_m;
}

LandformKind kind_of(map::LandformKind kind) {
  switch (kind) {
    case map::LandformKind::kRidge:
      return LandformKind::kRidge;
    case map::LandformKind::kDam:
      return LandformKind::kDam;
    case map::LandformKind::kDeck:
      return LandformKind::kDeck;
    default:
      return LandformKind::kStep;
  }
}

bool is_deck(const map::AreaFeature& area) {
  return area.surface == LandCoverClass::kPier || area.surface == LandCoverClass::kBreakwater;
}

// Rise of decks above water by their class.
double deck_rise_m(LandCoverClass surface) { return surface == LandCoverClass::kBreakwater ? 1.5 : 1.25; }

struct LandformPlanner {
  const map::FeatureView& features;
  const map::Heightfield& heights;
  Report& report;
  WaterAbout waters;
  Account account{};
  std::vector<Landform> planned{};

  int counts(OsmId id) const { return report.counts(id) ? 1 : 0; }

  void add(Landform form) {
    account.out += counts(form.id.osm);
    planned.push_back(std::move(form));
  }

  Landform line_of(const map::Landform& form) const {
    Landform line;
    line.id = form.id, line.axis = form.axis, line.surface = form.surface;
    line.left_m = line.right_m = snapped(form.width_m / 2);
    line.kind = kind_of(form.kind);
    return line;
  }

  Profile level_profile(double z_m) const {
    Profile profile;
    add_knot(profile, 0, z_m, 0);
    return profile;
  }

  void add_line(const map::Landform& form) {
    account.in += counts(form.id.osm);
    Landform line = line_of(form);
    if (line.kind == LandformKind::kStep) line.profile = step_profile(form, heights, report);
    if (line.kind == LandformKind::kRidge) line.profile = ridge_profile(form, form.height_m, heights);
    if (line.kind == LandformKind::kDam) line.profile = dam_profile(form, heights);
    if (line.kind == LandformKind::kDeck) {
      if (const std::optional<double> z_m = water_along_m(waters, heights, form.axis)) {
        line.profile = level_profile(*z_m + form.height_m);
      } else {
        report.add(Code::kPierWithoutWater, form.id.osm, length_m(form.axis));
        line.kind = LandformKind::kRidge, line.profile = ridge_profile(form, kDryDeck_m, heights);
      }
    }
    // a retaining wall on level ground is a wall
    if (line.profile.empty() && form.kind == map::LandformKind::kWall) return void(account.out += counts(form.id.osm));
    if (line.profile.empty()) return report.drop(account, Code::kStepNotInTerrain, form.id.osm);
    add(std::move(line));
  }

  void add_area(const map::AreaFeature& area) {
    account.in += counts(area.id.osm);
    Ring ring = area.polygon.outer;
    ring.push_back(ring.front());
    const std::optional<double> z_m = water_along_m(waters, heights, ring);
    if (!z_m) {
      report.add(Code::kPierWithoutWater, area.id.osm, length_m(ring));
      return void(account.out += counts(area.id.osm));
    }
    Landform deck;
    deck.id = area.id, deck.axis = area.polygon.outer;
    // the polygon of the area is among the land cover
    deck.surface = LandCoverClass::kUnknown, deck.kind = LandformKind::kDeckArea;
    deck.profile = level_profile(*z_m + deck_rise_m(area.surface));
    add(std::move(deck));
  }
};

bool has_decks(const map::FeatureView& features) {
  return std::ranges::any_of(features.areas, is_deck) ||
         std::ranges::any_of(features.landforms,
                             [](const map::Landform& f) { return f.kind == map::LandformKind::kDeck; });
}

}  // namespace

std::vector<Landform> plan_landforms(const map::FeatureView& features, std::span<const LandCoverPolygon> surfaces,
                                     std::span<const roads::Strip> streams, const map::Heightfield& heights,
                                     Report& report) {
  LandformPlanner planner{features, heights, report, {}};
  if (has_decks(features)) planner.waters = water_about(surfaces, streams, heights.box());
  for (const map::Landform& form : features.landforms) planner.add_line(form);
  for (const map::AreaFeature& area : features.areas)
    if (is_deck(area)) planner.add_area(area);
  for (Landform& level : level_areas(features.areas, heights)) {
    planner.account.in += planner.counts(level.id.osm);
    planner.add(std::move(level));
  }
  std::ranges::sort(planner.planned, {}, &Landform::id);
  report.account("ground", "landform") = planner.account;
  return std::move(planner.planned);
}

}  // namespace citykiln::ground
