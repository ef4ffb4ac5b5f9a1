#include "compiler/commands/write_outputs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <optional>
#include <span>
#include <utility>

#include "compiler/commands/bake_keys.h"
#include "compiler/contract/for_each_slot.h"
#include "compiler/pipeline.h"
#include "compiler/verify/tile_note.h"
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

/// A tile that an interrupted run left whole.
struct WholeTile {
  const exporters::StagedFile* staged;
  verify::TileNote note;
};

/// The whole tiles of an interrupted run, by chunk and level as in bake_keys(). Reads and hashes each of them.
std::vector<std::optional<WholeTile>> whole_tiles(const scene::Scene& scene, std::span<const std::uint64_t> keys,
                                                  int threads, const exporters::OutputFolder& folder) {
  std::vector<std::optional<WholeTile>> whole(keys.size());
  if (scene.chunks.empty() || !folder.has_keyed_files()) return whole;
  const std::size_t levels = keys.size() / scene.chunks.size();
  for_each_index(keys.size(), threads, [&](std::size_t i) {
    const std::string name = exporters::glb_name(scene.chunks[i / levels].tile, i % levels);
    const exporters::StagedFile* staged = folder.find_whole(name, keys[i]);
    std::optional<verify::TileNote> note = staged != nullptr ? verify::tile_note(staged->note) : std::nullopt;
    if (note) whole[i] = WholeTile{staged, std::move(*note)};
  });
  return whole;
}

/// Bakes and writes the tiles that are not whole, and takes over those that are.
class TileWriter {
 public:
  TileWriter(const scene::Scene& scene, const Outputs& outputs, int threads, exporters::OutputFolder& folder,
             Report& report)
      : scene_(scene), outputs_(outputs), threads_(threads), folder_(folder), report_(report) {}

  Result<Done> write_all(const OnProgress& on_progress, WrittenOutputs& written) {
    keys_ = bake_keys(scene_, outputs_, threads_);
    whole_ = whole_tiles(scene_, keys_, threads_, folder_);
    ready_.resize(keys_.size());
    return bake_scene(scene_, outputs_.ladder_m, threads_, report_, on_progress,
                      {.exists = [&](ChunkLevel at) { return whole_[index(at)].has_value(); },
                       .process =
                           [&](ChunkLevel at, bake::BakedTile&& baked) {
                             const bake::BakedTile tile = std::move(baked);
                             ready_[index(at)] = ready_tile(tile, at.level, scene_.header, outputs_, threads_);
                           },
                       .take =
                           [&](ChunkLevel at, const Report& diagnosed) {
                             return whole_[index(at)] ? take_over(at, written) : write(at, diagnosed, written);
                           }},
                      verify::most_instances_of(outputs_.target));
  }

 private:
  std::size_t index(ChunkLevel at) const { return at.chunk * outputs_.ladder_m.size() + at.level; }

  Result<Done> write(ChunkLevel at, const Report& diagnosed, WrittenOutputs& written) {
    const ReadyTile ready = std::exchange(ready_[index(at)], {});
    add(at, ready.record, diagnosed, written);
    return folder_.write(ready.record.file.name, ready.glb, keys_[index(at)],
                         verify::text_of(verify::TileNote{ready.record, diagnosed}));
  }

  Result<Done> take_over(ChunkLevel at, WrittenOutputs& written) {
    const WholeTile whole = *std::exchange(whole_[index(at)], std::nullopt);
    folder_.take_over(*whole.staged);
    report_.append(whole.note.diagnosed);
    add(at, whole.note.tile, whole.note.diagnosed, written);
    ++written.taken_over;
    return Done{};
  }

  void add(ChunkLevel at, const verify::WrittenTile& record, const Report& diagnosed, WrittenOutputs& written) const {
    written.files.tiles.push_back(record);
    for (verify::Finding& finding : verify::findings_of(diagnosed, scene_.header, scene_.chunks[at.chunk], at.level))
      written.findings.push_back(std::move(finding));
  }

  const scene::Scene& scene_;
  const Outputs& outputs_;
  int threads_;
  exporters::OutputFolder& folder_;
  Report& report_;
  std::vector<std::uint64_t> keys_;  ///< By chunk and level, as the following.
  std::vector<std::optional<WholeTile>> whole_;
  std::vector<ReadyTile> ready_;
};

}  // namespace

Result<WrittenOutputs> write_outputs(const scene::Scene& scene, const Outputs& outputs, int threads,
                                     exporters::OutputFolder& folder, Report& report, const OnProgress& on_progress) {
  assert(std::ranges::is_sorted(outputs.ladder_m));
  WrittenOutputs written;
  if (outputs.manifest) {
    on_progress("write", 0);
    const Result<verify::WrittenFile> file = write("scene.kiln", exporters::encode_manifest(scene, threads), folder);
    if (!file) return file.error();
    written.files.files.push_back(*file);
  }
  if (!outputs.glb) return written;
  const Result<Done> done = TileWriter(scene, outputs, threads, folder, report).write_all(on_progress, written);
  if (done) return written;
  if (!folder.has_keyed_files()) return done.error();
  return Error{done.error().where, done.error().message + "; the tiles baked so far are kept for the same command"};
}

Result<Done> commit_outputs(const WrittenOutputs& written, const std::string& report_json, const scene::Header& header,
                            exporters::OutputFolder& folder) {
  const std::string findings = verify::findings_json(written.findings, header);
  if (Result<Done> done = folder.write("findings.json", exporters::bytes_of(findings)); !done) return done;
  if (Result<Done> done = folder.write("report.json", exporters::bytes_of(report_json)); !done) return done;
  return folder.commit();
}

void print_notes(const std::string& folder, const WrittenOutputs& written, const exporters::FileList& files,
                 const Console& console) {
  if (written.taken_over > 0)
    console.print_line(fmt::format("note: {} of {} tile files were whole from an interrupted run and not baked again",
                                   written.taken_over, written.files.tiles.size()));
  const std::vector<std::string> strange = exporters::strange_files(folder, files);
  if (strange.empty()) return;
  constexpr std::size_t kNamed = 5;
  const auto end = strange.begin() + static_cast<std::ptrdiff_t>(std::min(kNamed, strange.size()));
  const std::string more = end != strange.end() ? fmt::format(" and {} more", strange.end() - end) : "";
  console.print_line(fmt::format("note: {} holds files that citykiln did not write; they stay: {}{}", folder,
                                 fmt::join(strange.begin(), end, ", "), more));
}

}  // namespace citykiln::commands
