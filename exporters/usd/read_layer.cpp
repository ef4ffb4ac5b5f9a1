#include "exporters/usd/read_layer.h"

#include <algorithm>

#include "exporters/usd/crate_types.h"

namespace citykiln::exporters {

Result<UsdReadLayer> read_usd_layer(std::span<const std::byte> bytes, const std::string& name) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  Result<UsdReadLayer> layer = text.starts_with(kCrateMagic) ? read_crate(bytes) : read_usd_text(text);
  if (!layer) return Error{name, layer.error().message};
  return layer;
}

const UsdReadPrim* prim_at(const UsdReadLayer& layer, const std::string& path) {
  const auto found = std::ranges::find(layer.prims, path, &UsdReadPrim::path);
  return found == layer.prims.end() ? nullptr : &*found;
}

}  // namespace citykiln::exporters
