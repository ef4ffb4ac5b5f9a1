#include "compiler/fields/add_fields.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/contract/system/once.h"
#include "compiler/fields/cut_rings.h"
#include "compiler/fields/field_barriers.h"
#include "compiler/fields/lane_hedges.h"
#include "compiler/fields/open_land.h"
#include "compiler/fields/thinned.h"
#include "compiler/geometry/polygons/clip_polygon.h"
#include "compiler/map/row_direction.h"
#include "compiler/parcels/tight_box.h"

namespace citykiln::fields {
namespace {

using map::LandCoverClass;

constexpr double kLineBucket_m = 128;
// Borders between fields follow lines within a few of these distances, below the way.
constexpr double kThinLine_m = 0.25;
// Meadows are mown in larger pieces than arable land is tilled in.
constexpr double kMeadowsLarger = 1.8;
// Fields of unmapped land are larger than usual: half of the bytes, and what they look like is a guess anyway.
constexpr double kOpenLarger = 2;
// Land this steep has small meadows at any place.
constexpr double kSteepSlope = 0.15, kSteepField_m2 = 8000;
// The share of meadows that are pastures.
constexpr double kPastures = 0.45;

bool is_divided(const map::AreaFeature& area) {
  const bool is_land = area.surface == LandCoverClass::kFarmland || area.surface == LandCoverClass::kMeadow;
  return is_land && area.plant_tags == map::PlantTags{} && area.polygon.outer.size() >= 3;
}

// The lines of the map that divide land, thinned, with a grid of their boxes.
struct DividingLines {
  std::vector<Polyline> all;
  BoxGrid grid;
};

DividingLines dividing_lines(const map::FeatureView& features) {
  DividingLines lines;
  const auto add = [&](const Polyline& line) { lines.all.push_back(thinned(line, kThinLine_m)); };
  for (const map::Track& track : features.tracks)
    if (track.passage == map::Passage::kGround) add(track.axis);
  for (const map::Waterway& water : features.waterways)
    if (water.passage == map::Passage::kGround) add(water.axis);
  for (const map::Barrier& barrier : features.barriers)
    if (!is_derived(barrier.id)) add(barrier.axis);
  for (const map::TreeRow& row : features.tree_rows) add(row.axis);
  std::vector<Box2> boxes;
  for (const Polyline& line : lines.all) boxes.push_back(box_of(line));
  if (!boxes.empty()) lines.grid = grid_of(boxes, kLineBucket_m);
  return lines;
}

// The runs of segments of a line that touch a box.
void add_runs(const Polyline& line, const Box2& box, std::vector<Polyline>& runs) {
  Polyline run;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (box_of_segment(line[i], line[i + 1]).touches(box)) {
      if (run.empty()) run.push_back(line[i]);
      run.push_back(line[i + 1]);
    } else if (!run.empty()) {
      runs.push_back(std::exchange(run, {}));
    }
  }
  if (!run.empty()) runs.push_back(std::move(run));
}

std::vector<Polyline> lines_near(const DividingLines& lines, const Box2& box) {
  std::vector<Polyline> runs;
  if (lines.all.empty()) return runs;
  for (const std::uint32_t i : boxes_about(lines.grid, box)) add_runs(lines.all[i], box, runs);
  return runs;
}

class FieldMaker {
 public:
  FieldMaker(const map::FeatureView& features, const FieldInputs& inputs)
      : features_(features), inputs_(inputs), lines_(dividing_lines(features)) {}

  // The area as a field, the fields on top of it, and what stands between them.
  Fields fields_of(const map::AreaFeature& land) const {
    const RuleAt rule_at = [&](Vec2 at) { return rule_for(land, at); };
    const std::vector<Polyline> lines = lines_near(lines_, box_of(land.polygon.outer));
    Fields made;
    made.areas.push_back(as_field(land, land.id, parcels::tight_box(land.polygon.outer).along));
    for (const Polygon& inside : united_in(copied_rings(land.polygon), features_.extent)) {
      const Division division = divide(inside, lines, rule_at, stable_id(land.id), inputs_.seed);
      // the area itself is its only field
      if (division.fields.size() < 2) continue;
      for (const Field& field : division.fields) add_field(land, field, made.areas);
      const auto is_free = [&](Vec2 at) { return places().is_free(at, land); };
      for (const FieldBoundary& line : division.borders) add_barriers(land, line, is_free, made.barriers);
    }
    return made;
  }

  // The fields on a square of unmapped land, each with the number of its square.
  Fields fields_on(const map::AreaFeature& land, const OpenLand& open) const {
    const RuleAt rule_at = [&](Vec2 at) { return rule_for(land, at); };
    const Box2 box = box_of(land.polygon.outer);
    const OpenSquare square = open.square_at(box.min, [&](Vec2 at) { return is_steep(at); });
    Fields made;
    if (open_m2(square) < kLeastOpen_m2) return made;
    const std::vector<Polyline> lines = lines_near(lines_, box);
    for (const Polygon& inside : united_in(copied_rings(land.polygon), features_.extent)) {
      const Division division = divide(inside, lines, rule_at, stable_id(land.id), inputs_.seed);
      for (const Field& field : division.fields)
        for (const Polygon& part : open.free_parts(square, field.polygon)) add_open(land, field, part, made.areas);
      const auto is_free = [&](Vec2 at) { return is_open(square, at) && places().is_free(at, land); };
      for (const FieldBoundary& line : division.borders) add_barriers(land, line, is_free, made.barriers);
    }
    return made;
  }

