#include "exporters/gltf/material_names.h"

#include "exporters/gltf/glb_reader.h"

namespace citykiln::exporters {
namespace {

using materials::ColourSource;

// What a material's name ends with says what colours it.
constexpr std::pair<std::string_view, ColourSource> kEndings[] = {{"", ColourSource::kByMaterial},
                                                                  {"Untextured", ColourSource::kByMaterial},
                                                                  {"Marked", ColourSource::kByMarkingAtlas},
                                                                  {"Facade", ColourSource::kByAtlas},
                                                                  {"Cutout", ColourSource::kByCutout}};

}  // namespace

std::optional<materials::Material> material_named(std::string_view name) {
  for (int m = 0; m < static_cast<int>(materials::Material::kCount); ++m)
    if (const auto material = static_cast<materials::Material>(m); values_of(material).name == name) return material;
  return std::nullopt;
}

std::optional<std::string_view> strip_suffix(std::string_view name, std::string_view ending) {
  if (!name.ends_with(ending)) return std::nullopt;
  return name.substr(0, name.size() - ending.size());
}

bake::PrimitiveKey primitive_key_named(const std::string& name) {
  for (const auto& [ending, colour_source] : kEndings)
    if (const auto beginning = strip_suffix(name, ending))
      if (const auto material = material_named(*beginning))
        return {*material, colour_source != ColourSource::kByMaterial, colour_source};
  throw FormatError{"a material that citykiln has, not \"" + name + "\""};
}

}  // namespace citykiln::exporters
