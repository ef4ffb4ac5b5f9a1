// PNG: the texels of a sheet, as files hold them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/sheet.h"

namespace citykiln::exporters {

/// Row by row, 8 bit sRGB; with a palette where 256 colours do. Same texels, same bytes.
/// @param sheet  With texels, no more than a sheet may have.
std::vector<std::byte> encode_png(const materials::Sheet& sheet);

/// The same with an opacity for each texel, which keeps its colour where it is 0.
std::vector<std::byte> encode_png(const materials::Sheet& sheet, std::span<const std::uint8_t> opacity);

/// decode(encode(sheet)) == sheet, but for texel_m, which is 0. Takes any PNG: what shines through shows black.
/// Errors: what is no PNG, damaged, or has more texels than a sheet may; never a crash. Memory: at most kMostTexels,
/// and in proportion to the file.
Result<materials::Sheet> decode_png(std::span<const std::byte> bytes, const std::string& name);

/// The same with opacities; what has none is opaque.
struct CutPicture {
  materials::Sheet colour;
  std::vector<std::uint8_t> opacity;
};
Result<CutPicture> decode_cut_png(std::span<const std::byte> bytes, const std::string& name);

}  // namespace citykiln::exporters
