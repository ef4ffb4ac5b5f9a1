// Writes binary layers, called crates (.usdc, crate_types.h). They are half the size of text and several times faster
// to read.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "exporters/usd/crate_types.h"
#include "exporters/usd/layer_writer.h"

namespace citykiln::exporters {

/// A writer of a crate. The order of calls is that of LayerWriter: prims depth first, the attributes and relationships
/// of a prim before its children, finish() once at the end. Each value is added to the file when write() is called; the
/// tables that refer to values are added by finish(). Deterministic. Cannot fail.
class CrateWriter final : public LayerWriter {
 public:
  explicit CrateWriter(const UsdLayerHead& head);
  void begin_prim(const UsdPrim& prim) override;
  void write(const UsdAttribute& attribute) override;
  void write(const UsdRelationship& relationship) override;
  void end_prim() override;
  std::vector<std::byte> finish() override;

 private:
  using Fields = std::vector<std::int32_t>;  ///< Indices into field_list_.

  struct Node {
    std::int32_t token;  ///< Index into token_list_; its negative for properties.
    std::int32_t depth;  ///< Depth in the tree of paths.
  };
  struct Spec {
    std::int32_t path, fields;
    CrateSpec type;
  };
  struct OpenPrim {
    std::int32_t path;
    Fields fields;
    std::vector<std::uint32_t> properties, children;  ///< Tokens.
  };

  std::uint32_t token(std::string_view text);
  std::int32_t field(std::string_view name, std::uint64_t value);
  std::int32_t add_path(std::int32_t token, std::string path);
  void add_spec(std::int32_t path, CrateSpec type, const Fields& fields);
  void begin(std::string_view name);
  void end(CrateSpec type);

  std::uint64_t value(const UsdValue& value);
  std::uint64_t offset(CrateType type, std::uint64_t flags = 0);
  std::uint64_t tokens(const std::vector<std::uint32_t>& numbers);
  std::uint64_t dictionary(const UsdDictionary& entries);
  std::uint64_t paths(const std::vector<std::string>& targets);
  std::uint64_t integers(std::span<const std::int32_t> numbers);
  std::uint64_t texts(CrateType type, std::span<const std::string> texts);
  template <typename T>
  std::uint64_t scalar(CrateType type, const T& value);
  template <typename T>
  std::uint64_t array(CrateType type, std::span<const T> values);

  void put(std::span<const std::byte> bytes) { out_.insert(out_.end(), bytes.begin(), bytes.end()); }
  template <typename T>
  void put_raw(const T& value);
  void put_packed(std::span<const std::int32_t> numbers);
  void put_tokens();
  void put_strings();
  void put_field_sets();
  void set_path_numbers();
  void put_bootstrap(std::uint64_t contents);
  void put_fields();
  void put_paths();
  void put_specs();

  std::vector<std::byte> out_;
  std::vector<std::string> token_list_;
  std::map<std::string, std::uint32_t, std::less<>> token_numbers_;
  std::vector<std::pair<std::uint32_t, std::uint64_t>> field_list_;
  std::map<std::pair<std::uint32_t, std::uint64_t>, std::int32_t> field_numbers_;
  std::vector<std::int32_t> field_sets_;
  std::map<Fields, std::int32_t> field_set_places_;
  std::vector<Node> nodes_;
  std::map<std::string, std::int32_t> path_numbers_;
  /// Offsets in out_ where finish() writes the number of a path, which may not exist yet.
  std::vector<std::pair<std::size_t, std::string>> path_uses_;
  std::vector<Spec> specs_;
  std::vector<OpenPrim> open_;
  std::vector<std::string> open_paths_;
};

}  // namespace citykiln::exporters
