// Sheets: several small pictures in rows.
#pragma once

#include <string_view>

#include "compiler/bake/baked_tile.h"
#include "compiler/sky/recipe.h"
#include "preview/render.h"

namespace citykiln::commands {

/// The width of a letter with the space after it, and the height of letters, in pixels.
inline constexpr int kLetterWidth_px = 12, kTextHeight_px = 16;

/// A black picture.
preview::Image empty_sheet(int width, int height);

/// Copies a picture into a sheet, with its upper left corner at (x0, y0). It fits in.
void put_picture(const preview::Image& from, int x0, int y0, preview::Image& to);

/// Writes small letters, digits, dots and hyphens in white, 16 pixels high, with their upper left corner at (x0, y0);
/// other characters are blank.
/// Pixels outside the picture are left out.
void put_text(std::string_view text, int x0, int y0, preview::Image& to);

/// A sky on a midsummer morning, which lights plants and things from the east.
sky::Sky sheet_sky();

/// A square of ground about the origin.
bake::Primitive ground_square(materials::Material material, float half_m);

}  // namespace citykiln::commands
