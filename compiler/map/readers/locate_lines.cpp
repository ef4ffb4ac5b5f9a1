#include <algorithm>
#include <array>

#include "compiler/geometry/snap.h"
#include "compiler/map/buildings/building_tags.h"
#include "compiler/map/readers/for_each_line.h"
#include "compiler/map/readers/plant_tags.h"
#include "compiler/map/readers/read_lamp_tags.h"

namespace citykiln::map {
namespace {

struct WaterwayRow {
  std::string_view value;
  double width_m, least_m, most_m;
};
constexpr WaterwayRow kWaterways[] = {
#define WATERWAY(value, width_m, least_m, most_m) {value, width_m, least_m, most_m},
#include "compiler/map/line_rules.inc"
#undef WATERWAY
};

struct BarrierRow {
  std::string_view value;
  BarrierKind kind;
  double height_m, width_m;
};
constexpr BarrierRow kBarriers[] = {
#define BARRIER(value, kind, height_m, width_m) {value, BarrierKind::kind, height_m, width_m},
#include "compiler/map/line_rules.inc"
#undef BARRIER
};

struct PointRow {
  std::string_view key, value;
  PointKind kind;
};
constexpr PointRow kPoints[] = {
#define POINT(key, value, kind) {key, value, PointKind::kind},
#include "compiler/map/line_rules.inc"
#undef POINT
};

constexpr PointRow kShop{"shop", "", PointKind::kShop};
constexpr PointRow kEntrance{"entrance", "", PointKind::kEntrance};
constexpr PointRow kAddress{"addr:housenumber", "", PointKind::kAddress};

// Read by locate_landforms().
bool is_across_water(std::string_view waterway) { return waterway == "dam" || waterway == "weir"; }

// A wall that is tagged to hold the ground is a retaining wall; locate_landforms() makes the step.
const BarrierRow* barrier_row(const ReadContext& context, const source::Way& way) {
  const std::string_view value = context.tag(way.tags, "barrier");
  const bool retains = value == "wall" && context.tag(way.tags, "wall") == "retaining_wall";
  return row_with(kBarriers, retains ? "retaining_wall" : value);
}

// Calls make() for ways with a key and a row of its values.
template <typename RowOf, typename Make>
void for_each_with_key(const ReadContext& context, std::string_view key, RowOf row_of, Make make) {
  const auto value = [&](const source::Way& way) { return context.tag(way.tags, key); };
  for_each_line(
      context, std::string(key).c_str(),
      [&](const source::Way& way) { return !value(way).empty() && !is_across_water(value(way)); }, row_of,
      [&](const source::Way& way) { return reason_without(context, way.tags, key); }, make);
}

const PointRow* point_row(const ReadContext& context, source::Range tags) {
  for (const PointRow& row : kPoints)
    if (context.tag(tags, row.key) == row.value) return &row;
  if (says_yes(context.tag(tags, kEntrance.key))) return &kEntrance;
  if (is_shop(context, tags)) return &kShop;
  if (!context.tag(tags, kAddress.key).empty()) return &kAddress;
  return read_front_tags(context.osm, tags) ? &kShop : nullptr;
}

// True for kinds with a body of their own; shops, entrances and addresses belong to a building.
bool is_body(PointKind kind) {
  return kind != PointKind::kShop && kind != PointKind::kEntrance && kind != PointKind::kAddress;
}

constexpr double kTallestPoint_m = 400;

// The plant tags of a tree or shrub; natural=shrub wins over names of shipped trees.
PlantTags growth_of(const ReadContext& context, OsmId id, source::Range tags) {
  PlantTags plant_tags = read_plant_tags(context, id, tags);
  const bool is_own = static_cast<std::uint8_t>(plant_tags.kind) >= kFirstUserKind;
  if (context.tag(tags, "natural") == "shrub" && !is_own) plant_tags.kind = PlantKind::kBush;
  return plant_tags;
}

// The height by height=*; of a street lamp also by light:height=*. 0: not tagged.
double tagged_point_height_m(const ReadContext& context, OsmId id, const PointRow& row, source::Range tags) {
  auto height_m = tagged_length_m(context, id, tags, "height", 0.1, kTallestPoint_m);
  if (!height_m && row.kind == PointKind::kStreetLamp)
    height_m = tagged_length_m(context, id, tags, "light:height", 0.1, kTallestPoint_m);
  return height_m.value_or(0);
}

struct PowerRow {
  std::string_view value;
  double corridor_m;
  PowerLineKind kind{};
};
// Width of the corridor by value of power=*: pylons hold wires some 8 m out that swing, poles of minor lines little
// more than 1 m.
constexpr PowerRow kPowerLines[] = {{"line", 24, PowerLineKind::kLine}, {"minor_line", 8, PowerLineKind::kMinorLine}};

constexpr double kMostCables = 60, kMostCircuits = 12, kMostBundled = 12, kHighestVoltage_v = 2'000'000;
constexpr int kCablesOfCircuit = 3;

// Cables of aerialways; the corridor is wide enough for a cabin or chair on either side.
constexpr PowerRow kAerialways[] = {
    {"cable_car", 14, PowerLineKind::kAerialway},  {"gondola", 12, PowerLineKind::kAerialway},
    {"mixed_lift", 12, PowerLineKind::kAerialway}, {"chair_lift", 10, PowerLineKind::kAerialway},
    {"drag_lift", 6, PowerLineKind::kAerialway},   {"t-bar", 6, PowerLineKind::kAerialway},
    {"j-bar", 6, PowerLineKind::kAerialway},       {"platter", 6, PowerLineKind::kAerialway},
    {"goods", 6, PowerLineKind::kAerialway}};

struct BundleRow {
  std::string_view value;
  std::uint8_t wires;
};
constexpr BundleRow kBundles[] = {{"single", 1}, {"double", 2}, {"triple", 3}, {"quad", 4},
                                  {"five", 5},   {"six", 6},    {"eight", 8}};

// The part of a list such as "6;3" or "4-2" before its first separator.
std::string_view first_of_list(std::string_view text) { return text.substr(0, text.find_first_of(";-")); }

// The largest of the numbers of a tag such as voltage=220000;110000; 0: untagged.
double largest_number(const ReadContext& context, OsmId id, std::string_view key, std::string_view text, double most) {
  double largest = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(';', from), text.size());
    largest = std::max(largest, number_within(context, id, key, text.substr(from, to - from), 0, most).value_or(0));
    from = to + 1;
  }
  return largest;
}

