#include "compiler/plants/prototypes/grown_plant_cache.h"

#include <algorithm>
#include <mutex>

#include "compiler/materials/texture.h"
#include "compiler/plants/prototypes/sprays.h"
#include "lsystems/read_lsystem.h"
#include "lsystems/turtle.h"

namespace citykiln::plants {
namespace {

constexpr std::size_t kSpeciesCount = static_cast<std::size_t>(Species::kCount);

double height_of(const GrownPlant& grown) {
  double highest_m = 0;
  for (const lsystems::Segment& segment : grown.skeleton.segments)
    highest_m = std::max({highest_m, segment.start.at.z, segment.end().at.z});
  for (const Card& card : grown.foliage.cards)
    for (const Vec3 corner : corners_of(card)) highest_m = std::max(highest_m, corner.z);
  return highest_m;
}

const SpeciesText* find_text(std::span<const SpeciesText> texts, std::string_view name) {
  const auto found = std::ranges::find(texts, name, &SpeciesText::name);
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

GrownPlant grow(const SpeciesText& text, Prototype prototype, Month month) {
  const Result<lsystems::LSystem> system = lsystems::read_lsystem(text.text, text.name + ".lsys");
  if (!system) return {};
  lsystems::DeriveOptions options;
  options.seed = prototype.variant;
  GrownPlant grown{
      lsystems::grow(*system, options).skeleton, {}, 0, appearance_of(prototype, month), bark_named(system->bark)};
  grown.foliage = foliage_of(*system, grown.skeleton, grown.appearance.leaf);
  if (grown.appearance.leaf_share < 1) drop_fruit(grown.foliage);
  grown.height_m = height_of(grown);
  return grown;
}

struct GrownPlantCache::Slot {
  std::once_flag once;
  GrownPlant grown;
};

GrownPlantCache::GrownPlantCache(std::span<const SpeciesText> texts, Month month)
    : month_(month), slots_(std::make_unique<Slot[]>(kSpeciesCount * kVariants)) {
  for (std::size_t s = 0; s < kSpeciesCount; ++s) {
    const std::string_view name = values_of(static_cast<Species>(s)).file;
    const SpeciesText* text = find_text(texts, name);
    if (text == nullptr) text = find_text(shipped_species(), name);
    texts_.push_back(text == nullptr ? SpeciesText{} : *text);
  }
}

GrownPlantCache::~GrownPlantCache() = default;

const GrownPlant& GrownPlantCache::grown(Prototype prototype) const {
  assert(prototype.species < Species::kCount && prototype.variant < kVariants);
  const auto species = static_cast<std::size_t>(prototype.species);
  Slot& slot = slots_[species * kVariants + prototype.variant];
  std::call_once(slot.once, [&] { slot.grown = grow(texts_[species], prototype, month_); });
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
  auto grown =
      std::make_shared<const GrownPlant>(grow(texts_[static_cast<std::size_t>(prototype.species)], prototype, month_));
  const std::lock_guard lock(recent_mutex_);
  if (auto other = find()) return other;
  recent_.push_front({prototype, grown});
  if (recent_.size() > kRecent) recent_.pop_back();
  return grown;
}

}  // namespace citykiln::plants
