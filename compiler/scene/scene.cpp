#include "compiler/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/sky/moment.h"

namespace citykiln::scene {
namespace {

// The tile that holds a place; the nearest one for places outside of the extent.
TileKey tile_at(const Header& header, Vec2 at) {
  assert(header.tile_m > 0);
  const auto number = [&](double v, double least, double most) {
    return static_cast<std::int32_t>(std::clamp(std::floor(v / header.tile_m), std::floor(least / header.tile_m),
                                                std::ceil(most / header.tile_m) - 1));
  };
  return {number(at.x, header.extent.min.x, header.extent.max.x),
          number(at.y, header.extent.min.y, header.extent.max.y)};
}

}  // namespace

plants::Month month_of(const Header& header) {
  return plants::month_for(local_month_of(header), header.climate.origin_class);
}

climate::LocalMonth local_month_of(const Header& header) {
  constexpr climate::LocalMonth kMidsummer{6};
  if (!header.sky.time) return kMidsummer;
  const std::chrono::year_month_day date(std::chrono::floor<std::chrono::days>(header.sky.time->at));
  return plants::local_month_of(date.month(), header.origin.lat_deg);
}

buildings::WeekTime week_time_of(const Header& header) {
  constexpr double kWednesday_h = 2 * 24, kEvening_h = 20, kNoon_h = 12, kWeek_h = 168;
  if (!header.sky.time) return {kWednesday_h + (sky::is_night(header.sky) ? kEvening_h : kNoon_h)};
  // 2000-01-03, a Monday, began 1.5 days after J2000.0
  const double hours = (sky::days_of(*header.sky.time) - 1.5) * 24 + header.origin.lon_deg / 15;
  return {hours - kWeek_h * std::floor(hours / kWeek_h)};
}

std::optional<buildings::WeekTime> night_of(const Header& header) {
  if (!sky::is_night(header.sky)) return std::nullopt;
  return week_time_of(header);
}

bool are_lamps_lit(const Shown& shown, const sky::Sky& sky) {
  return shown.lamps == LampLight::kBySun ? sky::are_lamps_lit(sky) : shown.lamps == LampLight::kOn;
}

std::optional<map::Cylinder> cylinder_of(const Header& header) {
  return header.sky.inside ? std::optional(header.sky.inside->cylinder) : std::nullopt;
}

Box2 box_of(const Header& header, TileKey tile) {
  assert(header.tile_m > 0);
  const Vec2 min{tile.x * header.tile_m, tile.y * header.tile_m};
  return {{std::max(min.x, header.extent.min.x), std::max(min.y, header.extent.min.y)},
          {std::min(min.x + header.tile_m, header.extent.max.x), std::min(min.y + header.tile_m, header.extent.max.y)}};
}

std::vector<TileKey> tiles_of(const Header& header) {
  assert(header.tile_m > 0);
  const auto number = [&](double v) { return static_cast<std::int32_t>(std::floor(v / header.tile_m)); };
  const auto last = [&](double v) { return static_cast<std::int32_t>(std::ceil(v / header.tile_m)) - 1; };
  std::vector<TileKey> tiles;
  for (std::int32_t x = number(header.extent.min.x); x <= last(header.extent.max.x); ++x)
    for (std::int32_t y = number(header.extent.min.y); y <= last(header.extent.max.y); ++y) tiles.push_back({x, y});
  return tiles;
}

bool is_anchored(const Header& header, TileKey tile, Vec2 anchor) { return tile_at(header, anchor) == tile; }

TileKey baking_tile(const Header& header, Vec2 anchor, const Box2& box) {
  const auto has_ground = [&](TileKey tile) { return touches_clip(header.clip, box_of(header, tile)); };
  const TileKey own = tile_at(header, anchor);
  if (has_ground(own)) return own;
  const TileKey low = tile_at(header, box.min), high = tile_at(header, box.max);
  for (std::int32_t x = low.x; x <= high.x; ++x)
    for (std::int32_t y = low.y; y <= high.y; ++y)
      if (has_ground({x, y})) return {x, y};
  return own;
}

TileKey baking_tile(const Header& header, const structures::Span& span) {
  return baking_tile(header, span.axis.front(), citykiln::box_of(span.axis).widened(max_offset_m(span)));
}

std::vector<roads::Junction> anchored_junctions(const Header& header, const Chunk& chunk) {
  std::vector<roads::Junction> anchored;
  for (const roads::Junction& junction : chunk.junctions) {
    const Vec2 at = junction.nodes.front();
    if (std::floor(at.x / header.tile_m) == chunk.tile.x && std::floor(at.y / header.tile_m) == chunk.tile.y)
      anchored.push_back(junction);
  }
  return anchored;
}

std::string to_string(TileKey tile) { return fmt::format("{}_{}", tile.x, tile.y); }

}  // namespace citykiln::scene
