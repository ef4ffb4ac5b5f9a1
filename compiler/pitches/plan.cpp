#include "compiler/pitches/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/texts/parse.h"
#include "compiler/geometry/snap.h"
#include "compiler/pitches/pitch_lines.h"
#include "compiler/pitches/pitch_rules.h"
#include "grammars/roofs/oriented_box.h"

namespace citykiln::pitches {
namespace {

// A mapped thing of a kind replaces equipment within this distance.
constexpr double kMapped_m = 5;
// A pitch is divided into as many cells along each side, whose middles are tested.
constexpr int kProbes = 9;

// The share of a pitch's ground in an area.
double share_inside(const Pitch& pitch, const Polygon& area) {
  const PitchFrame frame = frame_of(pitch);
  const double length_m = distance(pitch.from, pitch.to);
  int inside = 0;
  for (int i = 0; i < kProbes; ++i)
    for (int j = 0; j < kProbes; ++j) {
      const Vec2 share{(i + 0.5) / kProbes - 0.5, (j + 0.5) / kProbes - 0.5};
      inside += contains(area, frame.in_plane({share.x * length_m, share.y * pitch.width_m}));
    }
  return inside / static_cast<double>(kProbes * kProbes);
}

// Numbers of pitches along and across the longer side of an area, and the size of each.
struct Grid {
  int columns = 0, rows = 0;
  bool is_across = false;  ///< True if pitches lie across the longer side.
  double length_m = 0, width_m = 0;
  int count() const { return columns * rows; }
};

int courts_within(double ground_m, double space_m) {
  return space_m > 0 ? std::max(1, static_cast<int>(ground_m / space_m)) : 1;
}

// The pitches that fit in one direction.
Grid grid_of(const PitchRules& rules, double long_m, double short_m, bool is_across) {
  const double along_m = is_across ? short_m : long_m, beside_m = is_across ? long_m : short_m;
  const int ahead = courts_within(along_m, rules.space.length_m), beside = courts_within(beside_m, rules.space.width_m);
  const auto length = fitted_m(rules.length, along_m / ahead), width = fitted_m(rules.width, beside_m / beside);
  if (!length || !width) return {};
  return {.columns = is_across ? beside : ahead,
          .rows = is_across ? ahead : beside,
          .is_across = is_across,
          .length_m = *length,
          .width_m = *width};
}

// Only courts may lie across an area.
Grid best_grid(const PitchRules& rules, double long_m, double short_m) {
  const Grid along = grid_of(rules, long_m, short_m, false);
  if (rules.space.width_m == 0) return along;
  const Grid across = grid_of(rules, long_m, short_m, true);
  return across.count() > along.count() ? across : along;
}

std::vector<Pitch> pitches_in(ObjectId id, PitchKind kind, const Grid& grid, const roofs::OrientedBox& box,
                              const Polygon& area) {
  std::vector<Pitch> pitches;
  const double cell_m = box.length_m() / grid.columns, cell_width_m = box.width_m() / grid.rows;
  const Vec2 half = (grid.is_across ? box.across : box.along) * (grid.length_m / 2);
  for (int i = 0; i < grid.columns; ++i)
    for (int j = 0; j < grid.rows; ++j) {
      const Vec2 middle = box.position(box.from_m + (i + 0.5) * cell_m, box.back_m + (j + 0.5) * cell_width_m);
      const Pitch pitch{id, kind, snapped(middle - half), snapped(middle + half), snapped(grid.width_m)};
      if (share_inside(pitch, area) >= kInside) pitches.push_back(pitch);
    }
  return pitches;
}

std::vector<Pitch> pitches_for(ObjectId id, const Polygon& area, std::string_view sport) {
  const roofs::OrientedBox box = roofs::oriented_box(area.outer, std::nullopt, false);
  for (std::size_t i = 0; i < pitch_rules().size(); ++i) {
    const PitchRules& rules = pitch_rules()[i];
    if (!is_for(rules, sport)) continue;
    const Grid grid = best_grid(rules, box.length_m(), box.width_m());
    if (grid.count() == 0) continue;
    std::vector<Pitch> pitches = pitches_in(id, static_cast<PitchKind>(i), grid, box, area);
    if (!pitches.empty()) return pitches;
  }
  return {};
}

const map::ThingRow* row_named(const map::ThingTable& table, std::string_view name) {
  const auto row = std::ranges::find(table, name, &map::ThingRow::name);
  return row == table.end() ? nullptr : &*row;
}

bool is_mapped(const map::FeatureView& features, std::string_view kind, Vec2 at) {
  return std::ranges::any_of(features.things, [&](const map::ThingFeature& thing) {
    return thing.kind == kind && distance(thing.at, at) < kMapped_m;
  });
}

map::ThingFeature thing_of(ObjectId id, const Equipment& equipment, const map::ThingRow& row) {
  map::ThingFeature thing{.id = id,
                          .at = snapped(equipment.at),
                          .kind = row.name,
                          .value = {},
                          .width_m = snapped(row.width.default_m),
                          .depth_m = snapped(row.depth.default_m),
                          .height_m = snapped(row.height.default_m)};
  thing.faces = equipment.facing;
  return thing;
}

}  // namespace

std::vector<Pitch> pitches_of(ObjectId id, const Polygon& area, std::string_view sports) {
  if (area.outer.size() < 3) return {};
  for (const std::string_view sport : split(sports, ';'))
    if (std::vector<Pitch> pitches = pitches_for(id, area, sport); !pitches.empty()) return pitches;
  return {};
}

PitchPlan plan(const map::FeatureView& features, const map::ThingTable& table) {
  PitchPlan made{.pitches = plan_pitches(features), .equipment = {}};
  made.equipment = things_of(made.pitches, table, features);
  return made;
}

std::vector<Pitch> plan_pitches(const map::FeatureView& features) {
  std::vector<Pitch> pitches;
  for (const map::SportsArea& sports_area : features.sports_areas) {
    const auto area = std::ranges::lower_bound(features.areas, sports_area.id, {}, &map::AreaFeature::id);
    if (area == features.areas.end() || area->id != sports_area.id) continue;
    for (const Pitch& pitch : pitches_of(sports_area.id, area->polygon, sports_area.sports)) pitches.push_back(pitch);
  }
  return pitches;
}

std::vector<map::ThingFeature> things_of(const std::vector<Pitch>& pitches, const map::ThingTable& table,
                                         const map::FeatureView& features) {
  std::vector<map::ThingFeature> things;
  std::optional<ObjectId> last;
  std::uint32_t number = 0;
  for (const Pitch& pitch : pitches) {
    if (last != pitch.id) number = 0;
    last = pitch.id;
    for (const Equipment& equipment : equipment_of(pitch)) {
      const map::ThingRow* row = row_named(table, equipment.thing);
      const ObjectId id = derived_id(pitch.id, number++);
      if (row && features.extent.contains(equipment.at) && !is_mapped(features, row->name, equipment.at))
        things.push_back(thing_of(id, equipment, *row));
    }
  }
  return things;
}

}  // namespace citykiln::pitches