std::uint8_t tagged_cables(const ReadContext& context, OsmId id, source::Range tags) {
  const std::string_view cables = first_of_list(context.tag(tags, "cables"));
  if (const auto count = number_within(context, id, "cables", cables, 1, kMostCables))
    return static_cast<std::uint8_t>(*count);
  const std::string_view circuits = first_of_list(context.tag(tags, "circuits"));
  return static_cast<std::uint8_t>(kCablesOfCircuit *
                                   number_within(context, id, "circuits", circuits, 1, kMostCircuits).value_or(0));
}

std::uint8_t tagged_bundle(const ReadContext& context, OsmId id, source::Range tags) {
  const std::string_view wires = first_of_list(context.tag(tags, "wires"));
  if (const BundleRow* row = row_with(kBundles, wires)) return row->wires;
  return static_cast<std::uint8_t>(number_within(context, id, "wires", wires, 1, kMostBundled).value_or(0));
}

PowerLine power_line_of(const ReadContext& context, const source::Way& way, const PowerRow& row, LocatedLine&& line) {
  const OsmId id{OsmType::kWay, way.id};
  const std::string_view voltage = context.tag(way.tags, "voltage");
  const bool is_power = row.kind != PowerLineKind::kAerialway;
  return {.id = {id, 0},
          .axis = std::move(line.axis),
          .corridor_m = row.corridor_m,
          .kind = row.kind,
          .node_ids = std::move(line.node_ids),
          .cables = is_power ? tagged_cables(context, id, way.tags) : std::uint8_t{0},
          .bundle = is_power ? tagged_bundle(context, id, way.tags) : std::uint8_t{0},
          .voltage_kv = largest_number(context, id, "voltage", voltage, kHighestVoltage_v) / 1000};
}

template <std::size_t n>
void add_power_lines(const ReadContext& context, const char* key, const PowerRow (&rows)[n],
                     std::vector<PowerLine>& lines) {
  const auto row_of = [&](const source::Way& way) { return row_with(rows, context.tag(way.tags, key)); };
  for_each_line(
      context, key, row_of, row_of, [&](const source::Way& way) { return reason_without(context, way.tags, key); },
      [&](const source::Way& way, const PowerRow& row, LocatedLine&& line) {
        lines.push_back(power_line_of(context, way, row, std::move(line)));
      });
}

}  // namespace

