// What shapes share: looks, texture frames and changed attributes stand in tables, and shapes point into them.
#pragma once

#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

/// Square metres by look.
using AppearanceAreas = std::map<std::uint32_t, double>;

struct AppearanceHash {
  std::size_t operator()(const Appearance& look) const;
};

/// Entry 0 of each is what a lot has: the default, or nothing. Entries never change.
struct Tables {
  std::vector<Appearance> looks = {Appearance{}};
  std::vector<TextureProjection> textures = {
      TextureProjection{}};  ///< In the order in which they were made; twins stay apart.
  std::vector<AttributeSet> attribute_sets = {AttributeSet{}};
  std::vector<AppearanceAreas> appearance_areas = {AppearanceAreas{}};
  std::unordered_map<Appearance, std::uint32_t, AppearanceHash> appearance_of = {
      {Appearance{}, 0}};  ///< Looked up, never gone through.
  std::map<AttributeSet, std::uint32_t> attribute_set_of = {{AttributeSet{}, 0}};

  /// Where the table has it, now if not before.
  std::uint32_t index_of(const Appearance& look);
  std::uint32_t index_of(const AttributeSet& set);
  std::uint32_t add(const TextureProjection& texture);
  std::uint32_t add(AppearanceAreas areas);
  /// std::nullopt for 0.
  std::optional<TextureProjection> texture_at(std::uint32_t index) const;
};

}  // namespace citykiln::grammars
