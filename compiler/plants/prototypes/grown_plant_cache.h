// Where plants grow: each prototype once a run, when it is first asked for.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "compiler/plants/appearance.h"
#include "compiler/plants/prototypes/foliage.h"
#include "compiler/plants/species_texts.h"

namespace citykiln::plants {

/// A plant that has grown, in metres of its file.
struct GrownPlant {
  lsystems::Skeleton skeleton;
  Foliage foliage;
  double height_m = 0;  ///< Of its highest leaf or stem; 0: nothing grew.
  Appearance appearance{};
  materials::Material bark = materials::Material::kBark;  ///< What it is near by.
};

/// What the file calls "furrowed" is furrowed_bark; plain bark where there is no such material.
materials::Material bark_named(std::string_view name);

/// The dice are of species and variant alone: the same plants in all scenes. Seasons change looks alone: where leaves
/// have fallen there are twigs; but fruit is there only with all leaves.
GrownPlant grow(const SpeciesText& text, Prototype prototype, Month month = kMidsummer);

/// A shape that has grown once for all who ask, from any thread. Logically const: what is asked for is a function of
/// the texts alone.
class GrownPlantCache {
 public:
  /// @param texts  A species without a text grows from the one that is shipped.
  explicit GrownPlantCache(std::span<const SpeciesText> texts, Month month = kMidsummer);
  ~GrownPlantCache();
  GrownPlantCache(const GrownPlantCache&) = delete;
  GrownPlantCache& operator=(const GrownPlantCache&) = delete;

  /// Cost: some 10 ms when it is first asked for, and 2 MB from then on. A text that cannot be read grows nothing.
  const GrownPlant& grown(Prototype prototype) const;

 private:
  struct Slot;
  std::vector<SpeciesText> texts_;  // by species
  Month month_;
  std::unique_ptr<Slot[]> slots_;
};

}  // namespace citykiln::plants
