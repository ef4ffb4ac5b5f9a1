// Reads USD layers, as text (.usda) or as crates (binary, .usdc), without composing them. The command `check` verifies
// outputs with these functions, which share no code with the writers.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// A scalar or an array, flattened: (1, 2), (3, 4) is 1, 2, 3, 4. Quaternions have the real part first. Texts are in
/// `texts`.
struct UsdReadValue {
  std::vector<double> numbers;
  std::vector<std::string> texts;
  bool operator==(const UsdReadValue&) const = default;
};
using UsdReadDictionary = std::map<std::string, UsdReadValue>;

/// A prim (an object of a layer) that was read.
struct UsdReadPrim {
  std::string path, type;
  UsdReadDictionary values{};                           ///< The values of attributes, by name.
  std::map<std::string, std::string> interpolations{};  ///< The interpolations of attributes that state one, by name.
  /// The targets of relationships and the connections of attributes, by name.
  std::map<std::string, std::vector<std::string>> targets{};
  UsdReadDictionary custom_data{};
  std::vector<std::string> payloads{};              ///< Paths of files.
  std::map<std::string, std::string> selections{};  ///< The chosen variant of each variant set.
  /// The variants of each set; `path` is the name of the variant.
  std::map<std::string, std::vector<UsdReadPrim>> variants{};
  bool operator==(const UsdReadPrim&) const = default;
};

/// A layer that was read.
struct UsdReadLayer {
  std::string default_prim, up_axis;
  double meters_per_unit = 0;
  UsdReadDictionary custom_data{};
  std::vector<UsdReadPrim> prims{};  ///< Parents before their children, in the order of the file.
  bool operator==(const UsdReadLayer&) const = default;
};

/// Reads the parts of USD that citykiln writes: def prims, attributes without time samples, payloads, variants. Skips
/// other metadata. Errors: other content, or damage. No bytes make the function crash (fuzzed). Memory: proportional to
/// the unpacked content.
/// @param name  The name of the file in error messages.
Result<UsdReadLayer> read_usd_layer(std::span<const std::byte> bytes, const std::string& name);

/// Reads a layer from a crate (binary). Errors as for read_usd_layer().
Result<UsdReadLayer> read_crate(std::span<const std::byte> bytes);
/// Reads a layer from text. Errors as for read_usd_layer(), with the line.
Result<UsdReadLayer> read_usd_text(std::string_view text);

/// Returns the prim at a path; null if there is none. O(n).
const UsdReadPrim* prim_at(const UsdReadLayer& layer, const std::string& path);

}  // namespace citykiln::exporters
