// Writes layers as text (.usda).
#pragma once

#include <string>

#include "exporters/usd/layer_writer.h"

namespace citykiln::exporters {

/// A writer of a text layer. It writes numbers with the fewest digits that give the same bits when read. Deterministic.
/// Source: OpenUSD, "USD ASCII format".
class TextWriter final : public LayerWriter {
 public:
  explicit TextWriter(const UsdLayerHead& head);
  void begin_prim(const UsdPrim& prim) override;
  void write(const UsdAttribute& attribute) override;
  void write(const UsdRelationship& relationship) override;
  void end_prim() override;
  std::vector<std::byte> finish() override;

  /// Appends lines, indented like the attributes of the open prim and unchanged otherwise. Used for variants and
  /// payloads, which LayerWriter lacks.
  ///
  /// @param lines  Without a line feed at the end.
  void write_lines(std::string_view lines);
  /// Opens a block whose brace write_lines() has written; end_prim() closes it.
  void indent() { ++depth_; }

 private:
  void new_line();

  std::string text_;
  std::size_t depth_ = 0;
};

/// Returns a text in quotes, with escapes for quotes, backslashes and control characters.
std::string quoted(std::string_view text);

/// Returns a value as text: "(1,2.5,0)", "[0,1,2]".
std::string text_of(const UsdValue& value);

}  // namespace citykiln::exporters
