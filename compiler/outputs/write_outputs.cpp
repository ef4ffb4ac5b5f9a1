#include "compiler/outputs/write_outputs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "compiler/bake/bake.h"
#include "compiler/bake/far/bake_surroundings.h"
#include "compiler/bake/far/bend.h"
#include "compiler/bake_scene.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/outputs/bake_keys.h"
#include "compiler/outputs/texture_choice.h"
#include "compiler/outputs/tile_lights.h"
#include "compiler/outputs/tile_note.h"
#include "compiler/outputs/usd_outputs.h"
#include "compiler/outputs/write_page.h"
#include "compiler/outputs/write_tiles3d.h"
#include "exporters/gltf/write/encode_clouds.h"
#include "exporters/gltf/write/encode_tile.h"
#include "exporters/kiln/manifest.h"
#include "exporters/run_files.h"
#include "exporters/usd/encode_cloud_layer.h"
#include "exporters/vdb/encode_vdb.h"

namespace citykiln::outputs {
namespace {

// Clouds are seen from farther away than tiles are.
constexpr double kCellsOfTolerance = 4, kFinestCell_m = 40, kCoarsestCell_m = 400;
constexpr double kMostTriangles = 400000, kMostVoxels = 4e6;

// Each cell of surface has two triangles.
double cell_m(const sky::CloudMeasures& clouds, double tolerance_m) {
  const double wanted_m = std::clamp(kCellsOfTolerance * tolerance_m, kFinestCell_m, kCoarsestCell_m);
  return std::max(wanted_m, std::sqrt(2 * clouds.area_m2 / kMostTriangles));
}

// The size of voxels in whole metres, doubled until they are few enough.
double voxel_m(const sky::CloudMeasures& clouds, double cell_m) {
  double voxel = std::round(cell_m);
  while (clouds.volume_m3 / (voxel * voxel * voxel) > kMostVoxels) voxel *= 2;
  return voxel;
}

class CloudWriter {
 public:
  CloudWriter(exporters::OutputFolder& folder, std::vector<WrittenFile>& files) : folder_(folder), files_(files) {}

  Result<Done> write(const char* name, const std::vector<std::byte>& bytes) {
    if (const Result<Done> done = folder_.write(name, bytes); !done) return done;
    files_.push_back({name, bytes.size()});
    return Done{};
  }

