#include "compiler/map/surface_class.h"

#include <cstddef>

namespace citykiln::map {
namespace {

using materials::Material;

constexpr SurfaceValues kTable[] = {
#define SURFACE(name, group, priority, material) \
  {std::string_view(#name).substr(1), SurfaceGroup::group, priority, Material::material},
#include "compiler/map/surface_classes.inc"
#undef SURFACE
};

}  // namespace

const SurfaceValues& values_of(SurfaceClass surface) { return kTable[static_cast<std::size_t>(surface)]; }

}  // namespace citykiln::map
