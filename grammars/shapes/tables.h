// Tables of a derivation: appearances, texture projections and changed attributes, which shapes refer to by index.
#pragma once

#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

/// Areas in square metres, by index of the appearance.
using AppearanceAreas = std::map<std::uint32_t, double>;

struct AppearanceHash {
  std::size_t operator()(const Appearance& appearance) const;
};

/// Entry 0 of each table is the default of a first shape. Entries never change.
struct Tables {
  std::vector<Appearance> appearances = {Appearance{}};
  std::vector<TextureProjection> textures = {TextureProjection{}};  ///< In order of creation; may contain duplicates.
  std::vector<AttributeSet> attribute_sets = {AttributeSet{}};
  std::vector<AppearanceAreas> appearance_areas = {AppearanceAreas{}};
  /// Not iterated, so that its order has no effect.
  std::unordered_map<Appearance, std::uint32_t, AppearanceHash> appearance_of = {{Appearance{}, 0}};
  std::map<AttributeSet, std::uint32_t> attribute_set_of = {{AttributeSet{}, 0}};

  /// The index of the entry, which is added if the table does not contain it.
  std::uint32_t index_of(const Appearance& appearance);
  std::uint32_t index_of(const AttributeSet& set);
  /// The index of a new entry.
  std::uint32_t add(const TextureProjection& texture);
  std::uint32_t add(AppearanceAreas areas);
  /// std::nullopt for 0.
  std::optional<TextureProjection> texture_at(std::uint32_t index) const;
};

}  // namespace citykiln::grammars