 private:
  exporters::OutputFolder& folder_;
  std::vector<WrittenFile>& files_;
};

std::vector<exporters::CloudMeshes> meshes_of(std::span<const sky::LayerParticles> layers, double cell_m, int threads) {
  std::vector<exporters::CloudMeshes> meshes;
  for (const sky::LayerParticles& layer : layers)
    meshes.push_back({layer.layer, layer.clouds, sky::cloud_surfaces(layer, cell_m, threads)});
  std::erase_if(meshes, [](const exporters::CloudMeshes& layer) { return layer.parts.empty(); });
  return meshes;
}

Result<Done> write_usd_clouds(std::span<const sky::LayerParticles> layers, Vec3 origin, double voxel_m,
                              CloudWriter& writer, std::vector<std::string>& notes) {
  const auto vdb = exporters::encode_vdb(sky::cloud_voxels(layers, origin, voxel_m));
  if (!vdb) notes.push_back(fmt::format("note: no {}: {}", exporters::kVdbName, to_string(vdb.error())));
  if (vdb)
    if (const Result<Done> done = writer.write(exporters::kVdbName, *vdb); !done) return done;
  return writer.write(exporters::kUsdCloudsName, exporters::encode_cloud_layer(layers, bool(vdb)));
}

// Writes the clouds over the scene's extent (sky::clouds_over) once for all tiles: glb/clouds.glb for .glb,
// usd/clouds.usdc and usd/clouds.vdb for USD. Writes nothing for a clear sky, or for clouds that were not asked for.
//
// The cells of the surface are 4 times the coarsest tolerance, within 40 to 400 m, and larger if the surface would
// have more than some 400,000 triangles. Voxels are cells rounded to whole metres, doubled until there are at most
// some 4 million. The smallest particles have a radius of half a cell.
// @param notes  Gets a line if the module that writes .vdb is missing; USD then has only the particles.
Result<Done> write_clouds(const scene::Scene& scene, const Outputs& outputs, int threads,
                          exporters::OutputFolder& folder, std::vector<WrittenFile>& files,
                          std::vector<std::string>& notes) {
  const auto& layers = scene.header.sky.clouds;
  const Box2& extent = scene.header.extent;
  if (!sky::has_cloud_files(scene.header.sky) || extent.is_empty() || !(outputs.glb || outputs.usd)) return Done{};
  const sky::CloudMeasures measures = sky::measures_over(layers, extent);
  const double cell = cell_m(measures, outputs.tolerances_m.back());
  const std::vector<sky::LayerParticles> particles = sky::clouds_over(layers, extent, cell / 2, threads);
  CloudWriter writer(folder, files);
  if (outputs.glb) {
    const std::vector<exporters::CloudMeshes> meshes = meshes_of(particles, cell, threads);
    if (!meshes.empty()) {
      const auto glb = exporters::encode_clouds(meshes, scene.header, cell, cell / 2);
      if (const Result<Done> done = writer.write(exporters::kGlbCloudsName, glb); !done) return done;
    }
  }
  if (!outputs.usd) return Done{};
  const Vec2 middle = extent.centre();
  return write_usd_clouds(particles, {std::round(middle.x), std::round(middle.y), 0}, voxel_m(measures, cell), writer,
                          notes);
}

Result<WrittenFile> write_output(const std::string& name, const std::vector<std::byte>& bytes,
                                 exporters::OutputFolder& folder) {
  if (const Result<Done> done = folder.write(name, bytes); !done) return done.error();
  return WrittenFile{name, bytes.size()};
}

/// An encoded tile, to be written after the tiles before it.
struct ReadyTile {
  std::vector<std::byte> glb;
  std::vector<exporters::SharedFile> shared;
  WrittenTile record;
  std::optional<ReadyUsd> usd{};
};

/// The tolerances among which one is chosen for max_bytes or max_triangles: preferred numbers, ten per factor of ten.
constexpr double kSolvedTolerances_m[] = {0.02, 0.025, 0.032, 0.04, 0.05, 0.063, 0.08, 0.1,  0.125, 0.16, 0.2,
                                          0.25, 0.32,  0.4,   0.5,  0.63, 0.8,   1,    1.25, 1.6,   2,    2.5,
                                          3.2,  4,     5,     6.3,  8,    10,    12.5, 16,   20,    25};

using Lights = std::vector<bake::PlacedLamp>;

ReadyTile ready_glb(bake::BakedTile&& tile, std::size_t level, const Lights& lights, const scene::Header& header,
                    const Outputs& outputs, int threads) {
  exporters::GlbOptions options = glb_options_of(outputs);
  options.lights = lights;
  ReadyTile ready;
  ready.record.tile = tile.tile, ready.record.level = level, ready.record.tolerance_m = tile.tolerance_m;
  ready.record.instances = exporters::instances_of(tile);
  exporters::EncodedTile encoded =
      exporters::encode_tile(std::move(tile), header, options, threads, layout_of(outputs));
  ready.record.file = {exporters::glb_name(ready.record.tile, level), encoded.glb.size()};
  ready.record.error_m = encoded.error_m, ready.record.triangles = encoded.triangles;
  ready.glb = std::move(encoded.glb), ready.shared = std::move(encoded.shared);
  return ready;
}

ReadyTile ready_tile(bake::BakedTile&& tile, std::size_t level, const Lights& lights, const scene::Header& header,
                     const Outputs& outputs, int threads) {
  ReadyTile ready;
  if (outputs.usd) ready.usd = ready_usd(tile, level, lights, header);
  // a limit of bytes is one of the .glb's
  if (!outputs.glb && !outputs.max_bytes) {
    ready.record = ready.usd->record;
    return ready;
  }
  ReadyTile with_glb = ready_glb(std::move(tile), level, lights, header, outputs, threads);
  with_glb.usd = std::move(ready.usd);
  return with_glb;
}

/// A complete tile of an earlier run.
struct WholeTile {
  const exporters::StagedFile* staged;
  TileNote note;
};

/// Returns the complete tiles of earlier runs, by chunk and level as in bake_keys(). Reads and hashes each of them.
std::vector<std::optional<WholeTile>> whole_tiles(const scene::Scene& scene, std::span<const std::uint64_t> keys,
                                                  int threads, const exporters::OutputFolder& folder) {
  std::vector<std::optional<WholeTile>> whole(keys.size());
  if (scene.chunks.empty() || !folder.has_earlier_files()) return whole;
  const std::size_t levels = keys.size() / scene.chunks.size();
  for_each_index(keys.size(), threads, [&](std::size_t i) {
    const std::string name = exporters::glb_name(scene.chunks[i / levels].tile, i % levels);
    const exporters::StagedFile* staged = folder.find_whole(name, keys[i]);
    std::optional<TileNote> note = staged != nullptr ? tile_note(staged->note) : std::nullopt;
    if (note) whole[i] = WholeTile{staged, std::move(*note)};
  });
  return whole;
}

Result<WrittenFile> write_around(bake::BakedTile tile, const scene::Header& header, const Outputs& outputs, int threads,
                                 exporters::OutputFolder& folder) {
  // one small file: on no grid of the tiles, so that only normals are packed
  exporters::GlbOptions options = glb_options_of(outputs);
  if (options.compression != Compression::kNone) options.compression = Compression::kLean;
  // nothing in it is of the map
  for (bake::Primitive& primitive : tile.primitives) primitive.features.clear();
  const exporters::EncodedTile encoded = exporters::encode_tile(std::move(tile), header, options, threads);
  return write_output(exporters::kGlbSurroundingsName, encoded.glb, folder);
}

std::string no_surroundings_note(const scene::Header& header) {
  return fmt::format("note: no surroundings are written: {}", scene::cylinder_of(header)
                                                                  ? "there is no land around a map inside of a cylinder"
                                                                  : "the manifest has none");
}

/// Bakes and writes the tiles, and reuses those that are complete.
class TileWriter {
 public:
  TileWriter(const scene::Scene& scene, const Outputs& outputs, int threads, exporters::OutputFolder& folder,
             Report& report, const TextureChoice& textures)
      : scene_(scene),
        outputs_(outputs),
        threads_(threads),
        folder_(folder),
        report_(report),
        lights_(lights_of_tiles(scene, outputs.lights, threads)),
        textures_(textures),
        usd_(scene.header, folder) {}

