#include "exporters/gltf/glb_names.h"

#include "exporters/gltf/glb_source.h"

namespace citykiln::exporters {
namespace {

using materials::Coloured;

// What a material's name ends with says what colours it.
constexpr std::pair<std::string_view, Coloured> kEndings[] = {{"", Coloured::kByMaterial},
                                                              {"Plain", Coloured::kByMaterial},
                                                              {"Marked", Coloured::kBySheet},
                                                              {"Imprinted", Coloured::kByAtlas},
                                                              {"Cutout", Coloured::kByCutout}};

}  // namespace

std::optional<materials::Material> material_called(std::string_view name) {
  for (int m = 0; m < static_cast<int>(materials::Material::kCount); ++m)
    if (const auto material = static_cast<materials::Material>(m); values_of(material).name == name) return material;
  return std::nullopt;
}

std::optional<std::string_view> without(std::string_view name, std::string_view ending) {
  if (!name.ends_with(ending)) return std::nullopt;
  return name.substr(0, name.size() - ending.size());
}

bake::PrimitiveKey key_named(const std::string& name) {
  for (const auto& [ending, coloured] : kEndings)
    if (const auto beginning = without(name, ending))
      if (const auto material = material_called(*beginning))
        return {*material, coloured != Coloured::kByMaterial, coloured};
  throw Wrong{"a material that citykiln has, not \"" + name + "\""};
}

}  // namespace citykiln::exporters
