#include "compiler/climate/climate_field.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "compiler/climate/climate_at.h"

namespace citykiln::climate {
namespace {

constexpr int kUnits = 255;

// Recipes of a tile lie up to this distance outside of it; a margin for scene::kHalo_m.
constexpr double kMargin_m = 1024;

// The largest share takes what rounding leaves.
ClimateNode node_of(const ClimateMix& mix) {
  ClimateNode node;
  std::size_t count = 0, largest = 0;
  int rest = kUnits;
  for (const ClimateShare& each : mix.shares()) {
    const int units = static_cast<int>(each.share * kUnits + 0.5);
    node.classes[count] = each.climate, node.shares[count] = static_cast<std::uint8_t>(units), rest -= units;
    if (node.shares[largest] < node.shares[count]) largest = count;
    ++count;
  }
  node.shares[largest] = static_cast<std::uint8_t>(node.shares[largest] + rest);
  return node;
}

std::int32_t index_below(double v) { return static_cast<std::int32_t>(std::floor(v / kNodeSpacing_m)); }

// An index and how far on to the next one, both within 0 … count - 1.
struct Along {
  std::size_t index;
  double share;
};
Along along_nodes(double v, std::int32_t first, std::int32_t count) {
  const double at = std::clamp(v / kNodeSpacing_m - first, 0.0, static_cast<double>(count - 1));
  const auto index = std::min(static_cast<std::int32_t>(at), std::max(count - 2, 0));
  return {static_cast<std::size_t>(index), at - index};
}

}  // namespace

ClimateField make_climate_field(const Box2& extent, const std::function<LonLat(Vec2)>& degrees_of) {
  const Box2 wide = extent.widened(kMargin_m);
  const LonLat origin = degrees_of({0, 0});
  ClimateField field{.origin_class = climate_at(origin.lon_deg, origin.lat_deg),
                     .first_column = index_below(wide.min.x),
                     .first_row = index_below(wide.min.y),
                     .columns = index_below(wide.max.x) + 2 - index_below(wide.min.x),
                     .nodes = {}};
  for (std::int32_t row = field.first_row; row <= index_below(wide.max.y) + 1; ++row)
    for (std::int32_t column = field.first_column; column < field.first_column + field.columns; ++column) {
      const LonLat at = degrees_of({column * kNodeSpacing_m, row * kNodeSpacing_m});
      field.nodes.push_back(node_of(climate_mix_at(at.lon_deg, at.lat_deg)));
    }
  return field;
}

ClimateField uniform_climate(ClimateClass climate) {
  return {.origin_class = climate, .columns = 1, .nodes = {node_of(ClimateMix(climate))}};
}

bool is_sound(const ClimateField& field) {
  constexpr std::int32_t kMost = 1024;
  const auto is_node = [](const ClimateNode& node) {
    return std::accumulate(node.shares.begin(), node.shares.end(), 0) == kUnits &&
           std::ranges::all_of(node.classes, [](ClimateClass each) { return each < ClimateClass::kCount; });
  };
  return field.origin_class < ClimateClass::kCount && field.columns > 0 && field.columns <= kMost &&
         !field.nodes.empty() && std::abs(field.first_column) <= kMost && std::abs(field.first_row) <= kMost &&
         field.nodes.size() % static_cast<std::size_t>(field.columns) == 0 &&
         field.nodes.size() / static_cast<std::size_t>(field.columns) <= kMost &&
         std::ranges::all_of(field.nodes, is_node);
}

ClimateMix climate_mix_at(const ClimateField& field, Vec2 at) {
  assert(field.columns > 0 && !field.nodes.empty());
  const auto columns = static_cast<std::size_t>(field.columns), rows = field.nodes.size() / columns;
  const Along x = along_nodes(at.x, field.first_column, field.columns);
  const Along y = along_nodes(at.y, field.first_row, static_cast<std::int32_t>(rows));
  ClimateMix mix;
  for (const std::size_t up : {std::size_t{0}, std::size_t{1}})
    for (const std::size_t right : {std::size_t{0}, std::size_t{1}}) {
      const double share = (right ? x.share : 1 - x.share) * (up ? y.share : 1 - y.share);
      if (share == 0) continue;
      const ClimateNode& node = field.nodes[(y.index + up) * columns + x.index + right];
      for (std::size_t i = 0; i < node.shares.size(); ++i)
        if (node.shares[i] > 0) mix.add(node.classes[i], share * node.shares[i] / kUnits);
    }
  return mix;
}

}  // namespace citykiln::climate