  Result<Done> write_all(const OnProgress& on_progress, WrittenOutputs& written) {
    keys_ = bake_keys(scene_, outputs_, threads_);
    for (std::uint64_t& key : keys_) key = std::max<std::uint64_t>(1, key ^ textures_.hash());
    // tiles with shared files are baked again: their journal lines do not name these
    whole_.resize(keys_.size());
    if (layout_of(outputs_) == Layout::kEmbedded && !outputs_.usd)
      whole_ = whole_tiles(scene_, keys_, threads_, folder_);
    ready_.resize(keys_.size());
    return bake_scene(scene_, outputs_.tolerances_m, threads_, report_, on_progress,
                      {.exists = [&](ChunkLevel at) { return whole_[index(at)].has_value(); },
                       .process =
                           [&](ChunkLevel at, bake::BakedTile&& baked) {
                             textures_.apply(baked);
                             ready_[index(at)] = ready_tile(bake::in_world(std::move(baked), scene_.header), at.level,
                                                            lights_[at.chunk], scene_.header, outputs_, threads_);
                           },
                       .take =
                           [&](ChunkLevel at, const Report& diagnosed) {
                             return whole_[index(at)] ? take_over(at, written) : write(at, diagnosed, written);
                           }},
                      most_instances_of(outputs_.target));
  }

