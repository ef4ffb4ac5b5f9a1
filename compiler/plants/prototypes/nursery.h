// Where plants grow: each prototype once a run, when it is first asked for.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "compiler/plants/looks.h"
#include "compiler/plants/prototypes/foliage.h"
#include "compiler/plants/species_texts.h"

namespace citykiln::plants {

/// A plant that has grown, in metres of its file.
struct Grown {
  lsystems::Skeleton skeleton;
  Foliage foliage;
  double height_m = 0;  ///< Of its highest leaf or stem; 0: nothing grew.
  Look look{};
  materials::Material bark = materials::Material::kBark;  ///< What it is near by.
};

/// What the file calls "furrowed" is furrowed_bark; plain bark where there is no such material.
materials::Material bark_named(std::string_view name);

/// The dice are of species and variant alone: the same plants in all scenes. Seasons change looks alone: where leaves
/// have fallen there are twigs; but fruit is there only with all leaves.
Grown grow(const SpeciesText& text, Prototype prototype, Month month = kMidsummer);

/// A shape that has grown once for all who ask, from any thread. Logically const: what is asked for is a function of
/// the texts alone.
class Nursery {
 public:
  /// @param texts  A species without a text grows from the one that is shipped.
  explicit Nursery(std::span<const SpeciesText> texts, Month month = kMidsummer);
  ~Nursery();
  Nursery(const Nursery&) = delete;
  Nursery& operator=(const Nursery&) = delete;

  /// Cost: some 10 ms when it is first asked for, and 2 MB from then on. A text that cannot be read grows nothing.
  const Grown& grown(Prototype prototype) const;

 private:
  struct Slot;
  std::vector<SpeciesText> texts_;  // by species
  Month month_;
  std::unique_ptr<Slot[]> slots_;
};

}  // namespace citykiln::plants
