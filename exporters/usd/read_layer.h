// Reads layers of USD, as text or as crates, without composing them. For checks: other code than wrote them.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// A scalar or an array: numbers one after the other, (1, 2), (3, 4) as 1, 2, 3, 4, quaternions with the real part
/// first; or texts.
struct UsdReadValue {
  std::vector<double> numbers;
  std::vector<std::string> texts;
  bool operator==(const UsdReadValue&) const = default;
};
using UsdReadDictionary = std::map<std::string, UsdReadValue>;

struct UsdReadPrim {
  std::string path, type;
  UsdReadDictionary values{};                                 ///< Of attributes.
  std::map<std::string, std::string> interpolations{};        ///< Of attributes that state one.
  std::map<std::string, std::vector<std::string>> targets{};  ///< Of relationships, and connections of attributes.
  UsdReadDictionary custom_data{};
  std::vector<std::string> payloads{};                         ///< Paths of files.
  std::map<std::string, std::string> selections{};             ///< Variant sets and the variant that is shown.
  std::map<std::string, std::vector<UsdReadPrim>> variants{};  ///< By set; the path of each is its name.
  bool operator==(const UsdReadPrim&) const = default;
};

struct UsdReadLayer {
  std::string default_prim, up_axis;
  double meters_per_unit = 0;
  UsdReadDictionary custom_data{};
  std::vector<UsdReadPrim> prims{};  ///< Parents before their children, in the order of the file.
  bool operator==(const UsdReadLayer&) const = default;
};

/// Reads what citykiln writes: def prims, attributes without time samples, payloads, variants. Other metadata is
/// skipped. Errors: anything else, damage; never a crash, whatever the bytes (fuzzed). Memory: in proportion to what
/// the file holds, unpacked.
/// @param name  The file's name in error messages.
Result<UsdReadLayer> read_usd_layer(std::span<const std::byte> bytes, const std::string& name);

/// The two forms.
Result<UsdReadLayer> read_crate(std::span<const std::byte> bytes);
Result<UsdReadLayer> read_usd_text(std::string_view text);

/// The prim at a path; null where there is none. O(n).
const UsdReadPrim* prim_at(const UsdReadLayer& layer, const std::string& path);

}  // namespace citykiln::exporters