  // Writes one level per tile, the finest within the limits.
  Result<Done> write_solved(const OnProgress& on_progress, WrittenOutputs& written) {
    const auto prototypes = std::make_shared<const bake::PrototypeCache>(scene_.header);
    std::size_t too_large = 0;
    for (std::size_t chunk = 0; chunk < scene_.chunks.size(); ++chunk) {
      on_progress("bake", static_cast<double>(chunk) / static_cast<double>(scene_.chunks.size()));
      const SolvedTile solved = solve(chunk, prototypes);
      too_large += !fits(solved.tile.record);
      report_.append(solved.diagnosed);
      if (Result<Done> done = write_ready({chunk, 0}, solved.tile, solved.diagnosed, 0, written); !done) return done;
    }
    written.solved = solved_line(outputs_.glb ? written.files.tiles : written.files.usd, too_large);
    return Done{};
  }

  // Writes the files that refer to others, after all tiles.
  Result<Done> finish(WrittenOutputs& written) {
    if (outputs_.surroundings != AroundWish::kNo)
      if (const Result<Done> done = write_surroundings(written); !done) return done;
    return outputs_.usd ? usd_.finish(written.files) : Done{};
  }

 private:
  Result<Done> write_surroundings(WrittenOutputs& written) {
    if (!outputs_.usd && !outputs_.glb) return Done{};
    const std::optional<bake::BakedTile> tile = bake::bake_surroundings(scene_);
    if (!tile) {
      written.notes.push_back(no_surroundings_note(scene_.header));
      return Done{};
    }
    if (outputs_.usd)
      if (const Result<Done> done = usd_.write_surroundings(*tile, written.files); !done) return done;
    if (!outputs_.glb) return Done{};
    const Result<WrittenFile> file = write_around(*tile, scene_.header, outputs_, threads_, folder_);
    if (!file) return file.error();
    written.files.files.push_back(*file);
    return Done{};
  }

  struct SolvedTile {
    ReadyTile tile;
    Report diagnosed;
  };

  bool fits(const WrittenTile& tile) const {
    return (!outputs_.max_bytes || tile.file.bytes <= *outputs_.max_bytes) &&
           (!outputs_.max_triangles || tile.triangles <= *outputs_.max_triangles);
  }

  // Finds the finest tolerance that fits by bisection of kSolvedTolerances_m; the coarsest if none fits.
  SolvedTile solve(std::size_t chunk, const std::shared_ptr<const bake::PrototypeCache>& prototypes) const {
    const auto baked_at = [&](double tolerance_m) {
      SolvedTile out;
      const auto prepared = bake::prepare(scene_.header, scene_.chunks[chunk], std::span(&tolerance_m, 1), threads_,
                                          prototypes, most_instances_of(outputs_.target));
      bake::BakedTile baked = bake::bake_prepared(*prepared, 0, threads_, out.diagnosed);
      textures_.apply(baked);
      out.tile = ready_tile(bake::in_world(std::move(baked), scene_.header), 0, lights_[chunk], scene_.header, outputs_,
                            threads_);
      return out;
    };
    std::optional<SolvedTile> found;
    std::size_t first = 0, last = std::size(kSolvedTolerances_m);  // the finest that fits is in [first, last]
    while (first < last) {
      const std::size_t middle = (first + last) / 2;
      SolvedTile tried = baked_at(kSolvedTolerances_m[middle]);
      if (fits(tried.tile.record))
        last = middle, found = std::move(tried);
      else
        first = middle + 1;
    }
    return found ? std::move(*found) : baked_at(*std::rbegin(kSolvedTolerances_m));
  }

  static std::string solved_line(std::span<const WrittenTile> tiles, std::size_t too_large) {
    if (tiles.empty()) return "";
    const auto [least, most] = std::ranges::minmax(tiles, {}, &WrittenTile::tolerance_m);
    std::string line = fmt::format("one level a tile, of {:.4g} to {:.4g} m", least.tolerance_m, most.tolerance_m);
    return too_large == 0 ? line
                          : line + fmt::format("; {} tiles are above the limit at the coarsest level", too_large);
  }

