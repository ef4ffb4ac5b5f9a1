#include "compiler/commands/plan/gather_usd.h"

#include <algorithm>

#include "exporters/file.h"
#include "exporters/usd/read_layer.h"
#include "exporters/usd/usd_names.h"

namespace citykiln::commands {
namespace {

/// Returns the values of a prim with this name; null if they are missing or not `count` numbers.
const std::vector<double>* numbers_of(const exporters::UsdReadPrim& prim, const std::string& name, std::size_t count) {
  const auto found = prim.values.find(name);
  return found != prim.values.end() && found->second.numbers.size() == count ? &found->second.numbers : nullptr;
}

/// A tile without meshes has bounds of zeros in the layer.
exporters::UsdBounds bounds_of(const std::vector<double>& n) {
  if (std::ranges::all_of(n, [](double v) { return v == 0; })) return {};
  return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}

}  // namespace

Result<std::vector<exporters::UsdTile>> read_usd_tiles(const std::string& path, std::span<const scene::TileKey> tiles) {
  const Result<std::vector<std::byte>> bytes = exporters::read_file(path);
  if (!bytes) return bytes.error();
  const Result<exporters::UsdReadLayer> layer = exporters::read_usd_layer(*bytes, path);
  if (!layer) return layer.error();
  std::vector<exporters::UsdTile> read;
  for (const scene::TileKey tile : tiles) {
    const auto* prim = exporters::prim_at(*layer, "/scene/tiles/" + exporters::usd_tile_prim(tile));
    const auto* origin = prim ? numbers_of(*prim, "xformOp:translate", 3) : nullptr;
    const auto* extent = prim ? numbers_of(*prim, "extentsHint", 6) : nullptr;
    if (!origin || !extent) return Error{path, "has no place of tile " + to_string(tile)};
    read.push_back({.tile = tile, .origin = {(*origin)[0], (*origin)[1], (*origin)[2]}, .levels = {}});
    read.back().levels.push_back({.bounds = bounds_of(*extent)});
  }
  return read;
}

}  // namespace citykiln::commands
