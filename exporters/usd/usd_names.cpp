#include "exporters/usd/usd_names.h"

#include <fmt/format.h>

#include "exporters/run_files.h"

namespace citykiln::exporters {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

std::string signed_text(std::int32_t number) {
  return number < 0 ? fmt::format("m{}", -static_cast<std::int64_t>(number)) : fmt::format("{}", number);
}

}  // namespace

std::string usd_tile_prim(scene::TileKey tile) {
  return fmt::format("tile_{}_{}", signed_text(tile.x), signed_text(tile.y));
}

std::string usd_identifier(std::string_view text) {
  std::string name;
  for (const char c : text) name += is_letter(c) || is_digit(c) ? c : '_';
  return name.empty() || is_digit(name.front()) ? "_" + name : name;
}

std::string usd_tile_name(scene::TileKey tile) { return fmt::format("{}{}.usda", kUsdTileFolder, to_string(tile)); }

std::string usd_level_name(scene::TileKey tile, std::size_t level) {
  return fmt::format("{}{}_L{}.usdc", kUsdTileFolder, to_string(tile), level);
}

}  // namespace citykiln::exporters
