// What shapes share: looks, texture frames and changed attributes stand in tables, and shapes point into them.
#pragma once

#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

/// Square metres by look.
using LookAreas = std::map<std::uint32_t, double>;

struct LookHash {
  std::size_t operator()(const Look& look) const;
};

/// Entry 0 of each is what a lot has: the default, or nothing. Entries never change.
struct Tables {
  std::vector<Look> looks = {Look{}};
  std::vector<TextureFrame> textures = {TextureFrame{}};  ///< In the order in which they were made; twins stay apart.
  std::vector<AttributeSet> attribute_sets = {AttributeSet{}};
  std::vector<LookAreas> look_areas = {LookAreas{}};
  std::unordered_map<Look, std::uint32_t, LookHash> look_of = {{Look{}, 0}};  ///< Looked up, never gone through.
  std::map<AttributeSet, std::uint32_t> attribute_set_of = {{AttributeSet{}, 0}};

  /// Where the table has it, now if not before.
  std::uint32_t index_of(const Look& look);
  std::uint32_t index_of(const AttributeSet& set);
  std::uint32_t add(const TextureFrame& texture);
  std::uint32_t add(LookAreas areas);
  /// std::nullopt for 0.
  std::optional<TextureFrame> texture_at(std::uint32_t index) const;
};

}  // namespace citykiln::grammars
