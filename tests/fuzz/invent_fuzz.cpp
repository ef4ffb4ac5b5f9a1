// Reads any text as a tile set or as settings of an invented world, or as one error line. A tile set arranges a small
// grid whose neighbours fit, or gives one error line; settings are written and read again unchanged.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "compiler/invent/invent_settings.h"
#include "compiler/invent/tiles/arrange_tiles.h"
#include "compiler/invent/tiles/tile_city.h"
#include "compiler/invent/tiles/tile_set.h"

namespace {

using namespace citykiln;
using namespace citykiln::invent;

void check_line(const Error& error) {
  if (to_string(error).find('\n') != std::string::npos) std::abort();
}

void check_tiles(std::string_view text) {
  const Result<TileSet> set = read_tile_set(text, "fuzz.tiles");
  if (!set) return check_line(set.error());
  const Result<TileGrid> grid = arrange_tiles(*set, {.columns = 5, .rows = 4, .seed = text.size()});
  if (!grid) return check_line(grid.error());
  for (int y = 0; y < grid->rows; ++y)
    for (int x = 0; x + 1 < grid->columns; ++x)
      if (set->turned[grid->at(x, y)].sides[kEast] != set->turned[grid->at(x + 1, y)].sides[kWest]) std::abort();
  InventedMap map;
  add_tile_city(*set, *grid, 1, map);
}

void check_settings(const std::string& text) {
  const Result<InventSettings> settings = read_invent_settings(text, "fuzz.json", {});
  if (!settings) return check_line(settings.error());
  const std::string written = text_of(*settings);
  const Result<InventSettings> again = read_invent_settings(written, "fuzz.json", {});
  if (!again || text_of(*again) != written) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] % 2 == 0)
    check_tiles(text);
  else
    check_settings(text);
  return 0;
}
