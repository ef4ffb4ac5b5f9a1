// A string of modules under construction. Its memory is reused for the next string.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>

#include "lsystems/module_string.h"

namespace citykiln::lsystems {

/// A string that modules are appended to.
struct ModuleBuffer {
  ModuleString room;  ///< The allocated arrays, whose first `size` and `value_count` entries are the string.
  std::size_t size = 0, value_count = 0;
  std::size_t most = 0;  ///< The limit of symbols. The limit of values is four times as large.

  std::span<const Kind> kinds() const { return {room.kinds.data(), size}; }
  std::span<const double> values() const { return {room.values.data(), value_count}; }

  /// Allocates memory for more symbols and values. Returns false if their number would exceed the limit.
  bool make_room(std::size_t symbols, std::size_t values) {
    if (size + symbols <= room.kinds.size() && value_count + values <= room.values.size())
      return size + symbols <= most;
    return grow(symbols, values);
  }

  bool grow(std::size_t symbols, std::size_t values) {
    if (size + symbols > most || value_count + values > 4 * most) return false;
    const auto larger = [](std::size_t had, std::size_t needed, std::size_t limit) {
      return needed <= had ? had : std::min(limit, std::max(2 * needed, std::size_t{256}));
    };
    room.kinds.resize(larger(room.kinds.size(), size + symbols, std::max(most, size + symbols)));
    room.values.resize(larger(room.values.size(), value_count + values, std::max(4 * most, value_count + values)));
    return true;
  }

  /// Appends modules. make_room() must have succeeded for their number.
  void append(std::span<const Kind> kinds, std::span<const double> values) {
    if (!kinds.empty()) std::memcpy(room.kinds.data() + size, kinds.data(), kinds.size_bytes());
    if (!values.empty()) std::memcpy(room.values.data() + value_count, values.data(), values.size_bytes());
    size += kinds.size();
    value_count += values.size();
  }
};

}  // namespace citykiln::lsystems
