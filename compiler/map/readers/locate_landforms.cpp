#include <algorithm>

#include "compiler/geometry/snap.h"
#include "compiler/map/readers/for_each_line.h"

namespace citykiln::map {
namespace {

struct LandformRow {
  std::string_view key, value;
  LandformKind kind;
  double height_m, width_m;
  LandCoverClass surface;
};
constexpr LandformRow kLandforms[] = {
#define LANDFORM(key, value, kind, height_m, width_m, surface) \
  {key, value, LandformKind::kind, height_m, width_m, LandCoverClass::surface},
#include "compiler/map/line_rules.inc"
#undef LANDFORM
};

constexpr double kHighestLandform_m = 300, kWidestLandform_m = 60;

const LandformRow* landform_row(const ReadContext& context, source::Range tags) {
  for (const LandformRow& row : kLandforms)
    if (context.tag(tags, row.key) == row.value) return &row;
  return nullptr;
}

// Closed piers and breakwaters are areas, and one on a bridge is the bridge.
bool is_other_object(const ReadContext& context, const source::Way& way, const LandformRow& row) {
  if (says_yes(context.tag(way.tags, "bridge")) || says_yes(context.tag(way.tags, "tunnel"))) return true;
  const auto nodes = context.osm.nodes_of(way);
  const bool is_closed =
      nodes.size() > 3 && nodes.front().id == nodes.back().id && context.tag(way.tags, "area") != "no";
  return row.kind == LandformKind::kDeck && is_closed && context.tag(way.tags, "highway").empty();
}

Landform landform_of(const ReadContext& context, const source::Way& way, const LandformRow& row, LocatedLine&& line) {
  const OsmId id{OsmType::kWay, way.id};
  // a tagged height of a pier is rarely that above the water
  const auto height_m = row.kind == LandformKind::kDeck
                            ? std::nullopt
                            : tagged_length_m(context, id, way.tags, "height", 0.1, kHighestLandform_m);
  const bool is_solid = row.kind != LandformKind::kWall && row.kind != LandformKind::kStep;
  const auto width_m =
      is_solid ? tagged_length_m(context, id, way.tags, "width", 0.3, kWidestLandform_m) : std::nullopt;
  return {.id = {id, 0},
          .axis = std::move(line.axis),
          .kind = row.kind,
          .height_m = snapped(height_m.value_or(row.height_m)),
          .has_height = height_m.has_value(),
          .width_m = snapped(width_m.value_or(row.width_m)),
          .surface = row.surface};
}

}  // namespace

std::vector<Landform> locate_landforms(const ReadContext& context) {
  std::vector<Landform> landforms;
  const auto is_landform = [&](const source::Way& way) {
    const LandformRow* row = landform_row(context, way.tags);
    return row != nullptr && !is_other_object(context, way, *row);
  };
  for_each_line(
      context, "landform", is_landform, [&](const source::Way& way) { return landform_row(context, way.tags); },
      [&](const source::Way& way) { return reason_without(context, way.tags, landform_row(context, way.tags)->key); },
      [&](const source::Way& way, const LandformRow& row, LocatedLine&& line) {
        landforms.push_back(landform_of(context, way, row, std::move(line)));
      });
  return landforms;
}

}  // namespace citykiln::map
