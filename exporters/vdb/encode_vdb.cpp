#include "exporters/vdb/encode_vdb.h"

#include "compiler/contract/system/load_module.h"
#include "exporters/vdb_module/vdb_io.h"

namespace citykiln::exporters {
namespace {

void take_bytes(void* owner, const char* bytes, unsigned long size) {
  const auto* first = reinterpret_cast<const std::byte*>(bytes);
  static_cast<std::vector<std::byte>*>(owner)->assign(first, first + size);
}

}  // namespace

Result<std::vector<std::byte>> encode_vdb(const sky::CloudVoxels& voxels) {
  const auto function = load_function("citykiln_vdb.so", "citykiln_encode_vdb");
  if (!function) return function.error();
  std::vector<CitykilnVdbBlock> blocks;
  for (const sky::VoxelBlock& block : voxels.blocks)
    blocks.push_back({{block.low[0], block.low[1], block.low[2]}, block.extinction.data()});
  const CitykilnVdbGrid grid{.name = "density",
                             .creator = "citykiln",
                             .voxel_m = voxels.voxel_m,
                             .origin = {voxels.origin.x, voxels.origin.y, voxels.origin.z},
                             .block_count = static_cast<int>(blocks.size()),
                             .blocks = blocks.data()};
  std::vector<std::byte> bytes;
  char error[256] = "";
  const auto encode = reinterpret_cast<decltype(&citykiln_encode_vdb)>(*function);
  if (encode(&grid, take_bytes, &bytes, error, sizeof error) != 0) return Error{"citykiln_vdb.so", error};
  return bytes;
}

}  // namespace citykiln::exporters
