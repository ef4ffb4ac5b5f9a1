// make_seeds FOLDER FILE…: writes first inputs for the fuzz programs, from valid manifests and tiles, and from made-up
// tiles with a marking atlas and a facade atlas: plain, compressed by Draco and by meshoptimizer, and their pictures.
#include <cstdio>
#include <filesystem>

#include "exporters/file.h"
#include "exporters/gltf/pictures/png.h"
#include "exporters/gltf/write/encode_tile.h"
#include "exporters/kiln/manifest.h"
#include "exporters/usd/encode_level.h"
#include "tests/exporters/made_tile.h"
#include "tests/fuzz/unpacked.h"

namespace {

using citykiln::Compression, citykiln::Target;
using namespace citykiln::exporters;

// Writes a seed to the folder of its program, named after its file.
void write_seed(const std::filesystem::path& folder, const std::string& name, const fuzz::Bytes& seed) {
  std::filesystem::create_directories(folder);
  const auto done = write_file((folder / name).string(), std::as_bytes(std::span(seed)));
  if (!done) std::fprintf(stderr, "%s\n", to_string(done.error()).c_str());
}

fuzz::ByteSpan span_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

// Writes the seeds of a tile, plain and compressed.
void write_made_glbs(const std::filesystem::path& folder, const citykiln::bake::BakedTile& tile, std::uint32_t seed) {
  constexpr std::pair<Compression, const char*> kPacked[] = {{Compression::kNone, "made_"},
                                                             {Compression::kQuantize, "quantize_"},
                                                             {Compression::kDraco, "draco_"},
                                                             {Compression::kMeshopt, "meshopt_"}};
  for (const auto& [compression, name] : kPacked) {
    const auto target = seed % 2 == 0 ? Target::kThree : Target::kGeneric;
    const auto glb =
        encode_tile(tile, {}, {.target = target, .compression = compression, .has_exact_pictures = true}, 1).glb;
    write_seed(folder, name + std::to_string(seed), fuzz::unpacked_glb(span_of(glb)));
  }
}

void write_made_seeds(const std::filesystem::path& folder) {
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    const auto tile = made_facade_tile(seed);
    const auto png = encode_png(tile.marking_atlas);
    write_made_glbs(folder / "glb", tile, seed);
    for (const auto& [form, name] : {std::pair(UsdForm::kText, "text_"), std::pair(UsdForm::kCrate, "crate_")}) {
      const auto layer = encode_level(tile, {}, "", form).layer;
      write_seed(folder / "usd", name + std::to_string(seed), {span_of(layer).begin(), span_of(layer).end()});
    }
    write_seed(folder / "png", "made_" + std::to_string(seed), {span_of(png).begin(), span_of(png).end()});
  }
}

}  // namespace

int main(int count, char** words) {
  const std::filesystem::path folder = count > 1 ? words[1] : "";
  write_made_seeds(folder);
  for (int i = 2; i < count; ++i) {
    const auto read = read_file(words[i]);
    if (!read) return std::fprintf(stderr, "%s\n", to_string(read.error()).c_str()), 1;
    const fuzz::ByteSpan bytes = span_of(*read);
    const std::string name = std::to_string(i - 2);
    if (std::string_view(words[i]).ends_with(".glb")) {
      write_seed(folder / "glb", name, fuzz::unpacked_glb(bytes));
      continue;
    }
    const auto scene = decode_manifest(*read, words[i], {});
    if (!scene) return std::fprintf(stderr, "%s\n", to_string(scene.error()).c_str()), 1;
    write_seed(folder / "manifest", name, fuzz::unpacked_manifest(bytes));
    for (std::size_t c = 0; c < scene->chunks.size(); ++c)
      write_seed(folder / "chunk", name + "_" + std::to_string(c),
                 fuzz::unpacked_streams(encode_chunk(scene->chunks[c], scene->header.seed)));
  }
  return 0;
}
