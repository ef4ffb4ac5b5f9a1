// A cache of grown plants: each prototype is derived once per run, on first use.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <mutex>
#include <span>

#include "compiler/plants/appearance.h"
#include "compiler/plants/prototypes/foliage.h"
#include "compiler/plants/species_texts.h"

namespace citykiln::plants {

/// A derived plant, in the units of its .lsys file.
struct GrownPlant {
  lsystems::Skeleton skeleton;
  Foliage foliage;
  double height_m = 0;  ///< The height of its highest leaf or stem; 0: empty.
  Appearance appearance{};
  materials::Material bark = materials::Material::kBark;  ///< The bark material of fine levels.
};

/// Returns the material of a .lsys file's bark name: "furrowed" is furrowed_bark; kBark if there is none.
materials::Material bark_named(std::string_view name);

/// Derives a prototype; an unreadable text gives an empty plant. Random numbers depend only on species and variant, so
/// all scenes have the same plants. The month sets the appearance. Fruit is removed unless all leaves are present.
GrownPlant grow(const SpeciesText& text, Prototype prototype, Month month = kMidsummer);

/// Holds all plants that grown() has returned. Thread-safe. Logically const: a plant is a function of texts, month and
/// prototype.
class GrownPlantCache {
 public:
  /// @param texts  The shipped text is used for a species that has none here.
  explicit GrownPlantCache(std::span<const SpeciesText> texts, Month month = kMidsummer);
  ~GrownPlantCache();
  GrownPlantCache(const GrownPlantCache&) = delete;
  GrownPlantCache& operator=(const GrownPlantCache&) = delete;

  /// Returns a plant that is valid as long as the cache. Cost: some 10 ms on first use, 2 MB.
  const GrownPlant& grown(Prototype prototype) const;

  /// Returns the plant for callers with little memory: the cache keeps only the last kRecent plants requested here and
  /// grows others again.
  std::shared_ptr<const GrownPlant> recent(Prototype prototype) const;
  static constexpr std::size_t kRecent = 16;

 private:
  struct Slot;
  struct Recent {
    Prototype prototype;
    std::shared_ptr<const GrownPlant> grown;
  };
  std::vector<SpeciesText> texts_;  // by species
  Month month_;
  std::unique_ptr<Slot[]> slots_;
  mutable std::mutex recent_mutex_;
  mutable std::deque<Recent> recent_;  // the last one first
};

}  // namespace citykiln::plants