  std::size_t index(ChunkLevel at) const { return at.chunk * outputs_.tolerances_m.size() + at.level; }

  Result<Done> write(ChunkLevel at, const Report& diagnosed, WrittenOutputs& written) {
    return write_ready(at, std::exchange(ready_[index(at)], {}), diagnosed, keys_[index(at)], written);
  }

  // @param key  0: no later run can reuse the .glb.
  Result<Done> write_ready(ChunkLevel at, const ReadyTile& ready, const Report& diagnosed, std::uint64_t key,
                           WrittenOutputs& written) {
    add(at, ready.record, diagnosed, written);
    if (ready.usd)
      if (Result<Done> done = usd_.write(*ready.usd, written.files); !done) return done;
    if (!outputs_.glb) return Done{};
    if (Result<Done> done = write_shared(ready.shared, written.files.files); !done) return done;
    if (key == 0) return folder_.write(ready.record.file.name, ready.glb);
    return folder_.write(ready.record.file.name, ready.glb, key, text_of(TileNote{ready.record, diagnosed}));
  }

  // Writes the files that no tile before has written.
  Result<Done> write_shared(const std::vector<exporters::SharedFile>& shared, std::vector<WrittenFile>& files) {
    for (const exporters::SharedFile& file : shared) {
      const std::string name = std::string(exporters::kGlbFolder) + "/" + file.name;
      if (std::ranges::find(files, name, &WrittenFile::name) != files.end()) continue;
      const Result<WrittenFile> done = write_output(name, file.bytes, folder_);
      if (!done) return done.error();
      files.push_back(*done);
    }
    return Done{};
  }

  Result<Done> take_over(ChunkLevel at, WrittenOutputs& written) {
    const WholeTile whole = *std::exchange(whole_[index(at)], std::nullopt);
    if (Result<Done> done = folder_.take_over(*whole.staged); !done) return done;
    report_.append(whole.note.diagnosed);
    add(at, whole.note.tile, whole.note.diagnosed, written);
    ++written.taken_over;
    return Done{};
  }

  void add(ChunkLevel at, const WrittenTile& record, const Report& diagnosed, WrittenOutputs& written) const {
    if (outputs_.glb) written.files.tiles.push_back(record);
    for (Finding& finding : findings_of(diagnosed, scene_.header, scene_.chunks[at.chunk], at.level))
      written.findings.push_back(std::move(finding));
  }

