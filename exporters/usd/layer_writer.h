// The interface that writes a USD layer prim by prim. text_writer.h and crate_writer.h implement it; the content of
// both is equal.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exporters/usd/usd_value.h"

namespace citykiln::exporters {

/// The metadata of a layer. Its up axis is z and its unit the metre.
struct UsdLayerHead {
  std::string default_prim;
  UsdDictionary custom_data{};  ///< USD's customLayerData.
};

/// A prim, written with the specifier "def".
struct UsdPrim {
  std::string_view type;                        ///< "Mesh".
  std::string name;                             ///< An identifier (usd_names.h).
  std::vector<std::string_view> api_schemas{};  ///< Prepended to the list apiSchemas.
  std::string_view kind{};                      ///< "component"; empty: none.
  UsdDictionary custom_data{};
};

struct UsdAttribute {
  std::string_view type;  ///< "point3f[]".
  std::string name;       ///< "primvars:st".
  UsdValue value{};
  std::string_view interpolation{};  ///< For a primvar, such as "vertex"; empty: none.
  bool is_uniform = false;           ///< Does not vary with time.
  bool is_custom = false;            ///< Belongs to no schema.
  std::string connection{};          ///< The path of the attribute to which it is connected; empty: none.
};

struct UsdRelationship {
  std::string name;
  std::vector<std::string> targets;  ///< Absolute paths of prims.
};

/// Receives prims in depth-first order, and the attributes of a prim before its children.
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
