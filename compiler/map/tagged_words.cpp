#include "compiler/map/tagged_words.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <utility>
#include <vector>

#include "compiler/contract/texts/parse.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/places.h"
#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

using materials::Material;

struct MaterialWord {
  std::string_view value;
  Material material;
};
constexpr MaterialWord kWalls[] = {
#define WALL(value, material) {value, Material::material},
#include "compiler/map/buildings/material_values.inc"
#undef WALL
};
constexpr MaterialWord kRoofs[] = {
#define ROOF(value, material) {value, Material::material},
#include "compiler/map/buildings/material_values.inc"
#undef ROOF
};

struct SurfaceWord {
  std::string_view value;
  bool is_paved;
};
constexpr SurfaceWord kSurfaces[] = {
#define SURFACE(value, is_paved) {value, is_paved},
#include "compiler/map/land_cover/surfaces.inc"
#undef SURFACE
};

struct ThingWord {
  std::string_view value, word;
};
constexpr ThingWord kThingMaterials[] = {
#define THING_MATERIAL(value, word) {value, word},
#include "compiler/map/things/thing_materials.inc"
#undef THING_MATERIAL
};

struct KnownWords {
  std::string_view key, values;
};
constexpr KnownWords kKnownWords[] = {
#define WORD(key, values) {key, values},
#include "compiler/map/known_words.inc"
#undef WORD
};

constexpr std::string_view kStates[] = {
#define LIFECYCLE(key, presence) key,
#include "compiler/map/tags/lifecycle.inc"
#undef LIFECYCLE
};

// True if one of the words of a value is among those of the key.
bool is_among(std::string_view key, std::string_view value) {
  const KnownWords* row = std::ranges::find(kKnownWords, key, &KnownWords::key);
  const std::vector<std::string_view> known = words_in(row->values);
  const auto is_known = [&](std::string_view word) { return std::ranges::find(known, word) != known.end(); };
  return std::ranges::any_of(words_of(value), is_known);
}

bool is_known_building(std::string_view value) {
  return building_class_of(value) != BuildingClass::kPlain || is_among("building", value) ||
         std::ranges::any_of(words_of(value), [](const std::string& word) {
           return std::ranges::find(kStates, word) != std::end(kStates);
         });
}

template <typename Row, std::size_t n, typename Column>
std::optional<Column> column_of(std::string_view value, const Row (&rows)[n], Column Row::*column) {
  return first_known(value, [&](std::string_view word) {
    const Row* row = row_with(rows, word);
    return row != nullptr ? std::optional(row->*column) : std::nullopt;
  });
}

struct WordKey {
  std::string_view key;
  bool (*is_known)(std::string_view value);
};
constexpr WordKey kWordKeys[] = {
    {"barrier", [](std::string_view value) { return is_among("barrier", value); }},
    {"building", is_known_building},
    {"building:material", [](std::string_view value) { return wall_material_of(value).has_value(); }},
    {"fence_type", [](std::string_view value) { return is_among("fence_type", value); }},
    {"material", [](std::string_view value) { return thing_material_of(value).has_value(); }},
    {"roof:material", [](std::string_view value) { return roof_material_of(value).has_value(); }},
    {"surface", [](std::string_view value) { return is_paved_surface(value).has_value(); }},
    {"wall", [](std::string_view value) { return is_among("wall", value); }}};

/// Answers whether tags have unknown words. Each value is looked up once, by its number among the strings of the map.
class WordTests {
 public:
  explicit WordTests(const source::OsmData& osm) : osm_(osm) {
    for (const WordKey& row : kWordKeys) {
      const auto found = std::ranges::lower_bound(osm.strings, row.key);
      const bool is_there = found != osm.strings.end() && *found == row.key;
      if (is_there) keys_.push_back({static_cast<std::uint32_t>(found - osm.strings.begin()), row.is_known, {}});
    }
  }

  bool is_unknown(const source::Tag& tag) {
    const auto key = std::ranges::find(keys_, tag.key, &Key::number);
    if (key == keys_.end()) return false;
    const auto [found, is_new] = key->is_unknown.try_emplace(tag.value, false);
    if (is_new) found->second = is_unknown_value(*key, osm_.strings[tag.value]);
    return found->second;
  }

 private:
  struct Key {
    std::uint32_t number;
    bool (*is_known)(std::string_view value);
    std::unordered_map<std::uint32_t, bool> is_unknown;
  };

  static bool is_unknown_value(const Key& key, std::string_view value) {
    const std::vector<std::string> words = words_of(value);
    return !words.empty() && !key.is_known(value) && std::ranges::none_of(words, is_indefinite);
  }

  const source::OsmData& osm_;
  std::vector<Key> keys_;
};

}  // namespace

std::optional<Material> wall_material_of(std::string_view value) {
  return column_of(value, kWalls, &MaterialWord::material);
}

std::optional<Material> roof_material_of(std::string_view value) {
  return column_of(value, kRoofs, &MaterialWord::material);
}

std::optional<bool> is_paved_surface(std::string_view value) {
  return column_of(value, kSurfaces, &SurfaceWord::is_paved);
}

std::optional<std::string_view> thing_material_of(std::string_view value) {
  return column_of(value, kThingMaterials, &ThingWord::word);
}

namespace {

// The elements that are reported to be of an unknown kind, with the tag that says so. Sorted.
std::vector<std::pair<OsmId, std::string>> unknown_kinds(const Report& report) {
  std::vector<std::pair<OsmId, std::string>> kinds;
  for (const Diagnosis& diagnosis : report.diagnoses())
    if (diagnosis.code == Code::kUnknownKind) kinds.emplace_back(diagnosis.object, diagnosis.tag);
  std::ranges::sort(kinds);
  return kinds;
}

}  // namespace

void diagnose_unknown_words(const ReadContext& context) {
  WordTests words(context.osm);
  const std::vector<std::pair<OsmId, std::string>> said = unknown_kinds(context.report);
  const auto visit = [&](OsmId id, source::Range tags) {
    for (const source::Tag& tag : context.osm.tags_of(tags)) {
      if (!words.is_unknown(tag) || !box_of_element(context.osm, context.plane, id).touches(context.extent)) continue;
      const std::string &key = context.osm.strings[tag.key], &value = context.osm.strings[tag.value];
      if (std::ranges::binary_search(said, std::pair(id, tag_text(key, value)))) continue;
      context.report.add_tag(Code::kBadTagValue, id, key, value);
    }
  };
  for (const source::Node& node : context.osm.nodes) visit({OsmType::kNode, node.id}, node.tags);
  for (const source::Way& way : context.osm.ways) visit({OsmType::kWay, way.id}, way.tags);
  for (const source::Relation& relation : context.osm.relations)
    visit({OsmType::kRelation, relation.id}, relation.tags);
}

}  // namespace citykiln::map
