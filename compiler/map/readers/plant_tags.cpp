#include "compiler/map/readers/plant_tags.h"

#include <algorithm>

#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

// Most specific first; names in other languages apply where the Latin one gives nothing.
constexpr std::string_view kTaxonKeys[] = {"genus",      "species",  "taxon",      "genus:de", "species:de",
                                           "taxon:de",   "genus:en", "species:en", "taxon:en", "genus:fr",
                                           "species:fr", "genus:es", "species:es", "genus:ca", "species:ca",
                                           "trees",      "crop",     "produce"};

constexpr double kTallestPlant_m = 130, kWidest_m = 60, kThickest_m = 40;

PlantKind tagged_kind(const ReadContext& context, source::Range tags) {
  if (context.user_plants != nullptr)
    for (const std::string_view key : kTaxonKeys)
      if (const std::string_view text = context.tag(tags, key); !text.empty())
        if (const PlantKind kind = user_kind_named(text, context.user_plants->words); kind != PlantKind::kUnknown)
          return kind;
  for (const std::string_view key : kTaxonKeys)
    if (const std::string_view text = context.tag(tags, key); !text.empty())
      if (const PlantKind kind = kind_named(text); kind != PlantKind::kUnknown) return kind;
  return PlantKind::kUnknown;
}

LeafType leaves_named(std::string_view word) {
  if (word == "broadleaved" || word == "deciduous" || word == "broad_leaved") return LeafType::kBroad;
  if (word == "needleleaved" || word == "coniferous" || word == "conifer" || word == "evergreen")
    return LeafType::kNeedle;
  if (word == "palm") return LeafType::kPalm;
  return word == "mixed" ? LeafType::kMixed : LeafType::kUnknown;
}

LeafType tagged_leaves(const ReadContext& context, source::Range tags) {
  for (const std::string_view key : {"leaf_type", "wood", "type", "leaf_cycle"})
    if (const LeafType leaves = leaves_named(context.tag(tags, key)); leaves != LeafType::kUnknown) return leaves;
  return LeafType::kUnknown;
}

// In metres; numbers above half the maximum are centimetres.
double girth_m_of(const ReadContext& context, OsmId id, source::Range tags) {
  const double girth_m = tagged_length_m(context, id, tags, "circumference", 0.05, 1000).value_or(0);
  return girth_m > kThickest_m / 2 ? girth_m / 100 : girth_m;
}

}  // namespace

PlantTags read_plant_tags(const ReadContext& context, OsmId id, source::Range tags) {
  PlantTags plant_tags{tagged_kind(context, tags), tagged_leaves(context, tags)};
  plant_tags.crown_m = tagged_length_m(context, id, tags, "diameter_crown", 0.2, kWidest_m).value_or(0);
  plant_tags.girth_m = girth_m_of(context, id, tags);
  plant_tags.year = year_of(context.tag(tags, "start_date")).value_or(0);
  plant_tags.spawner = tagged_spawner(context, tags);
  return plant_tags;
}

std::uint8_t tagged_spawner(const ReadContext& context, source::Range tags) {
  if (context.user_plants == nullptr) return 0;
  const std::vector<SpawnerRow>& rows = context.user_plants->spawners;
  const auto value_of = [&](std::string_view key) { return context.tag(tags, key); };
  const auto found =
      std::ranges::find_if(rows, [&](const SpawnerRow& row) { return fitting_value(row.tags, value_of).has_value(); });
  return found == rows.end() ? std::uint8_t{0} : static_cast<std::uint8_t>(found - rows.begin() + 1);
}

double tagged_plant_height_m(const ReadContext& context, OsmId id, source::Range tags) {
  const auto height_m = tagged_length_m(context, id, tags, "height", 0.1, kTallestPlant_m);
  return height_m ? *height_m : tagged_length_m(context, id, tags, "est_height", 0.1, kTallestPlant_m).value_or(0);
}

TreeSides tree_sides_of(std::string_view tree_lined) {
  if (tree_lined == "left") return TreeSides::kLeft;
  if (tree_lined == "right") return TreeSides::kRight;
  // "separate" is not here: those trees are mapped
  const bool is_both = tree_lined == "both" || tree_lined == "yes" || tree_lined == "avenue";
  return is_both ? TreeSides::kBoth : TreeSides::kNone;
}

}  // namespace citykiln::map
