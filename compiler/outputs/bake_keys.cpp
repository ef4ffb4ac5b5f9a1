#include "compiler/outputs/bake_keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/contract/system/program_version.h"
#include "exporters/content_hash.h"
#include "exporters/file.h"
#include "exporters/kiln/manifest.h"

namespace citykiln::outputs {
namespace {

/// The settings that change the bytes of tiles. The binding names every member of Outputs, so a new one does not
/// compile until it is added here.
std::string settings_of(const Outputs& outputs) {
  const auto& [folder, manifest, glb, usd, tiles3d, tiles3d_archive, page, surroundings, geoid, target, split, compress,
               layout, materials, has_fine_textures, lights, max_bytes, max_triangles, tolerances_m] = outputs;
  static_cast<void>(max_bytes), static_cast<void>(max_triangles);      // tiles that are solved for have no keys
  static_cast<void>(materials), static_cast<void>(has_fine_textures);  // hashed by TextureChoice
  static_cast<void>(folder), static_cast<void>(manifest), static_cast<void>(glb), static_cast<void>(usd);
  static_cast<void>(tiles3d), static_cast<void>(tiles3d_archive), static_cast<void>(page);  // written without keys
  static_cast<void>(geoid), static_cast<void>(surroundings), static_cast<void>(compress), static_cast<void>(layout);
  return fmt::format("target {} split {} compress {} layout {} lights {} ladder {}", values_of(target).name,
                     name_of(split), name_of(compression_of(outputs, target)), name_of(layout_of(outputs)), lights,
                     fmt::join(tolerances_m, ","));
}

}  // namespace

std::uint64_t program_hash() {
  const Result<std::vector<std::byte>> executable = exporters::read_file("/proc/self/exe");
  return executable ? exporters::content_hash(*executable) : exporters::content_hash(kProgramVersion);
}

std::vector<std::uint64_t> bake_keys(const scene::Scene& scene, const Outputs& outputs, int threads) {
  const std::string common =
      fmt::format("{} {} {}", program_hash(), exporters::hash_of(scene.header), settings_of(outputs));
  const std::vector<std::uint64_t> chunks = for_each_slot<std::uint64_t>(
      scene.chunks.size(), threads,
      [&](std::size_t i) { return exporters::hash_of(scene.chunks[i], scene.header.seed); });
  std::vector<std::uint64_t> keys;
  for (const std::uint64_t chunk : chunks)
    for (std::size_t level = 0; level < outputs.tolerances_m.size(); ++level)
      keys.push_back(
          std::max<std::uint64_t>(1, exporters::content_hash(fmt::format("{} {} {}", common, chunk, level))));
  return keys;
}

}  // namespace citykiln::outputs
