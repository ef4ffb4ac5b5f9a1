#include "compiler/pitches/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/texts/parse.h"
#include "compiler/geometry/snap.h"
#include "compiler/pitches/field_lines.h"
#include "compiler/pitches/field_rules.h"
#include "grammars/roofs/oriented_box.h"

namespace citykiln::pitches {
namespace {

// A mapped thing of a kind replaces equipment within this distance.
constexpr double kMapped_m = 5;
// A field is divided into as many cells along each side, whose middles are tested.
constexpr int kProbes = 9;

// The share of a field's ground in an area.
double share_inside(const Field& field, const Polygon& area) {
  const FieldFrame frame = frame_of(field);
  const double length_m = distance(field.from, field.to);
  int inside = 0;
  for (int i = 0; i < kProbes; ++i)
    for (int j = 0; j < kProbes; ++j) {
      const Vec2 share{(i + 0.5) / kProbes - 0.5, (j + 0.5) / kProbes - 0.5};
      inside += contains(area, frame.in_plane({share.x * length_m, share.y * field.width_m}));
    }
  return inside / static_cast<double>(kProbes * kProbes);
}

// Numbers of fields along and across the longer side of an area, and the size of each.
struct Grid {
  int columns = 0, rows = 0;
  bool is_across = false;  ///< True if fields lie across the longer side.
  double length_m = 0, width_m = 0;
  int count() const { return columns * rows; }
};

int courts_within(double ground_m, double space_m) {
  return space_m > 0 ? std::max(1, static_cast<int>(ground_m / space_m)) : 1;
}

// The fields that fit in one direction.
Grid grid_of(const FieldRules& rules, double long_m, double short_m, bool is_across) {
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
Grid best_grid(const FieldRules& rules, double long_m, double short_m) {
  const Grid along = grid_of(rules, long_m, short_m, false);
  if (rules.space.width_m == 0) return along;
  const Grid across = grid_of(rules, long_m, short_m, true);
  return across.count() > along.count() ? across : along;
}

std::vector<Field> fields_in(ObjectId id, FieldKind kind, const Grid& grid, const roofs::OrientedBox& box,
                             const Polygon& area) {
  std::vector<Field> fields;
  const double cell_m = box.length_m() / grid.columns, cell_width_m = box.width_m() / grid.rows;
  const Vec2 half = (grid.is_across ? box.across : box.along) * (grid.length_m / 2);
  for (int i = 0; i < grid.columns; ++i)
    for (int j = 0; j < grid.rows; ++j) {
      const Vec2 middle = box.position(box.from_m + (i + 0.5) * cell_m, box.back_m + (j + 0.5) * cell_width_m);
      const Field field{id, kind, snapped(middle - half), snapped(middle + half), snapped(grid.width_m)};
      if (share_inside(field, area) >= kInside) fields.push_back(field);
    }
  return fields;
}

std::vector<Field> fields_for(ObjectId id, const Polygon& area, std::string_view sport) {
  const roofs::OrientedBox box = roofs::oriented_box(area.outer, std::nullopt, false);
  for (std::size_t i = 0; i < field_rules().size(); ++i) {
    const FieldRules& rules = field_rules()[i];
    if (!is_for(rules, sport)) continue;
    const Grid grid = best_grid(rules, box.length_m(), box.width_m());
    if (grid.count() == 0) continue;
    std::vector<Field> fields = fields_in(id, static_cast<FieldKind>(i), grid, box, area);
    if (!fields.empty()) return fields;
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

std::vector<Field> fields_of(ObjectId id, const Polygon& area, std::string_view sports) {
  if (area.outer.size() < 3) return {};
  for (const std::string_view sport : split(sports, ';'))
    if (std::vector<Field> fields = fields_for(id, area, sport); !fields.empty()) return fields;
  return {};
}

Pitches plan(const map::FeatureView& features, const map::ThingTable& table) {
  Pitches pitches{.fields = plan_fields(features), .equipment = {}};
  pitches.equipment = things_of(pitches.fields, table, features);
  return pitches;
}

std::vector<Field> plan_fields(const map::FeatureView& features) {
  std::vector<Field> fields;
  for (const map::SportsArea& pitch : features.sports_areas) {
    const auto area = std::ranges::lower_bound(features.areas, pitch.id, {}, &map::AreaFeature::id);
    if (area == features.areas.end() || area->id != pitch.id) continue;
    for (const Field& field : fields_of(pitch.id, area->polygon, pitch.sports)) fields.push_back(field);
  }
  return fields;
}

std::vector<map::ThingFeature> things_of(const std::vector<Field>& fields, const map::ThingTable& table,
                                         const map::FeatureView& features) {
  std::vector<map::ThingFeature> things;
  std::optional<ObjectId> last;
  std::uint32_t number = 0;
  for (const Field& field : fields) {
    if (last != field.id) number = 0;
    last = field.id;
    for (const Equipment& equipment : equipment_of(field)) {
      const map::ThingRow* row = row_named(table, equipment.thing);
      const ObjectId id = derived_id(field.id, number++);
      if (row && features.extent.contains(equipment.at) && !is_mapped(features, row->name, equipment.at))
        things.push_back(thing_of(id, equipment, *row));
    }
  }
  return things;
}

}  // namespace citykiln::pitches
