// Values of USD attributes and metadata. Arrays are views, which must stay valid until the writer has written them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// USD's token: an identifier such as "vertex". USD distinguishes it from free text.
struct UsdToken {
  std::string text;
};
struct UsdTokens {
  std::span<const std::string> texts;
};
/// The path of a file, relative to the layer: "./0_0_L1.usdc".
struct UsdAsset {
  std::string path;
};
/// A quaternion in half precision: the bits of x, y, z, w.
using UsdQuath = std::array<std::uint16_t, 4>;

/// A scalar, an array, or nothing (std::monostate) for an attribute that is only declared.
using UsdValue =
    std::variant<std::monostate, bool, std::int32_t, std::int64_t, float, double, std::string, UsdToken, UsdAsset,
                 bake::Float2, bake::Float3, bake::Float4, Vec3, std::span<const std::int32_t>,
                 std::span<const std::int64_t>, std::span<const float>, std::span<const bake::Float2>,
                 std::span<const bake::Float3>, std::span<const UsdQuath>, std::span<const std::string>, UsdTokens>;

/// Named values, in the order in which they are written. Dictionaries are not nested.
using UsdDictionary = std::vector<std::pair<std::string, UsdValue>>;

/// Returns the bits of the nearest half-precision number, ties to even; infinity for magnitudes that round beyond
/// 65504. Integer arithmetic only.
std::uint16_t half_bits(float value);
/// Returns the number that half-precision bits represent.
float half_value(std::uint16_t bits);

/// Returns the name of a value's type in the text form, such as "float3". Entries of dictionaries state their types.
std::string_view usd_type_of(const UsdValue& value);

}  // namespace citykiln::exporters
