// Writes one layer of USD, prim by prim: as text (text_writer.h) or as a crate (crate_writer.h), with the same content.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exporters/usd/usd_value.h"

namespace citykiln::exporters {

/// A layer's own metadata. Its up axis is z and its unit the metre.
struct UsdLayerHead {
  std::string default_prim;
  UsdDictionary custom_data{};  ///< customLayerData.
};

/// A prim that is defined.
struct UsdPrim {
  std::string_view type;                        ///< "Mesh".
  std::string name;                             ///< An identifier (usd_names.h).
  std::vector<std::string_view> api_schemas{};  ///< Prepended.
  std::string_view kind{};                      ///< "component"; empty: none.
  UsdDictionary custom_data{};
};

struct UsdAttribute {
  std::string_view type;  ///< "point3f[]".
  std::string name;       ///< "primvars:st".
  UsdValue value{};
  std::string_view interpolation{};  ///< Of a primvar: "vertex"; empty: none.
  bool is_uniform = false;           ///< Does not vary with time.
  bool is_custom = false;            ///< In no schema.
  std::string connection{};          ///< The path of the attribute it is connected to; empty: none.
};

struct UsdRelationship {
  std::string name;
  std::vector<std::string> targets;  ///< Absolute paths of prims.
};

/// Takes prims in depth-first order; the attributes of a prim before its children.
class LayerWriter {
 public:
  virtual ~LayerWriter() = default;
  virtual void begin_prim(const UsdPrim& prim) = 0;
  virtual void write(const UsdAttribute& attribute) = 0;
  virtual void write(const UsdRelationship& relationship) = 0;
  virtual void end_prim() = 0;
  /// Returns the file. Call once, when every prim has ended.
  virtual std::vector<std::byte> finish() = 0;
};

}  // namespace citykiln::exporters
