#include "compiler/outputs/texture_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "exporters/content_hash.h"

namespace citykiln::outputs {
namespace {

// Texels of a side of a set, usually and with --textures fine.
constexpr std::uint32_t kUsualSide_px = 512, kFineSide_px = 1024;
constexpr std::uint32_t kFineScale = kFineSide_px / kUsualSide_px;

std::uint64_t hash_of_image(const materials::TextureImage& image) {
  return exporters::content_hash(std::as_bytes(std::span(image.texels)));
}

std::uint64_t hash_of_sets(const std::vector<MaterialSet>& sets, bool is_fine) {
  if (sets.empty() && !is_fine) return 0;
  std::string all = is_fine ? "fine" : "usual";
  for (const MaterialSet& set : sets)
    all += fmt::format(" {} {} {} {} {}", values_of(set.texture.material).name, side_m(set.texture),
                       hash_of_image(set.texture.colour), hash_of_image(set.texture.normal),
                       hash_of_image(set.texture.surface));
  return exporters::content_hash(all);
}

std::vector<ChosenTexture> chosen(const std::vector<MaterialSet>& sets) {
  std::vector<ChosenTexture> own;
  for (const MaterialSet& set : sets) {
    materials::Texture colour_only = set.texture;
    colour_only.normal = {}, colour_only.surface = {};
    own.push_back({materials::SharedTexture(set.texture), materials::SharedTexture(std::move(colour_only))});
  }
  return own;
}

}  // namespace

TextureChoice::TextureChoice(const Outputs& outputs, std::uint64_t seed, const std::vector<MaterialSet>& sets)
    : own_(chosen(sets)),
      is_fine_(outputs.has_fine_textures),
      fine_(seed, kFineScale),
      hash_(hash_of_sets(sets, is_fine_)) {}

void TextureChoice::apply(bake::BakedTile& tile) const {
  if (hash_ == 0) return;
  for (materials::SharedTexture& texture : tile.textures) {
    const materials::Material material = texture->material;
    const auto own = std::ranges::find(own_, material, [](const ChosenTexture& each) { return each.whole->material; });
    if (own != own_.end())
      texture = has_normals(material, tile.tolerance_m) ? own->whole : own->colour_only;
    else if (is_fine_)
      texture = fine_.texture(material, tile.tolerance_m);
  }
}

std::vector<std::string> credits_of(const std::vector<MaterialSet>& sets) {
  std::vector<std::string> lines;
  for (const MaterialSet& set : sets)
    if (!set.credit.empty() || !set.licence.empty())
      lines.push_back(fmt::format("{}: {}{}{}", words_of(set.texture.material), set.credit,
                                  set.credit.empty() || set.licence.empty() ? "" : ", ", set.licence));
  return lines;
}

Result<std::vector<MaterialSet>> sets_of(const Outputs& outputs) {
  return read_material_sets(outputs.materials_folder, outputs.has_fine_textures ? kFineSide_px : kUsualSide_px);
}

}  // namespace citykiln::outputs
