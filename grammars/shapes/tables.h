// The tables of a derivation, to whose entries shapes refer by index: appearances, texture projections, changed
// attributes.
#pragma once

#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

/// Areas in square metres, by index into Tables::appearances.
using AppearanceAreas = std::map<std::uint32_t, double>;

struct AppearanceHash {
  std::size_t operator()(const Appearance& appearance) const;
};

/// Entry 0 of each table is the default of a first shape. Entries never change.
struct Tables {
  std::vector<Appearance> appearances = {Appearance{}};
  /// In the order of creation; may contain duplicates.
  std::vector<TextureProjection> textures = {TextureProjection{}};
  std::vector<AttributeSet> attribute_sets = {AttributeSet{}};
  /// The areas of the details that simplified terminals replace.
  std::vector<AppearanceAreas> appearance_areas = {AppearanceAreas{}};
  /// The index of each appearance. Never iterated, so its order has no effect.
  std::unordered_map<Appearance, std::uint32_t, AppearanceHash> appearance_of = {{Appearance{}, 0}};
  std::map<AttributeSet, std::uint32_t> attribute_set_of = {{AttributeSet{}, 0}};

  /// Returns the index of an entry, and adds it if the table does not contain it.
  std::uint32_t index_of(const Appearance& appearance);
  std::uint32_t index_of(const AttributeSet& set);
  /// Adds an entry and returns its index.
  std::uint32_t add(const TextureProjection& texture);
  std::uint32_t add(AppearanceAreas areas);
  /// Returns the entry at an index; std::nullopt for 0.
  std::optional<TextureProjection> texture_at(std::uint32_t index) const;
};

}  // namespace citykiln::grammars
