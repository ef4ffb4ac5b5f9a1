// Elements of facades on an atlas: a window, door or shop front that a level shows as one rectangle
// (grammars/derivation/element.h) gets a picture of all its detail.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "compiler/buildings/facade_textures.h"
#include "compiler/impostor/picture.h"
#include "compiler/materials/material_mesh.h"
#include "grammars/derivation/derive.h"

namespace citykiln::buildings {

/// The side of a texel on the pictures of elements, metres: kElementStep_m is six texels. Frames are three texels wide.
inline constexpr double kElementTexel_m = grammars::kElementStep_m / 6;

/// The side of a texel on coarse pictures of elements, metres.
inline constexpr double kCoarseElementTexel_m = 4 * kElementTexel_m;

/// An element as seen straight on.
struct DrawnElement {
  /// Row 0 is the upper edge. Equal elements share one object. Null if all of it has one surface.
  impostor::SharedPicture picture;
  materials::SurfaceMaterial surface{};  ///< The surface if there is no picture.
};

/// Pictures of elements, each drawn once. Thread-safe. A picture is a function of the element and its colours alone, so
/// results do not depend on the order of calls. Memory: a few kB for each distinct element.
class ElementPictures {
 public:
  /// Returns an element as drawn, with texels of kElementTexel_m.
  /// @param surfaces  By index into Derivation::appearances.
  DrawnElement drawn(const grammars::Element& element, const std::vector<materials::SurfaceMaterial>& surfaces) const;

  /// Returns an element as drawn, with texels of kCoarseElementTexel_m.
  DrawnElement drawn_coarsely(const grammars::Element& element,
                              const std::vector<materials::SurfaceMaterial>& surfaces) const;

 private:
  using Key = std::vector<std::int32_t>;  // sizes, materials, tints and coordinates
  struct Slot {
    std::once_flag fine_once, coarse_once;
    DrawnElement fine, coarse;
  };
  Slot& slot_of(const grammars::Element& element, const std::vector<materials::SurfaceMaterial>& surfaces) const;

  mutable std::mutex mutex_;
  mutable std::map<Key, Slot> slots_;
};

/// An element where it stands on a building.
struct PlacedElement {
  grammars::Face rectangle;         ///< Plane metres.
  impostor::SharedPicture picture;  ///< From ElementPictures::drawn_coarsely(), not null.
};

/// The tolerance, metres, of the detailed model from which all levels take facade textures and rows of windows: the
/// model has the reveals and frames of windows and the bars of railings.
inline constexpr double kDetailedModel_m = 0.05;

/// A detailed model of a building, from which coarser levels take what they leave out.
struct DetailedFacades {
  impostor::Model walls;  ///< With holes in place of `elements`.
  /// Without holes: each element is a rectangle of its mean colour, or all its detail if some of it emits light.
  impostor::Model whole;
  std::vector<PlacedElement> elements;
};

/// The models of DetailedFacades that are made; others stay empty.
struct NeededModels {
  bool walls = false, whole = false;
};

/// Returns a derivation as a detailed model. O(n log n).
/// @param pictures  Not null if the derivation has elements.
DetailedFacades detailed_facades(const grammars::Derivation& derivation, const ElementPictures* pictures,
                                 NeededModels needed, OsmId feature);

/// Adds the rectangles of a derivation's elements: those with a picture as one TexturedFace for each picture, others to
/// meshes of their surface. O(terminals + faces of elements).
void add_elements(const grammars::Derivation& derivation, const ElementPictures& pictures, OsmId feature,
                  FacadeMeshes& faces);

}  // namespace citykiln::buildings
