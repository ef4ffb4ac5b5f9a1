#include "compiler/contract/stable_id.h"

#include <cassert>

namespace citykiln {
namespace {

// The finaliser of SplitMix64 (Steele, Lea, Flood 2014): a bijection on 64 bits in which each input bit changes half of
// the output bits.
std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

}  // namespace

std::string_view name_of(OsmType type) {
  constexpr std::string_view kNames[kOsmTypeCount] = {"none", "node", "way", "relation", "lot"};
  return kNames[static_cast<std::size_t>(type)];
}

std::string to_string(OsmId id) {
  if (id.type == OsmType::kNone) return "-";
  return "?nwrl"[static_cast<int>(id.type)] + std::to_string(id.id);
}

StableId stable_id(ObjectId object) {
  const auto type = static_cast<std::uint64_t>(object.osm.type);
  return StableId{mix(mix(static_cast<std::uint64_t>(object.osm.id)) ^ (type << 32 | object.part))};
}

StableId stable_id(StableId parent, const char* role, std::uint64_t ordinal) {
  assert(role != nullptr && *role != '\0');
  auto hash = static_cast<std::uint64_t>(parent);
  for (const char* c = role; *c != '\0'; ++c) hash = mix(hash ^ static_cast<unsigned char>(*c));
  return StableId{mix(hash ^ mix(ordinal))};
}

}  // namespace citykiln
