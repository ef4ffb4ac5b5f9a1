#include "compiler/outputs/tiles3d/tree_sink.h"

#include <fmt/format.h>

#include <utility>

#include "exporters/run_files.h"

namespace citykiln::outputs {

Result<TreeSink> TreeSink::open(const Outputs& outputs, exporters::OutputFolder& folder) {
  TreeSink sink(folder, outputs.tiles3d);
  if (!outputs.tiles3d_archive) return sink;
  Result<exporters::GrowingOutput> output = folder.begin_growing(exporters::kTilesetArchiveName);
  if (!output) return output.error();
  sink.archive_.emplace(GrowingArchive{std::move(*output)});
  return sink;
}

Result<Done> TreeSink::put(const std::string& name, std::span<const std::byte> bytes) {
  if (has_files_) {
    const std::string path = fmt::format("{}/{}", exporters::kTilesetFolder, name);
    if (Result<Done> done = folder_.write(path, bytes); !done) return done;
    files_.push_back({path, bytes.size()});
  }
  if (!archive_) return Done{};
  const Result<std::vector<std::byte>> header = add_to_archive(archive_->archive, name, bytes);
  if (!header) return header.error();
  if (Result<Done> done = append(archive_->output, *header); !done) return done;
  return append(archive_->output, bytes);
}

Result<std::vector<WrittenFile>> TreeSink::finish() {
  if (archive_) {
    const Result<std::vector<std::byte>> end = end_of_archive(std::move(archive_->archive));
    if (!end) return end.error();
    if (const Result<Done> done = append(archive_->output, *end); !done) return done.error();
    files_.push_back({archive_->output.name, archive_->output.bytes});
    if (const Result<Done> done = folder_.finish_growing(std::move(archive_->output)); !done) return done.error();
  }
  return std::move(files_);
}

}  // namespace citykiln::outputs
