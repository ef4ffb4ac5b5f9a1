#include "compiler/outputs/write_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/map/plane/geoid.h"
#include "compiler/outputs/page_records.h"
#include "compiler/outputs/page_skies.h"
#include "exporters/page/page_files.h"
#include "exporters/page/page_json.h"
#include "exporters/run_files.h"

namespace citykiln::outputs {
namespace {

/// The name of the map without its ending: "town" of "town.osm.pbf".
std::string title_of(const scene::Header& header) {
  if (header.sources.empty()) return "citykiln";
  const std::string& source = header.sources.front();
  return source.substr(0, source.find('.'));
}

exporters::PageFacts facts_of(const scene::Scene& scene, const Outputs& outputs, const map::Geoid& geoid, int threads) {
  const scene::Header& header = scene.header;
  const auto keeps_tags = [](const scene::Chunk& chunk) {
    return std::ranges::any_of(chunk.texts, [](const map::ElementText& text) { return !text.tags.empty(); });
  };
  return {.title = title_of(header),
          .attributions = header.attributions,
          .levels_m = outputs.tolerances_m,
          .region_m = header.extent,
          .ground_m = header.sky.ground_m + map::height_m(geoid, header.extent.centre()),
          .lights = outputs.lights,
          .has_tags = std::ranges::any_of(scene.chunks, keeps_tags),
          .skies = page_skies(header, threads)};
}

class PageWriter {
 public:
  explicit PageWriter(exporters::OutputFolder& folder) : folder_(folder) {}

  Result<Done> write(const std::string& name, std::span<const std::byte> bytes) {
    if (const Result<Done> done = folder_.write(name, bytes); !done) return done;
    files.push_back({name, bytes.size()});
    return Done{};
  }
  Result<Done> write(const std::string& name, const std::string& text) {
    return write(name, exporters::bytes_of(text));
  }

  Result<Done> write_program_files() {
    for (const exporters::PageFile& file : exporters::page_files())
      if (const Result<Done> done = write(file.name, file.bytes); !done) return done;
    return Done{};
  }

  Result<Done> write_records(const exporters::FeatureRecords& records) {
    const std::vector<std::string> texts = exporters::feature_files(records, exporters::feature_file_count(records));
    for (std::size_t i = 0; i < texts.size(); ++i)
      if (const auto done = write(fmt::format("{}{}.json", exporters::kPageFeatureFolder, i), texts[i]); !done)
        return done;
    return write(exporters::kPageNamesName, exporters::names_json(records));
  }

  std::vector<WrittenFile> files;

 private:
  exporters::OutputFolder& folder_;
};

}  // namespace

Result<std::vector<WrittenFile>> write_page(const scene::Scene& scene, const Outputs& outputs, int threads,
                                            exporters::OutputFolder& folder) {
  const Result<map::Geoid> geoid = map::read_geoid(outputs.geoid, scene.header.extent, map::Plane(scene.header.origin));
  if (!geoid) return geoid.error();
  const exporters::FeatureRecords records = page_records(scene, *geoid);
  exporters::PageFacts facts = facts_of(scene, outputs, *geoid, threads);
  facts.feature_files = exporters::feature_file_count(records);
  PageWriter writer(folder);
  if (const Result<Done> done = writer.write_program_files(); !done) return done.error();
  if (const Result<Done> done = writer.write(exporters::kPageName, exporters::page_json(facts, records)); !done)
    return done.error();
  if (const Result<Done> done = writer.write_records(records); !done) return done.error();
  return std::move(writer.files);
}

}  // namespace citykiln::outputs
