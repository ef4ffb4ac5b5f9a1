#include "grammars/shapes/tables.h"

#include <bit>
#include <cassert>

namespace citykiln::grammars {
namespace {

template <typename Entry>
std::uint32_t append(std::vector<Entry>& table, Entry entry) {
  table.push_back(std::move(entry));
  return static_cast<std::uint32_t>(table.size() - 1);
}

template <typename Entry, typename IndexOf>
std::uint32_t found_or_added(std::vector<Entry>& table, IndexOf& index_of, const Entry& entry) {
  const auto [found, is_new] = index_of.try_emplace(entry, static_cast<std::uint32_t>(table.size()));
  if (is_new) table.push_back(entry);
  return found->second;
}

}  // namespace

std::size_t AppearanceHash::operator()(const Appearance& appearance) const {
  std::uint64_t hash = appearance.name.size();
  const auto add = [&](std::uint64_t word) { hash = (hash ^ word) * 0x9e3779b97f4a7c15u, hash ^= hash >> 32; };
  for (const char c : appearance.name) add(static_cast<unsigned char>(c));
  for (const double v : {appearance.red, appearance.green, appearance.blue, appearance.opacity})
    add(std::bit_cast<std::uint64_t>(v));
  return hash;
}

std::uint32_t Tables::index_of(const Appearance& appearance) {
  return found_or_added(appearances, appearance_of, appearance);
}
std::uint32_t Tables::index_of(const AttributeSet& set) {
  return found_or_added(attribute_sets, attribute_set_of, set);
}
std::uint32_t Tables::add(const TextureProjection& texture) { return append(textures, texture); }
std::uint32_t Tables::add(AppearanceAreas areas) { return append(appearance_areas, std::move(areas)); }

std::optional<TextureProjection> Tables::texture_at(std::uint32_t index) const {
  assert(index < textures.size());
  if (index == 0) return std::nullopt;
  return textures[index];
}

}  // namespace citykiln::grammars