  const scene::Scene& scene_;
  const Outputs& outputs_;
  int threads_;
  exporters::OutputFolder& folder_;
  Report& report_;
  std::vector<Lights> lights_;       ///< By chunk.
  std::vector<std::uint64_t> keys_;  ///< By chunk and level, like the next members.
  std::vector<std::optional<WholeTile>> whole_;
  std::vector<ReadyTile> ready_;
  const TextureChoice& textures_;
  UsdWriter usd_;
};

// Writes the outputs that need heights above the ellipsoid.
Result<Done> write_on_ellipsoid(const scene::Scene& scene, const Outputs& outputs, const TextureChoice& textures,
                                int threads, exporters::OutputFolder& folder, Report& report,
                                const OnProgress& on_progress, WrittenOutputs& written) {
  if (!has_tileset(outputs) && !outputs.page) return Done{};
  const Result<map::Geoid> geoid = geoid_of(scene.header, outputs);
  if (!geoid) return geoid.error();
  if (has_tileset(outputs)) {
    auto files = write_tiles3d(scene, outputs, *geoid, textures, threads, folder, report, on_progress);
    if (!files) return files.error();
    std::ranges::move(*files, std::back_inserter(written.files.files));
  }
  if (outputs.page) {
    auto files = write_page(scene, outputs, *geoid, threads, folder);
    if (!files) return files.error();
    std::ranges::move(*files, std::back_inserter(written.files.files));
  }
  return Done{};
}

}  // namespace

Result<WrittenOutputs> write_outputs(const scene::Scene& scene, const Outputs& outputs, int threads,
                                     exporters::OutputFolder& folder, Report& report, const OnProgress& on_progress) {
  assert(std::ranges::is_sorted(outputs.tolerances_m));
  WrittenOutputs written;
  Result<std::vector<MaterialSet>> sets = sets_of(outputs);
  if (!sets) return sets.error();
  for (const std::string& credit : credits_of(*sets)) written.notes.push_back("textures of " + credit);
  const TextureChoice textures(outputs, scene.header.seed, *sets);
  if (outputs.manifest) {
    on_progress("write", 0);
    const std::vector<std::byte> manifest = exporters::encode_manifest(scene, threads);
    if (const auto done = exporters::check_header(manifest, exporters::kManifestName); !done) return done.error();
    const Result<WrittenFile> file = write_output(exporters::kManifestName, manifest, folder);
    if (!file) return file.error();
    written.files.files.push_back(*file);
  }
  if (const auto done = write_clouds(scene, outputs, threads, folder, written.files.files, written.notes); !done)
    return done.error();
  if (const auto done = write_on_ellipsoid(scene, outputs, textures, threads, folder, report, on_progress, written);
      !done)
    return done.error();
  if (!outputs.glb && !outputs.usd) return written;
  TileWriter writer(scene, outputs, threads, folder, report, textures);
  if (outputs.max_bytes || outputs.max_triangles) {
    if (const Result<Done> solved = writer.write_solved(on_progress, written); !solved) return solved.error();
    if (const Result<Done> done = writer.finish(written); !done) return done.error();
    return written;
  }
  Result<Done> done = writer.write_all(on_progress, written);
  if (done) done = writer.finish(written);
  if (done) return written;
  if (!folder.has_keyed_files()) return done.error();
  return Error{done.error().where, done.error().message + "; the tiles baked so far are kept for the same command"};
}

Result<std::optional<WrittenFile>> write_glb_surroundings(const scene::Scene& scene, const Outputs& outputs,
                                                          int threads, exporters::OutputFolder& folder) {
  std::optional<bake::BakedTile> tile = bake::bake_surroundings(scene);
  if (!tile) return std::optional<WrittenFile>{};
  Result<WrittenFile> file = write_around(std::move(*tile), scene.header, outputs, threads, folder);
  if (!file) return file.error();
  return std::optional(std::move(*file));
}

Result<Done> commit_outputs(const WrittenOutputs& written, const std::string& report_json, const scene::Header& header,
                            exporters::OutputFolder& folder) {
  const std::string findings = findings_json(written.findings, header);
  if (Result<Done> done = folder.write(exporters::kFindingsName, exporters::bytes_of(findings)); !done) return done;
  if (Result<Done> done = folder.write(exporters::kReportName, exporters::bytes_of(report_json)); !done) return done;
  return folder.commit();
}

std::vector<std::string> notes_of(const std::string& folder, const WrittenOutputs& written,
                                  const exporters::FileList& files) {
  std::vector<std::string> notes;
  if (!written.solved.empty()) notes.push_back(written.solved);
  notes.insert(notes.end(), written.notes.begin(), written.notes.end());
  if (written.taken_over > 0)
    notes.push_back(fmt::format("note: {} of {} tile files were whole from an earlier run and not baked again",
                                written.taken_over, written.files.tiles.size()));
  const std::vector<std::string> unlisted = exporters::unlisted_files(folder, files);
  if (unlisted.empty()) return notes;
  constexpr std::size_t kNamed = 5;
  const auto end = unlisted.begin() + static_cast<std::ptrdiff_t>(std::min(kNamed, unlisted.size()));
  const std::string more = end != unlisted.end() ? fmt::format(" and {} more", unlisted.end() - end) : "";
  notes.push_back(fmt::format("note: {} holds files that citykiln did not write; they stay: {}{}", folder,
                              fmt::join(unlisted.begin(), end, ", "), more));
  return notes;
}

}  // namespace citykiln::outputs
