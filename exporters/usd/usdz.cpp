#include "exporters/usd/usdz.h"

#include <span>
#include <utility>

#include "exporters/stored_zip.h"
#include "exporters/usd/encode_level.h"

namespace citykiln::exporters {
namespace {

// The data of each file begin at a multiple of so many bytes, as the specification requires.
constexpr std::size_t kAlignment = 64;

Result<std::vector<std::byte>> pack_usdz(std::span<const UsdFile> files) {
  std::vector<ZippedFile> zipped;
  for (const UsdFile& file : files) zipped.push_back({file.name, file.bytes});
  Result<std::vector<std::byte>> usdz = stored_zip(zipped, kAlignment);
  if (!usdz) return Error{"", "a .usdz has at most 4 GB; choose one tile or a larger tolerance"};
  return usdz;
}

}  // namespace

Result<std::vector<std::byte>> encode_usdz(const bake::BakedTile& tile, const scene::Header& header) {
  UsdLevel level = encode_level(tile, header, "textures/");
  std::vector<UsdFile> files = {{"tile.usdc", std::move(level.layer)}};
  for (UsdFile& texture : level.textures) files.push_back({"textures/" + texture.name, std::move(texture.bytes)});
  return pack_usdz(files);
}

}  // namespace citykiln::exporters
