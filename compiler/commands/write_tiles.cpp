#include "compiler/commands/write_tiles.h"

#include <fmt/format.h>

#include <utility>

#include "compiler/pipeline.h"
#include "exporters/gltf/glb.h"
#include "exporters/kiln/manifest.h"
#include "exporters/gltf/quantise.h"

namespace citykiln::commands {
namespace {

Result<WrittenFile> write(const std::string& name, const std::vector<std::byte>& bytes, OutputFolder& folder) {
  if (const Result<Done> done = folder.write(name, bytes); !done) return done.error();
  return WrittenFile{name, bytes.size()};
}

/// A tile that waits for its turn to be written.
struct ReadyTile {
  std::vector<std::byte> glb;
  WrittenTile record;
};

ReadyTile ready_tile(const bake::BakedTile& tile, std::size_t level, const scene::Header& header,
                     const Outputs& outputs, int threads) {
  EncodedTile encoded = encode_tile(tile, header, outputs.instances_as_nodes, outputs.compress, threads);
  const WrittenFile file{glb_name(tile.tile, level), encoded.glb.size()};
  return {std::move(encoded.glb),
          {file, tile.tile, level, tile.tolerance_m, encoded.error_m, triangles_of(tile), instances_of(tile)}};
}

Result<std::vector<WrittenTile>> write_glbs(const scene::Scene& scene, const Outputs& outputs, int threads,
                                            OutputFolder& folder, Report& report, const OnProgress& on_progress) {
  const std::size_t levels = outputs.ladder_m.size();
  std::vector<ReadyTile> slots(scene.chunks.size() * levels);
  std::vector<WrittenTile> written;
  const Result<Done> fired = fire(
      scene, outputs.ladder_m, threads, report, on_progress,
      [&](FiredLevel at, bake::BakedTile&& baked) {
        const bake::BakedTile tile = std::move(baked);
        slots[at.chunk * levels + at.level] = ready_tile(tile, at.level, scene.header, outputs, threads);
      },
      [&](FiredLevel at) -> Result<Done> {
        const ReadyTile ready = std::exchange(slots[at.chunk * levels + at.level], {});
        written.push_back(ready.record);
        return folder.write(ready.record.file.name, ready.glb);
      });
  if (!fired) return fired.error();
  return written;
}

exporters::Compression compression_of(Compress compress) {
  if (compress == Compress::kDraco) return exporters::Compression::kDraco;
  return compress == Compress::kMeshopt ? exporters::Compression::kMeshopt : exporters::Compression::kNone;
}

}  // namespace

EncodedTile encode_tile(const bake::BakedTile& tile, const scene::Header& header, bool instances_as_nodes,
                        Compress compress, int threads) {
  using exporters::Instancing;
  const auto instancing = instances_as_nodes ? Instancing::kNodes : Instancing::kExtension;
  if (compress == Compress::kNone) return {exporters::encode_glb(tile, header, instancing), tile.error_m};
  const bake::BakedTile packed = exporters::quantised(tile);
  return {exporters::encode_glb(packed, header, instancing, compression_of(compress), threads), packed.error_m};
}

Result<Written> write_outputs(const scene::Scene& scene, const Outputs& outputs, int threads, OutputFolder& folder,
                              Report& report, const OnProgress& on_progress) {
  Written written;
  if (outputs.manifest) {
    on_progress("write", 0);
    const Result<WrittenFile> file = write("scene.kiln", exporters::encode_manifest(scene, threads), folder);
    if (!file) return file.error();
    written.files.push_back(*file);
  }
  if (!outputs.glb) return written;

  Result<std::vector<WrittenTile>> tiles = write_glbs(scene, outputs, threads, folder, report, on_progress);
  if (!tiles) return tiles.error();
  written.tiles = std::move(*tiles);
  return written;
}

std::string glb_name(scene::TileKey tile, std::size_t level) {
  return fmt::format("glb/{}_L{}.glb", to_string(tile), level);
}

std::uint64_t triangles_of(const bake::BakedTile& tile) {
  std::uint64_t count = 0;
  for (const bake::Primitive& primitive : tile.primitives) count += primitive.triangles.size();
  for (const bake::Instanced& instanced : tile.instanced) {
    for (const bake::Primitive& primitive : instanced.primitives)
      count += primitive.triangles.size() * instanced.translations.size();
  }
  return count;
}

std::uint64_t instances_of(const bake::BakedTile& tile) {
  std::uint64_t count = 0;
  for (const bake::Instanced& instanced : tile.instanced) count += instanced.translations.size();
  return count;
}

}  // namespace citykiln::commands
