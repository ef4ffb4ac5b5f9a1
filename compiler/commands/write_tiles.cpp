#include "compiler/commands/write_tiles.h"

#include <fmt/format.h>

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

/// A tile that waits for its turn to be written.
struct ReadyTile {
  std::vector<std::byte> glb;
  verify::WrittenTile record;
};

ReadyTile ready_tile(const bake::BakedTile& tile, std::size_t level, const scene::Header& header,
                     const Outputs& outputs, int threads) {
  exporters::EncodedTile encoded =
      exporters::encode_tile(tile, header, verify::instancing_of(outputs.instances_as_nodes),
                             verify::compression_of(outputs.compress), threads);
  const verify::WrittenFile file{exporters::glb_name(tile.tile, level), encoded.glb.size()};
  return {std::move(encoded.glb),
          {file, tile.tile, level, tile.tolerance_m, encoded.error_m, exporters::triangles_of(tile),
           exporters::instances_of(tile)}};
}

Result<std::vector<verify::WrittenTile>> write_glbs(const scene::Scene& scene, const Outputs& outputs, int threads,
                                                    exporters::OutputFolder& folder, Report& report,
                                                    const OnProgress& on_progress) {
  const std::size_t levels = outputs.ladder_m.size();
  std::vector<ReadyTile> slots(scene.chunks.size() * levels);
  std::vector<verify::WrittenTile> written;
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

}  // namespace

Result<verify::Written> write_outputs(const scene::Scene& scene, const Outputs& outputs, int threads,
                                      exporters::OutputFolder& folder, Report& report, const OnProgress& on_progress) {
  verify::Written written;
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