  // Hedges beside roads, where fields have hedges.
  std::vector<map::Barrier> hedges(Report& report) const {
    const auto has_hedges = [&](const roads::Road& road) {
      return !road.axis.empty() && inputs_.rule_at(road.axis[road.axis.size() / 2]).border == FieldBorder::kHedge;
    };
    if (std::ranges::none_of(inputs_.roads, has_hedges)) return {};
    return lane_hedges(inputs_, places(), report);
  }

 private:
  // Few countries have hedges and walls, so what keeps these away is found when it is asked for.
  const BarrierPlaces& places() const {
    has_places_.call([this] { places_.emplace(features_, inputs_); });
    return *places_;
  }

  bool is_steep(Vec2 at) const {
    const Vec3 normal = map::normal_at(inputs_.heights, at);
    return length(in_plan(normal)) > kSteepSlope * normal.z;
  }

  FieldRule rule_for(const map::AreaFeature& land, Vec2 at) const {
    FieldRule rule = inputs_.rule_at(at);
    if (land.surface == LandCoverClass::kMeadow) rule.area_m2 *= kMeadowsLarger;
    if (land.surface == LandCoverClass::kUnknown) rule.area_m2 *= kOpenLarger;
    if (is_steep(at)) rule.area_m2 = std::min(rule.area_m2, kSteepField_m2);
    return rule;
  }

  LandCoverClass crop_of(const map::AreaFeature& land, ObjectId id, Vec2 at) const {
    const double draw = RandomSequence(inputs_.seed, stable_id(id), "crop").unit(0);
    if (land.surface == LandCoverClass::kMeadow)
      return draw < kPastures ? LandCoverClass::kPasture : LandCoverClass::kHayMeadow;
    return crop_at({inputs_.country_at(at), inputs_.climate_at(at)}, draw);
  }

  map::AreaFeature as_field(const map::AreaFeature& land, ObjectId id, Vec2 along) const {
    map::AreaFeature field = land;
    field.id = id;
    field.surface = crop_of(land, id, land.polygon.outer.front());
    field.row_heading = map::row_heading_along(along);
    return field;
  }

  void add_field(const map::AreaFeature& land, const Field& field, std::vector<map::AreaFeature>& areas) const {
    map::AreaFeature area = as_field(land, field_id(land.id, field.number), field.along);
    area.polygon = on_map_steps(field.polygon);
    area.area_m2 = std::max(land.area_m2 - 1, 0.0);
    areas.push_back(std::move(area));
  }

  // Parts of one field have its crop and rows.
  void add_open(const map::AreaFeature& square, const Field& field, const Polygon& part,
                std::vector<map::AreaFeature>& areas) const {
    const auto place = static_cast<std::uint32_t>(areas.size());
    map::AreaFeature area = as_field(square, field_id(square.id, field.number), field.along);
    area.id = field_id(square.id, field.number + place);
    area.area_m2 = area_m2(part);
    area.polygon = on_map_steps(part);
    areas.push_back(std::move(area));
  }

  void add_barriers(const map::AreaFeature& land, const FieldBoundary& line, const IsFree& is_free,
                    std::vector<map::Barrier>& barriers) const {
    const FieldRule rule = inputs_.rule_at((line.from + line.to) * 0.5);
    const RandomSequence draw(inputs_.seed, stable_id(field_id(land.id, line.number)), "field border");
    if (rule.border == FieldBorder::kNone || draw.unit(0) >= rule.border_share) return;
    for (map::Barrier& barrier : barriers_on(line, rule.border, land.id, is_free, draw)) barriers.push_back(barrier);
  }

  const map::FeatureView& features_;
  const FieldInputs& inputs_;
  DividingLines lines_;
  mutable Once has_places_;
  mutable std::optional<BarrierPlaces> places_;
};

template <typename Feature>
void add_to(std::vector<Feature>& all, std::vector<Feature>& more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

map::FeatureView seen_with(map::FeatureView features, const Fields& fields) {
  features.areas = fields.areas, features.barriers = fields.barriers;
  return features;
}

Fields with_fields(const map::FeatureView& features, const FieldInputs& inputs, Report& report) {
  Fields fields{{}, {features.barriers.begin(), features.barriers.end()}};
  const bool has_fields = has(inputs.assumed, Assumption::kFields);
  std::vector<const map::AreaFeature*> divided;
  for (const map::AreaFeature& area : features.areas)
    if (has_fields && is_divided(area))
      divided.push_back(&area), report.count_assumed(Assumption::kFields, area.id.osm);
    else
      fields.areas.push_back(area);
  const FieldMaker maker(features, inputs);
  const std::vector<map::AreaFeature> squares = has_fields ? open_squares(features) : std::vector<map::AreaFeature>{};
  const OpenLand open(features);
  std::vector<Fields> made = for_each_slot<Fields>(divided.size() + squares.size(), inputs.threads, [&](std::size_t i) {
    return i < divided.size() ? maker.fields_of(*divided[i]) : maker.fields_on(squares[i - divided.size()], open);
  });
  for (Fields& each : made) add_to(fields.areas, each.areas), add_to(fields.barriers, each.barriers);
  if (has(inputs.assumed, Assumption::kRoadsides))
    for (map::Barrier& hedge : maker.hedges(report)) fields.barriers.push_back(std::move(hedge));
  std::ranges::stable_sort(fields.areas, {}, &map::AreaFeature::id);
  std::ranges::stable_sort(fields.barriers, {}, &map::Barrier::id);
  return fields;
}

}  // namespace citykiln::fields
