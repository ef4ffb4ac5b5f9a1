#include "exporters/vdb_module/vdb_io.h"

#include <openvdb/io/Archive.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <sstream>
#include <string>

namespace {

using Leaf = openvdb::FloatTree::LeafNodeType;

openvdb::FloatGrid::Ptr grid_of(const CitykilnVdbGrid& from) {
  auto grid = openvdb::FloatGrid::create(0);
  for (int b = 0; b < from.block_count; ++b) {
    const CitykilnVdbBlock& block = from.blocks[b];
    auto leaf = std::make_unique<Leaf>(openvdb::Coord(block.low[0], block.low[1], block.low[2]), 0.0f, false);
    for (openvdb::Index i = 0; i < Leaf::SIZE; ++i)
      if (block.values[i] > 0) leaf->setValueOn(i, block.values[i]);
    grid->tree().addLeaf(leaf.release());
  }
  grid->tree().prune();
  grid->setName(from.name), grid->setCreator(from.creator);
  grid->setGridClass(openvdb::GRID_FOG_VOLUME), grid->setSaveFloatAsHalf(true);
  auto transform = openvdb::math::Transform::createLinearTransform(from.voxel_m);
  transform->postTranslate({from.origin[0], from.origin[1], from.origin[2]});
  grid->setTransform(transform);
  return grid;
}

// A file in memory, with places of grids, as files on a disk have them.
class Archive : public openvdb::io::Archive {
 public:
  std::string bytes_of(const openvdb::GridBase::Ptr& grid) const {
    std::ostringstream out(std::ios::binary);
    write(out, openvdb::GridCPtrVec{grid}, true);
    return std::move(out).str();
  }
};

// The header: magic number (8 bytes), versions of file and library (12), a flag (1), and a random id as text. Source:
// openvdb/io/Archive.cc, writeHeader().
constexpr std::size_t kIdBegin = 21, kIdSize = 36;

bool set_fixed_id(std::string& bytes) {
  if (bytes.size() < kIdBegin + kIdSize) return false;
  const auto id = bytes.begin() + kIdBegin;
  const auto is_id = [](char c) { return c == '-' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  if (!std::all_of(id, id + kIdSize, is_id) || id[8] != '-' || id[23] != '-') return false;
  std::transform(id, id + kIdSize, id, [](char c) { return c == '-' ? '-' : '0'; });
  return true;
}

}  // namespace

int citykiln_encode_vdb(const CitykilnVdbGrid* grid, CitykilnTakeBytes take, void* owner, char* error, int error_size) {
  try {
    openvdb::initialize();
    std::string bytes = Archive().bytes_of(grid_of(*grid));
    if (!set_fixed_id(bytes)) throw std::runtime_error("OpenVDB writes another header than version 10");
    take(owner, bytes.data(), bytes.size());
    return 0;
  } catch (const std::exception& problem) {
    std::snprintf(error, static_cast<std::size_t>(error_size), "%s", problem.what());
    return 1;
  }
}
