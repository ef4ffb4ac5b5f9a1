// Parses values of settings and options. Errors state the expected value and the text, without a place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"

namespace citykiln {

/// The error of a text that is not of the expected form.
Error expected(std::string_view what, std::string_view found);

/// Parses a tolerance from 0.001 to kCoarsest_m: "0.5".
Result<double> parse_tolerance(std::string_view text);
/// Parses increasing tolerances: "0.1,0.5,2.5".
Result<std::vector<double>> parse_ladder(std::string_view text);
/// Parses the key of a tile, such as "3_-2".
Result<scene::TileKey> parse_tile(std::string_view text);
/// Parses "3_-2,0_0" and inserts the tiles into a sorted vector without duplicates.
Result<Done> add_tiles(std::string_view text, std::vector<scene::TileKey>& tiles);
/// Parses a finite number.
Result<double> parse_number(std::string_view text);
/// Parses exactly `count` numbers separated by commas.
Result<std::vector<double>> parse_numbers(std::string_view text, std::size_t count);
/// Parses an integer from `least` to 2^31 - 1.
Result<std::int64_t> parse_whole(std::string_view text, std::int64_t least);
/// Parses "true" or "false".
Result<bool> parse_switch(std::string_view text);

}  // namespace citykiln
