#include <bit>
#include <cstring>
#include <stdexcept>

#include "exporters/usd/crate_coding.h"
#include "exporters/usd/crate_types.h"
#include "exporters/usd/read_layer.h"
#include "exporters/usd/usd_value.h"

namespace citykiln::exporters {
namespace {

/// A fault of a crate, as the text that was expected instead.
struct CrateError {
  std::string expected;
};

using ByteSpan = std::span<const std::byte>;
using Numbers = std::vector<std::int32_t>;

// Reads forwards; throws CrateError at the end of the file.
class Cursor {
 public:
  Cursor(ByteSpan file, std::uint64_t at) : file_(file), at_(at) {
    if (at > file.size()) throw CrateError{"offsets inside the file"};
  }

  ByteSpan take(std::uint64_t size) {
    if (size > file_.size() - at_) throw CrateError{"values inside the file"};
    const ByteSpan bytes = file_.subspan(at_, size);
    at_ += size;
    return bytes;
  }

  template <typename T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }

  // Reads a count of items that take at least this many bytes each.
  std::uint64_t count(std::uint64_t least_bytes) {
    const auto count = number<std::uint64_t>();
    if (count > (file_.size() - at_) / least_bytes) throw CrateError{"counts that the file has room for"};
    return count;
  }

 private:
  ByteSpan file_;
  std::uint64_t at_;
};

template <typename T>
T must(Result<T> result) {
  if (!result) throw CrateError{result.error().message};
  return std::move(*result);
}

struct Section {
  std::uint64_t start = 0, size = 0;
};

struct Node {
  std::string path;
  bool is_property = false;
};

struct Crate {
  ByteSpan file;
  std::map<std::string, Section> sections{};
  std::vector<std::string> tokens{};
  std::vector<std::uint32_t> strings{};
  std::vector<std::pair<std::uint32_t, std::uint64_t>> fields{};
  Numbers field_sets{};
  std::vector<Node> nodes{};            ///< By number of the path.
  std::vector<std::size_t> in_order{};  ///< Numbers of paths in the order of the file.
  mutable std::uint64_t unpacked = 0;   ///< Numbers, texts and letters of paths that were read.

  // Bounds the memory that a small file can ask for: compression packs at most 1020 numbers into a byte.
  void unpack(std::uint64_t count) const {
    unpacked += count;
    if (unpacked > 1024 * file.size() + (1 << 20)) throw CrateError{"no more values than the file has room for"};
  }

