#include "compiler/plants/prototypes/grown_plant_cache.h"

#include <algorithm>
#include <mutex>

#include "compiler/materials/texture.h"
#include "compiler/plants/prototypes/sprays.h"
#include "lsystems/plant_file.h"

namespace citykiln::plants {
namespace {

// Species have numbers below this one.
constexpr std::size_t kSpeciesNumbers = kFirstUserSpecies + kMostUserSpecies;

double height_of(const GrownPlant& grown) {
  double highest_m = 0;
  for (const lsystems::Segment& segment : grown.skeleton.segments)
    highest_m = std::max({highest_m, segment.start.at.z, segment.end().at.z});
  for (const Card& card : grown.foliage.cards)
    if (card.outline == kNoOutline)
      for (const Vec3 corner : corners_of(card)) highest_m = std::max(highest_m, corner.z);
  for (const std::vector<Vec3>& outline : grown.foliage.outlines)
    for (const Vec3 corner : outline) highest_m = std::max(highest_m, corner.z);
  return highest_m;
}

const SpeciesText* find_text(std::span<const SpeciesText> texts, std::string_view name) {
  const auto found = std::ranges::find(texts, name, species_of);
  return found == texts.end() ? nullptr : &*found;
}

void drop_fruit(Foliage& foliage) {
  std::erase_if(foliage.cards, [&](const Card& card) { return is_fruit(foliage.sprays[card.spray]); });
}

}  // namespace

materials::Material bark_named(std::string_view name) {
  const auto named = materials::material_named(std::string(name) + "_bark");
  return named && materials::is_bark(*named) ? *named : materials::Material::kBark;
}

std::string file_of(const SpeciesText& text) {
  return text.name.find('.') == std::string::npos ? text.name + ".lsys" : text.name;
}

GrownPlant grow(const SpeciesText& text, const SpeciesValues& species, std::uint8_t variant, Month month) {
  const Result<lsystems::PlantFile> file = lsystems::read_plant_file(text.text, file_of(text));
  return file ? grow(*file, species, variant, month) : GrownPlant{};
}

namespace {

// Cards stand for the leaves. Grown plants are kept for a whole run, so vectors get their least size.
void keep_stems_and_cards(GrownPlant& grown) {
  lsystems::Skeleton stems;
  stems.segments = std::move(grown.skeleton.segments), stems.warnings = std::move(grown.skeleton.warnings);
  stems.segments.shrink_to_fit(), grown.foliage.cards.shrink_to_fit();
  grown.skeleton = std::move(stems);
}

}  // namespace

GrownPlant grow(const lsystems::PlantFile& file, const SpeciesValues& species, std::uint8_t variant, Month month) {
  GrownPlant grown{lsystems::grow_plant(file, variant).skeleton,
                   {},
                   0,
                   appearance_of(species, variant, month),
                   bark_named(file.system.bark)};
  grown.foliage = foliage_of(file.system, grown.skeleton, grown.appearance.leaf);
  if (grown.appearance.leaf_share < 1) drop_fruit(grown.foliage);
  grown.height_m = height_of(grown);
  keep_stems_and_cards(grown);
  return grown;
}

struct GrownPlantCache::Slot {
  std::once_flag once;
  GrownPlant grown;
};

GrownPlantCache::GrownPlantCache(std::span<const SpeciesText> texts, Month month)
    : table_(texts),
      texts_(kSpeciesNumbers),
      month_(month),
      slots_(std::make_unique<Slot[]>(kSpeciesNumbers * kVariants)) {
  for (const Species species : table_.all()) {
    const std::string_view name = table_[species].file;
    const SpeciesText* text = find_text(texts, name);
    if (text == nullptr) text = find_text(shipped_species(), name);
    if (text != nullptr) texts_[static_cast<std::size_t>(species)] = *text;
  }
}

GrownPlantCache::~GrownPlantCache() = default;

GrownPlant GrownPlantCache::grown_anew(Prototype prototype) const {
  return grow(texts_[static_cast<std::size_t>(prototype.species)], table_[prototype.species], prototype.variant,
              month_);
}

const GrownPlant& GrownPlantCache::grown(Prototype prototype) const {
  const auto species = static_cast<std::size_t>(prototype.species);
  assert(species < kSpeciesNumbers && prototype.variant < kVariants);
  Slot& slot = slots_[species * kVariants + prototype.variant];
  std::call_once(slot.once, [&] { slot.grown = grown_anew(prototype); });
  return slot.grown;
}

std::shared_ptr<const GrownPlant> GrownPlantCache::grown_or_regrown(Prototype prototype) const {
  const auto find = [&]() -> std::shared_ptr<const GrownPlant> {
    const auto found = std::ranges::find(recent_, prototype, &Recent::prototype);
    if (found == recent_.end()) return nullptr;
    std::rotate(recent_.begin(), found, std::next(found));
    return recent_.front().grown;
  };
  {
    const std::lock_guard lock(recent_mutex_);
    if (auto grown = find()) return grown;
  }
  // two threads may grow the same plant, which is the same both times
  auto grown = std::make_shared<const GrownPlant>(grown_anew(prototype));
  const std::lock_guard lock(recent_mutex_);
  if (auto other = find()) return other;
  recent_.push_front({prototype, grown});
  if (recent_.size() > kRecent) recent_.pop_back();
  return grown;
}

}  // namespace citykiln::plants
