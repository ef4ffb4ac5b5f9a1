#include "compiler/outputs/usd_outputs.h"

#include "exporters/gltf/write/encode_tile.h"
#include "exporters/run_files.h"
#include "exporters/usd/usd_names.h"

namespace citykiln::outputs {

ReadyUsd ready_usd(const bake::BakedTile& tile, std::size_t level, const std::vector<bake::PlacedLamp>& lights,
                   const scene::Header& header) {
  exporters::UsdLevel encoded = exporters::encode_level(tile, header, "../textures/");
  const WrittenFile file{exporters::usd_level_name(tile.tile, level), encoded.layer.size()};
  return {.encoded = std::move(encoded),
          .origin = tile.origin,
          .plant_error_m = tile.plant_error_m,
          .lights = lights,
          .record = {.file = file,
                     .tile = tile.tile,
                     .level = level,
                     .tolerance_m = tile.tolerance_m,
                     .error_m = tile.error_m,
                     .triangles = exporters::triangles_of(tile),
                     .instances = exporters::instances_of(tile)}};
}

Result<Done> UsdWriter::write_file(const std::string& name, const std::vector<std::byte>& bytes,
                                   WrittenFiles& written) {
  if (const Result<Done> done = folder_.write(name, bytes); !done) return done;
  written.files.push_back({name, bytes.size()});
  return Done{};
}

Result<Done> UsdWriter::write_textures(const exporters::UsdLevel& level, WrittenFiles& written) {
  for (const exporters::UsdFile& texture : level.textures) {
    if (!textures_.insert(texture.name).second) continue;
    const Result<Done> done = write_file(exporters::kUsdTextureFolder + texture.name, texture.bytes, written);
    if (!done) return done;
  }
  return Done{};
}

Result<Done> UsdWriter::write(const ReadyUsd& ready, WrittenFiles& written) {
  if (const Result<Done> done = write_textures(ready.encoded, written); !done) return done;
  const WrittenTile& record = ready.record;
  if (tiles_.empty() || tiles_.back().tile != record.tile)
    tiles_.push_back({record.tile, ready.origin, {}, ready.lights});
  tiles_.back().levels.push_back({record.tolerance_m, record.error_m, ready.plant_error_m, ready.encoded.bounds});
  written.usd.push_back(record);
  return folder_.write(record.file.name, ready.encoded.layer);
}

Result<Done> UsdWriter::write_surroundings(const bake::BakedTile& tile, WrittenFiles& written) {
  const exporters::UsdLevel encoded = exporters::encode_level(tile, header_, "textures/");
  around_ = {tile.origin, encoded.bounds};
  if (const Result<Done> done = write_textures(encoded, written); !done) return done;
  return write_file(exporters::kUsdSurroundingsName, encoded.layer, written);
}

Result<Done> UsdWriter::finish(WrittenFiles& written) {
  for (const exporters::UsdTile& tile : tiles_) {
    const std::string name = exporters::usd_tile_name(tile.tile);
    if (const Result<Done> done = write_file(name, exporters::encode_tile_layer(tile, header_), written); !done)
      return done;
  }
  return write_file(exporters::kUsdSceneName, exporters::encode_scene(tiles_, header_, around_ ? &*around_ : nullptr),
                    written);
}

}  // namespace citykiln::outputs
