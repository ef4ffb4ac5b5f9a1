// A cache of grown plants. A prototype is one of the kVariants distinct plants of a species. It is grown by the
// L-system in the species' .lsys file, and its mesh is made from the result.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <mutex>
#include <span>

#include "compiler/plants/appearance.h"
#include "compiler/plants/prototypes/foliage.h"
#include "compiler/plants/species_table.h"
#include "compiler/plants/species_texts.h"

namespace citykiln::lsystems {
struct PlantFile;
}

namespace citykiln::plants {

/// A grown prototype: stems and leaves before they are meshed. Lengths are in the units of its .lsys file, which vary
/// from file to file; meshes are scaled to the height of each placed plant.
struct GrownPlant {
  lsystems::Skeleton skeleton;  ///< Stems alone; foliage has the leaves.
  Foliage foliage;
  double height_m = 0;  ///< Height of its highest leaf or stem, in the units of the .lsys file; 0: the plant is empty.
  Appearance appearance{};                                ///< Materials and tints in the month.
  materials::Material bark = materials::Material::kBark;  ///< Bark of levels that are fine enough for a bark texture.
};

/// Returns the bark material with a name of .lsys files: "furrowed" gives furrowed_bark. An unknown name gives kBark.
materials::Material bark_named(std::string_view name);

/// Grows a variant of a species. A text that is no valid file of a plant gives an empty plant. Random numbers depend
/// only on species and variant, so all scenes have the same plants. The month decides leaf share and colours. If some
/// leaves have fallen, or are not out yet, the plant has no fruit.
GrownPlant grow(const SpeciesText& text, const SpeciesValues& species, std::uint8_t variant, Month month = kMidsummer);
/// Grows a plant from its file.
GrownPlant grow(const lsystems::PlantFile& file, const SpeciesValues& species, std::uint8_t variant, Month month);

/// Returns the file's name with its extension.
std::string file_of(const SpeciesText& text);

/// Grows plants when they are first needed. Thread-safe. Its const functions change only the cache: a plant is a
/// function of texts, month and prototype.
class GrownPlantCache {
 public:
  /// @param texts  Files of species, and user-defined tables (species_table.h). A shipped species that is missing uses
  ///               the file that is compiled into the program.
  explicit GrownPlantCache(std::span<const SpeciesText> texts, Month month = kMidsummer);
  ~GrownPlantCache();
  GrownPlantCache(const GrownPlantCache&) = delete;
  GrownPlantCache& operator=(const GrownPlantCache&) = delete;

  /// The species of the texts, and the shipped ones.
  const SpeciesTable& table() const { return table_; }

  /// Returns a plant that stays valid as long as the cache. Cost: some 10 ms and 2 MB on first use.
  const GrownPlant& grown(Prototype prototype) const;

  /// Returns the same plant as grown(), for callers with little memory. The cache keeps only the last kRecent plants
  /// that this function returned, so a plant may be grown several times.
  std::shared_ptr<const GrownPlant> grown_or_regrown(Prototype prototype) const;
  static constexpr std::size_t kRecent = 16;

 private:
  struct Slot;
  struct Recent {
    Prototype prototype;
    std::shared_ptr<const GrownPlant> grown;
  };
  GrownPlant grown_anew(Prototype prototype) const;

  SpeciesTable table_;
  std::vector<SpeciesText> texts_;  // by species
  Month month_;
  std::unique_ptr<Slot[]> slots_;
  mutable std::mutex recent_mutex_;
  mutable std::deque<Recent> recent_;  // the last one first
};

}  // namespace citykiln::plants
