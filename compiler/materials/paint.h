// Paint on a sheet.
#pragma once

#include "compiler/materials/coverage.h"
#include "compiler/materials/sheet.h"

namespace citykiln::materials {

/// A sheet of one colour.
Sheet blank_sheet(double texel_m, std::uint32_t columns, std::uint32_t rows, Sheet::Texel colour);

/// Paints a polygon over what is there.
///
/// @param columns  Paint stops at their sides, so that strips do not bleed into each other; beyond the sheet it is cut.
/// @param ring_m   Sheet metres, simple, either way round. Along v the sheet wraps.
///
/// Guarantees: a texel becomes the mix, in linear light, of what it was and the colour, by the share of it that the
/// ring covers (coverage.h): a line thinner than a texel becomes faint, not lost. Later paint lies over earlier. Only
/// + − × ÷: the same bytes on every CPU. Bad input as in coverage.h. O(texels of the ring's box).
void paint(Sheet& sheet, ColumnRange columns, const Ring& ring_m, Sheet::Texel colour);

}  // namespace citykiln::materials