std::vector<Waterway> locate_waterways(const ReadContext& context) {
  std::vector<Waterway> waterways;
  for_each_with_key(
      context, "waterway",
      [&](const source::Way& way) { return row_with(kWaterways, context.tag(way.tags, "waterway")); },
      [&](const source::Way& way, const WaterwayRow& row, LocatedLine&& line) {
        const OsmId id{OsmType::kWay, way.id};
        const auto tagged = tagged_length_m(context, id, way.tags, "width", 0.2, 500);
        const double width = std::max(kQuantum_m, snapped(tagged.value_or(row.width_m)));
        waterways.push_back({.id = {id, 0},
                             .axis = std::move(line.axis),
                             .width_m = width,
                             .least_width_m = tagged ? 0 : row.least_m,
                             .most_width_m = tagged ? 0 : row.most_m,
                             .layer = tagged_layer(context, id, way.tags),
                             .passage = tagged_passage(context, way.tags)});
      });
  return waterways;
}

std::vector<Barrier> locate_barriers(const ReadContext& context) {
  std::vector<Barrier> barriers;
  for_each_with_key(
      context, "barrier", [&](const source::Way& way) { return barrier_row(context, way); },
      [&](const source::Way& way, const BarrierRow& row, LocatedLine&& line) {
        const OsmId id{OsmType::kWay, way.id};
        const auto tagged = tagged_length_m(context, id, way.tags, "height", 0.1, 50);
        const double height = snapped(tagged.value_or(row.height_m));
        barriers.push_back({.id = {id, 0},
                            .axis = std::move(line.axis),
                            .kind = row.kind,
                            .height_m = height,
                            .width_m = row.width_m});
      });
  return barriers;
}

std::vector<PointFeature> locate_points(const ReadContext& context) {
  std::vector<PointFeature> points;
  Account account;
  for (const source::Node& node : context.osm.nodes) {
    const PointRow* row = point_row(context, node.tags);
    if (row == nullptr) continue;
    const OsmId id{OsmType::kNode, node.id};
    account.in += context.report.counts(id);
    const Vec2 at = context.plane.snapped_forward(node.at);
    if (!context.extent.contains(at)) {
      context.report.drop(account, Code::kOutsideBounds, id);
      continue;
    }
    if (const auto reason = is_body(row->kind) ? reason_without(context, node.tags, row->key) : std::nullopt) {
      context.report.drop(account, *reason, id);
      continue;
    }
    account.out += context.report.counts(id);
    const double height = row->kind == PointKind::kTree ? tagged_plant_height_m(context, id, node.tags)
                                                        : tagged_point_height_m(context, id, *row, node.tags);
    points.push_back({.id = {id, 0}, .at = at, .kind = row->kind, .height_m = snapped(height)});
    if (row->kind == PointKind::kTree) points.back().plant_tags = growth_of(context, id, node.tags);
    if (!is_body(row->kind)) points.back().front = read_front_tags(context.osm, node.tags);
    if (row->kind == PointKind::kStreetLamp) points.back().lamp_tags = read_lamp_tags(context, id, node.tags);
  }
  context.report.account("map", "point") = account;
  return points;
}

std::vector<TreeRow> locate_tree_rows(const ReadContext& context) {
  constexpr PowerRow kAny{"tree_row", 0};
  std::vector<TreeRow> rows;
  const auto is_row = [&](const source::Way& way) { return context.tag(way.tags, "natural") == kAny.value; };
  for_each_line(
      context, "tree row", is_row, [&](const source::Way&) { return &kAny; },
      [&](const source::Way& way) { return reason_without(context, way.tags, "natural"); },
      [&](const source::Way& way, const PowerRow&, LocatedLine&& line) {
        const OsmId id{OsmType::kWay, way.id};
        const double spacing_m = tagged_length_m(context, id, way.tags, "spacing", 1, 100).value_or(0);
        rows.push_back({{id, 0},
                        std::move(line.axis),
                        snapped(tagged_plant_height_m(context, id, way.tags)),
                        snapped(spacing_m),
                        read_plant_tags(context, id, way.tags)});
      });
  return rows;
}

std::vector<PowerLine> locate_power_lines(const ReadContext& context) {
  std::vector<PowerLine> lines;
  add_power_lines(context, "power", kPowerLines, lines);
  add_power_lines(context, "aerialway", kAerialways, lines);
  return lines;
}

}  // namespace citykiln::map
