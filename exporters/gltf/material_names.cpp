#include "exporters/gltf/material_names.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "exporters/gltf/format_error.h"

namespace citykiln::exporters {
namespace {

using materials::ColourSource;

struct Suffix {
  std::string_view text;
  ColourSource colour_source;
  bool is_untextured = false;
};
constexpr Suffix kSuffixes[] = {{"", ColourSource::kByMaterial},
                                {"Untextured", ColourSource::kByMaterial, true},
                                {"Marked", ColourSource::kByMarkingAtlas},
                                {"FacadeAtlas", ColourSource::kByAtlas},
                                {"Cutout", ColourSource::kByCutout}};

}  // namespace

std::string material_name(const bake::PrimitiveKey& key, std::span<const materials::SharedTexture> textures) {
  const bool is_by_material = key.colour_source == ColourSource::kByMaterial;
  const bool is_untextured =
      is_by_material && !key.has_uvs && std::ranges::count(textures, key.material, &materials::Texture::material) > 0;
  const auto suffix = std::ranges::find_if(kSuffixes, [&](const Suffix& s) {
    return s.colour_source == key.colour_source && s.is_untextured == is_untextured;
  });
  assert(suffix != std::end(kSuffixes));
  return std::string(values_of(key.material).name) + std::string(suffix->text);
}

std::optional<materials::Material> material_named(std::string_view name) {
  for (int m = 0; m < static_cast<int>(materials::Material::kCount); ++m)
    if (const auto material = static_cast<materials::Material>(m); values_of(material).name == name) return material;
  return std::nullopt;
}

std::optional<std::string_view> strip_suffix(std::string_view name, std::string_view suffix) {
  if (!name.ends_with(suffix)) return std::nullopt;
  return name.substr(0, name.size() - suffix.size());
}

bake::PrimitiveKey primitive_key_named(const std::string& name) {
  const std::string_view own = std::string_view(name).substr(0, name.find('_'));
  for (const Suffix& suffix : kSuffixes)
    if (const auto beginning = strip_suffix(own, suffix.text))
      if (const auto material = material_named(*beginning))
        return {{}, *material, suffix.colour_source != ColourSource::kByMaterial, suffix.colour_source};
  throw FormatError{"a material that citykiln has, not \"" + name + "\""};
}

}  // namespace citykiln::exporters
