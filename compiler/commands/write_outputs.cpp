#include "compiler/commands/write_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "compiler/pipeline.h"
#include "exporters/gltf/encode_tile.h"
#include "exporters/kiln/manifest.h"

namespace citykiln::commands {
namespace {

Result<verify::WrittenFile> write(const std::string& name, const std::vector<std::byte>& bytes,
                                  exporters::OutputFolder& folder) {
  if (const Result<Done> done = folder.write(name, bytes); !done) return done.error();
  return verify::WrittenFile{name, bytes.size()};
}

/// An encoded tile that waits until the tiles before it are written.
struct ReadyTile {
  std::vector<std::byte> glb;
  verify::WrittenTile record;
};

ReadyTile ready_tile(const bake::BakedTile& tile, std::size_t level, const scene::Header& header,
                     const Outputs& outputs, int threads) {
  exporters::EncodedTile encoded = exporters::encode_tile(tile, header, verify::glb_options_of(outputs), threads);
  const verify::WrittenFile file{exporters::glb_name(tile.tile, level), encoded.glb.size()};
  return {std::move(encoded.glb),
          {.file = file,
           .tile = tile.tile,
           .level = level,
           .tolerance_m = tile.tolerance_m,
           .error_m = encoded.error_m,
           .triangles = exporters::triangles_of(tile),
           .instances = exporters::instances_of(tile)}};
}

Result<std::vector<verify::WrittenTile>> write_glbs(const scene::Scene& scene, const Outputs& outputs, int threads,
                                                    exporters::OutputFolder& folder, Report& report,
                                                    const OnProgress& on_progress) {
  const std::size_t levels = outputs.ladder_m.size();
  std::vector<ReadyTile> slots(scene.chunks.size() * levels);
  std::vector<verify::WrittenTile> written;
  const Result<Done> baked = bake_scene(
      scene, outputs.ladder_m, threads, report, on_progress,
      [&](ChunkLevel at, bake::BakedTile&& baked) {
        const bake::BakedTile tile = std::move(baked);
        slots[at.chunk * levels + at.level] = ready_tile(tile, at.level, scene.header, outputs, threads);
      },
      [&](ChunkLevel at) -> Result<Done> {
        const ReadyTile ready = std::exchange(slots[at.chunk * levels + at.level], {});
        written.push_back(ready.record);
        return folder.write(ready.record.file.name, ready.glb);
      },
      verify::most_instances_of(outputs.target));
  if (!baked) return baked.error();
  return written;
}

}  // namespace

Result<verify::WrittenFiles> write_outputs(const scene::Scene& scene, const Outputs& outputs, int threads,
                                           exporters::OutputFolder& folder, Report& report,
                                           const OnProgress& on_progress) {
  assert(std::ranges::is_sorted(outputs.ladder_m));
  verify::WrittenFiles written;
  if (outputs.manifest) {
    on_progress("write", 0);
    const Result<verify::WrittenFile> file = write("scene.kiln", exporters::encode_manifest(scene, threads), folder);
    if (!file) return file.error();
    written.files.push_back(*file);
  }
  if (!outputs.glb) return written;

  Result<std::vector<verify::WrittenTile>> tiles = write_glbs(scene, outputs, threads, folder, report, on_progress);
  if (!tiles) return tiles.error();
  written.tiles = std::move(*tiles);
  return written;
}

}  // namespace citykiln::commands