  const std::string& token(std::uint64_t number) const {
    if (number >= tokens.size()) throw CrateError{"tokens that are there"};
    return tokens[number];
  }
  const std::string& text(std::uint64_t number) const {
    if (number >= strings.size()) throw CrateError{"strings that are there"};
    return token(strings[number]);
  }
  const Node& node(std::uint64_t number) const {
    if (number >= nodes.size() || nodes[number].path.empty()) throw CrateError{"paths that are there"};
    return nodes[number];
  }
  Cursor section(const char* name) const {
    const auto found = sections.find(name);
    if (found == sections.end()) throw CrateError{std::string("a section ") + name};
    return Cursor(file, found->second.start);
  }
};

// ---- tables ----

Numbers packed_numbers(Cursor& cursor, std::uint64_t count) {
  return must(decompress_integers(cursor.take(cursor.number<std::uint64_t>()), count));
}

void read_contents(Crate& crate) {
  Cursor head(crate.file, 8);
  const auto major = head.number<std::uint8_t>(), minor = head.number<std::uint8_t>();
  if (major != 0 || minor < 7 || minor > 13) throw CrateError{"a version from 0.7 to 0.13"};
  Cursor contents(crate.file, Cursor(crate.file, 16).number<std::uint64_t>());
  const std::uint64_t count = contents.count(kCrateSectionNameBytes + 16);
  for (std::uint64_t i = 0; i < count; ++i) {
    const ByteSpan name = contents.take(kCrateSectionNameBytes);
    const std::string_view text(reinterpret_cast<const char*>(name.data()), name.size());
    const auto start = contents.number<std::uint64_t>(), size = contents.number<std::uint64_t>();
    crate.sections[std::string(text.substr(0, text.find('\0')))] = {start, size};
  }
}

void read_tokens(Crate& crate) {
  Cursor cursor = crate.section("TOKENS");
  const auto count = cursor.number<std::uint64_t>(), size = cursor.number<std::uint64_t>();
  const auto all = must(decompress_bytes(cursor.take(cursor.number<std::uint64_t>()), size));
  std::string_view rest(reinterpret_cast<const char*>(all.data()), all.size());
  while (!rest.empty()) {
    const std::size_t end = rest.find('\0');
    if (end == std::string_view::npos) throw CrateError{"tokens that end"};
    crate.tokens.emplace_back(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
  if (crate.tokens.size() != count) throw CrateError{"as many tokens as it says"};
  Cursor strings = crate.section("STRINGS");
  crate.strings.resize(strings.count(4));
  for (std::uint32_t& number : crate.strings) number = strings.number<std::uint32_t>();
}

void read_fields(Crate& crate) {
  Cursor cursor = crate.section("FIELDS");
  const auto count = cursor.number<std::uint64_t>();
  const Numbers names = packed_numbers(cursor, count);
  const auto values = must(decompress_bytes(cursor.take(cursor.number<std::uint64_t>()), 8 * names.size()));
  if (values.size() != 8 * names.size()) throw CrateError{"a value for each field"};
  Cursor value(values, 0);
  for (const std::int32_t name : names)
    crate.fields.emplace_back(static_cast<std::uint32_t>(name), value.number<std::uint64_t>());
  Cursor sets = crate.section("FIELDSETS");
  crate.field_sets = packed_numbers(sets, sets.number<std::uint64_t>());
}

// The path below a parent, of a prim or a property.
std::string path_below(const std::string& parent, const std::string& name, bool is_property) {
  if (is_property) return parent + "." + name;
  return parent == "/" ? "/" + name : parent + "/" + name;
}

void read_paths(Crate& crate) {
  Cursor cursor = crate.section("PATHS");
  const auto count = cursor.number<std::uint64_t>();
  if (cursor.number<std::uint64_t>() != count) throw CrateError{"as many paths as it says"};
  const Numbers numbers = packed_numbers(cursor, count), names = packed_numbers(cursor, count),
                jumps = packed_numbers(cursor, count);
  crate.nodes.resize(numbers.size());
  std::vector<std::pair<std::size_t, std::string>> open;  // where a sibling begins, and its parent
  std::string parent;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!open.empty() && open.back().first == i) parent = open.back().second, open.pop_back();
    const auto number = static_cast<std::size_t>(static_cast<std::uint32_t>(numbers[i]));
    if (number >= crate.nodes.size() || !crate.nodes[number].path.empty()) throw CrateError{"each path once"};
    const bool is_property = names[i] < 0;
    const std::string& name = crate.token(static_cast<std::uint64_t>(std::abs(static_cast<std::int64_t>(names[i]))));
    crate.nodes[number] = {i == 0 ? "/" : path_below(parent, name, is_property), is_property};
    crate.in_order.push_back(number);
    crate.unpack(crate.nodes[number].path.size());
    if (jumps[i] > 0) open.emplace_back(i + static_cast<std::size_t>(jumps[i]), parent);
    if (jumps[i] > 0 || jumps[i] == kJumpChild) parent = crate.nodes[number].path;
    const bool is_leaf = jumps[i] == kJumpLeaf;
    if (is_leaf && i + 1 < numbers.size() && (open.empty() || open.back().first != i + 1))
      throw CrateError{"a tree of paths"};
  }
}

// ---- values ----

template <typename T>
UsdReadValue numbers_at(Cursor cursor, std::uint64_t count) {
  UsdReadValue value;
  value.numbers.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) value.numbers.push_back(static_cast<double>(cursor.number<T>()));
  return value;
}

UsdReadValue quaternions_at(Cursor cursor, std::uint64_t count) {
  UsdReadValue value;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto q = cursor.number<UsdQuath>();
    for (const std::size_t part : {3, 0, 1, 2}) value.numbers.push_back(half_value(q[part]));
  }
  return value;
}

CrateType crate_type_of(std::uint64_t rep) { return static_cast<CrateType>(rep >> 48 & 0xff); }

UsdReadValue texts_at(const Crate& crate, Cursor cursor, std::uint64_t count, CrateType type) {
  UsdReadValue value;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto number = cursor.number<std::uint32_t>();
    value.texts.push_back(type == CrateType::kString ? crate.text(number) : crate.token(number));
  }
  return value;
}

// So many values of a type; 1 for scalars.
UsdReadValue plain_values(const Crate& crate, CrateType type, Cursor cursor, std::uint64_t count) {
  switch (type) {
    case CrateType::kInt:
      return numbers_at<std::int32_t>(cursor, count);
    case CrateType::kInt64:
      return numbers_at<std::int64_t>(cursor, count);
    case CrateType::kFloat:
      return numbers_at<float>(cursor, count);
    case CrateType::kDouble:
      return numbers_at<double>(cursor, count);
    case CrateType::kVec2f:
      return numbers_at<float>(cursor, 2 * count);
    case CrateType::kVec3f:
      return numbers_at<float>(cursor, 3 * count);
    case CrateType::kVec4f:
      return numbers_at<float>(cursor, 4 * count);
    case CrateType::kVec3d:
      return numbers_at<double>(cursor, 3 * count);
    case CrateType::kQuath:
      return quaternions_at(cursor, count);
    case CrateType::kString:
    case CrateType::kToken:
    case CrateType::kAssetPath:
      return texts_at(crate, cursor, count, type);
    default:
      throw CrateError{"types that citykiln writes"};
  }
}

UsdReadValue array_at(const Crate& crate, std::uint64_t rep) {
  const std::uint64_t offset = rep & kCratePayload;
  if (offset == 0) return {};
  Cursor cursor(crate.file, offset);
  if ((rep & kCrateCompressed) == 0) {
    const std::uint64_t count = cursor.count(4);
    return plain_values(crate, crate_type_of(rep), cursor, count);
  }
  if (crate_type_of(rep) != CrateType::kInt) throw CrateError{"compressed arrays of integers alone"};
  const Numbers numbers = packed_numbers(cursor, cursor.number<std::uint64_t>());
  return {{numbers.begin(), numbers.end()}, {}};
}

UsdReadValue inlined_value(const Crate& crate, std::uint64_t rep) {
  const auto payload = static_cast<std::uint32_t>(rep);
  switch (crate_type_of(rep)) {
    case CrateType::kBool:
    case CrateType::kSpecifier:
    case CrateType::kVariability:
      return {{static_cast<double>(payload)}, {}};
    case CrateType::kInt:
      return {{static_cast<double>(static_cast<std::int32_t>(payload))}, {}};
    case CrateType::kFloat:
      return {{static_cast<double>(std::bit_cast<float>(payload))}, {}};
    case CrateType::kString:
      return {{}, {crate.text(payload)}};
    case CrateType::kToken:
    case CrateType::kAssetPath:
      return {{}, {crate.token(payload)}};
    default:
      throw CrateError{"types that citykiln writes"};
  }
}

UsdReadValue value_of(const Crate& crate, std::uint64_t rep) {
  if ((rep & kCrateArray) != 0) {
    UsdReadValue value = array_at(crate, rep);
    crate.unpack(value.numbers.size() + 4 * value.texts.size());
    return value;
  }
  if ((rep & kCrateInlined) != 0) return inlined_value(crate, rep);
  return plain_values(crate, crate_type_of(rep), Cursor(crate.file, rep & kCratePayload), 1);
}

UsdReadDictionary read_dictionary(const Crate& crate, std::uint64_t rep) {
  UsdReadDictionary entries;
  const std::uint64_t start = rep & kCratePayload;
  Cursor cursor(crate.file, start);
  const std::uint64_t count = cursor.count(20);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string& name = crate.text(cursor.number<std::uint32_t>());
    if (cursor.number<std::int64_t>() != 8) throw CrateError{"dictionaries without nested values"};
    entries[name] = value_of(crate, cursor.number<std::uint64_t>());
  }
  return entries;
}

std::vector<std::string> paths_of(const Crate& crate, std::uint64_t rep) {
  Cursor cursor(crate.file, rep & kCratePayload);
  if (cursor.number<std::uint8_t>() != kListExplicit) throw CrateError{"explicit lists of paths"};
  std::vector<std::string> paths(cursor.count(4));
  for (std::string& path : paths) path = crate.node(cursor.number<std::uint32_t>()).path;
  return paths;
}

// ---- specs ----

using Fields = std::map<std::string, std::uint64_t>;
constexpr std::size_t kMostFields = 32;

Fields fields_from(const Crate& crate, std::int32_t first) {
  Fields fields;
  for (auto i = static_cast<std::size_t>(static_cast<std::uint32_t>(first));; ++i) {
    if (i >= crate.field_sets.size()) throw CrateError{"lists of fields that end"};
    if (crate.field_sets[i] == -1) return fields;
    if (fields.size() > kMostFields) throw CrateError{"fewer fields for a path"};
    const auto number = static_cast<std::size_t>(static_cast<std::uint32_t>(crate.field_sets[i]));
    if (number >= crate.fields.size()) throw CrateError{"fields that are there"};
    const bool is_new = fields.emplace(crate.token(crate.fields[number].first), crate.fields[number].second).second;
    if (!is_new) throw CrateError{"each field of a path once"};
  }
}

// The fields of each path. Paths without a spec have none.
std::vector<Fields> read_specs(const Crate& crate) {
  Cursor cursor = crate.section("SPECS");
  const auto count = cursor.number<std::uint64_t>();
  const Numbers paths = packed_numbers(cursor, count), fields = packed_numbers(cursor, count);
  std::vector<Fields> by_path(crate.nodes.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto path = static_cast<std::size_t>(static_cast<std::uint32_t>(paths[i]));
    crate.node(path);
    if (!by_path[path].empty()) throw CrateError{"one spec for each path"};
    by_path[path] = fields_from(crate, fields[i]);
  }
  return by_path;
}

std::string text_field(const Crate& crate, const Fields& fields, const char* name) {
  const auto found = fields.find(name);
  if (found == fields.end()) return "";
  const UsdReadValue value = value_of(crate, found->second);
  return value.texts.size() == 1 ? value.texts.front() : "";
}

void add_property(const Crate& crate, const Fields& fields, const std::string& name, UsdReadPrim& prim) {
  for (const auto& [field, rep] : fields) {
    if (field == "default") prim.values[name] = value_of(crate, rep);
    if (field == "targetPaths" || field == "connectionPaths") prim.targets[name] = paths_of(crate, rep);
    if (field == "interpolation") prim.interpolations[name] = text_field(crate, fields, "interpolation");
  }
}

void add_head(const Crate& crate, const Fields& fields, UsdReadLayer& layer) {
  layer.default_prim = text_field(crate, fields, "defaultPrim");
  layer.up_axis = text_field(crate, fields, "upAxis");
  if (const auto unit = fields.find("metersPerUnit"); unit != fields.end())
    layer.meters_per_unit = value_of(crate, unit->second).numbers.at(0);
  if (const auto data = fields.find("customLayerData"); data != fields.end())
    layer.custom_data = read_dictionary(crate, data->second);
}

UsdReadLayer layer_of(const Crate& crate) {
  UsdReadLayer layer;
  const std::vector<Fields> fields = read_specs(crate);
  for (const std::size_t number : crate.in_order) {
    const Node& node = crate.nodes[number];
    if (node.path == "/") {
      add_head(crate, fields[number], layer);
    } else if (node.is_property) {
      const std::size_t dot = node.path.find('.');
      if (layer.prims.empty() || layer.prims.back().path != node.path.substr(0, dot))
        throw CrateError{"properties before the children of their prim"};
      add_property(crate, fields[number], node.path.substr(dot + 1), layer.prims.back());
    } else {
      layer.prims.push_back({.path = node.path, .type = text_field(crate, fields[number], "typeName")});
      if (const auto data = fields[number].find("customData"); data != fields[number].end())
        layer.prims.back().custom_data = read_dictionary(crate, data->second);
    }
  }
  return layer;
}

}  // namespace

Result<UsdReadLayer> read_crate(ByteSpan bytes) {
  try {
    Crate crate{.file = bytes};
    if (bytes.size() < kCrateBootstrapBytes) throw CrateError{"88 bytes at least"};
    read_contents(crate);
    read_tokens(crate);
    read_fields(crate);
    read_paths(crate);
    return layer_of(crate);
  } catch (const CrateError& problem) {
    return Error{"", "is no crate that citykiln wrote; expected " + problem.expected};
  } catch (const std::out_of_range&) {
    return Error{"", "is no crate that citykiln wrote"};
  }
}

}  // namespace citykiln::exporters
