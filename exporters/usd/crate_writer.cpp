#include "exporters/usd/crate_writer.h"

#include <bit>
#include <cassert>
#include <cstring>
#include <type_traits>
#include <utility>

#include "exporters/usd/crate_coding.h"

namespace citykiln::exporters {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::uint64_t rep(CrateType type, std::uint64_t flags, std::uint64_t payload) {
  return flags | static_cast<std::uint64_t>(type) << 48 | payload;
}
std::uint64_t inlined(CrateType type, std::uint32_t payload) { return rep(type, kCrateInlined, payload); }

}  // namespace

// ---- values ----

template <typename T>
void CrateWriter::put_raw(const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  put(std::as_bytes(std::span(&value, 1)));
}

// The value that begins at the end of the file.
std::uint64_t CrateWriter::offset(CrateType type, std::uint64_t flags) {
  out_.resize((out_.size() + 7) / 8 * 8);
  assert(out_.size() <= kCratePayload);
  return rep(type, flags, out_.size());
}

template <typename T>
std::uint64_t CrateWriter::scalar(CrateType type, const T& value) {
  const std::uint64_t at = offset(type);
  put_raw(value);
  return at;
}

template <typename T>
std::uint64_t CrateWriter::array(CrateType type, std::span<const T> values) {
  if (values.empty()) return rep(type, kCrateArray, 0);
  const std::uint64_t at = offset(type, kCrateArray);
  put_raw(std::uint64_t{values.size()});
  put(std::as_bytes(values));
  return at;
}

std::uint64_t CrateWriter::integers(std::span<const std::int32_t> numbers) {
  if (numbers.size() < kCrateLeastCompressed) return array(CrateType::kInt, numbers);
  const std::uint64_t at = offset(CrateType::kInt, kCrateArray | kCrateCompressed);
  put_raw(std::uint64_t{numbers.size()});
  put_packed(numbers);
  return at;
}

std::uint64_t CrateWriter::texts(CrateType type, std::span<const std::string> texts) {
  std::vector<std::uint32_t> numbers;
  for (const std::string& text : texts) numbers.push_back(token(text));
  return array(type, std::span<const std::uint32_t>(numbers));
}

std::uint64_t CrateWriter::tokens(const std::vector<std::uint32_t>& numbers) {
  const std::uint64_t at = offset(CrateType::kTokenVector);
  put_raw(std::uint64_t{numbers.size()});
  put(std::as_bytes(std::span(numbers)));
  return at;
}

std::uint64_t CrateWriter::dictionary(const UsdDictionary& entries) {
  std::vector<std::pair<std::uint32_t, std::uint64_t>> values;
  for (const auto& [name, entry] : entries) {
    // both calls number tokens; compilers differ in the order of arguments
    const std::uint64_t coded = value(entry);
    values.emplace_back(token(name), coded);
  }
  const std::uint64_t at = offset(CrateType::kDictionary);
  put_raw(std::uint64_t{values.size()});
  for (const auto& [name, entry] : values) {
    put_raw(name);
    put_raw(std::int64_t{8});  // from here to the value
    put_raw(entry);
  }
  return at;
}

std::uint64_t CrateWriter::paths(const std::vector<std::string>& targets) {
  const std::uint64_t at = offset(CrateType::kPathListOp);
  put_raw(kListExplicit);
  put_raw(std::uint64_t{targets.size()});
  for (const std::string& target : targets) {
    path_uses_.emplace_back(out_.size(), target);
    put_raw(std::uint32_t{0});
  }
  return at;
}

std::uint64_t CrateWriter::value(const UsdValue& value) {
  struct Visitor {
    CrateWriter& w;
    std::uint64_t operator()(std::monostate) const { return 0; }
    std::uint64_t operator()(bool v) const { return inlined(CrateType::kBool, v ? 1 : 0); }
    std::uint64_t operator()(std::int32_t v) const { return inlined(CrateType::kInt, static_cast<std::uint32_t>(v)); }
    std::uint64_t operator()(std::int64_t v) const { return w.scalar(CrateType::kInt64, v); }
    std::uint64_t operator()(float v) const { return inlined(CrateType::kFloat, std::bit_cast<std::uint32_t>(v)); }
    std::uint64_t operator()(double v) const { return w.scalar(CrateType::kDouble, v); }
    std::uint64_t operator()(const std::string& v) const { return inlined(CrateType::kString, w.token(v)); }
    std::uint64_t operator()(const UsdToken& v) const { return inlined(CrateType::kToken, w.token(v.text)); }
    std::uint64_t operator()(const UsdAsset& v) const { return inlined(CrateType::kAssetPath, w.token(v.path)); }
    std::uint64_t operator()(const bake::Float2& v) const { return w.scalar(CrateType::kVec2f, v); }
    std::uint64_t operator()(const bake::Float3& v) const { return w.scalar(CrateType::kVec3f, v); }
    std::uint64_t operator()(const bake::Float4& v) const { return w.scalar(CrateType::kVec4f, v); }
    std::uint64_t operator()(Vec3 v) const { return w.scalar(CrateType::kVec3d, v); }
    std::uint64_t operator()(std::span<const std::int32_t> v) const { return w.integers(v); }
    std::uint64_t operator()(std::span<const std::int64_t> v) const { return w.array(CrateType::kInt64, v); }
    std::uint64_t operator()(std::span<const float> v) const { return w.array(CrateType::kFloat, v); }
    std::uint64_t operator()(std::span<const bake::Float2> v) const { return w.array(CrateType::kVec2f, v); }
    std::uint64_t operator()(std::span<const bake::Float3> v) const { return w.array(CrateType::kVec3f, v); }
    std::uint64_t operator()(std::span<const UsdQuath> v) const { return w.array(CrateType::kQuath, v); }
    std::uint64_t operator()(std::span<const std::string> v) const { return w.texts(CrateType::kString, v); }
    std::uint64_t operator()(const UsdTokens& v) const { return w.texts(CrateType::kToken, v.texts); }
  };
  return std::visit(Visitor{*this}, value);
}

// ---- prims and properties ----

std::uint32_t CrateWriter::token(std::string_view text) {
  const auto found = token_numbers_.find(text);
  if (found != token_numbers_.end()) return found->second;
  const auto number = static_cast<std::uint32_t>(token_list_.size());
  token_list_.emplace_back(text);
  token_numbers_.emplace(text, number);
  return number;
}

std::int32_t CrateWriter::field(std::string_view name, std::uint64_t value) {
  const std::pair key(token(name), value);
  const auto [at, is_new] = field_numbers_.try_emplace(key, static_cast<std::int32_t>(field_list_.size()));
  if (is_new) field_list_.push_back(key);
  return at->second;
}

std::int32_t CrateWriter::add_path(std::int32_t token, std::string path) {
  const auto number = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back({token, static_cast<std::int32_t>(open_.size())});
  [[maybe_unused]] const bool is_new = path_numbers_.emplace(std::move(path), number).second;
  assert(is_new && "each prim and property once");
  return number;
}

void CrateWriter::add_spec(std::int32_t path, CrateSpec type, const Fields& fields) {
  const auto [at, is_new] = field_set_places_.try_emplace(fields, static_cast<std::int32_t>(field_sets_.size()));
  if (is_new) {
    field_sets_.insert(field_sets_.end(), fields.begin(), fields.end());
    field_sets_.push_back(-1);
  }
  specs_.push_back({path, at->second, type});
}

void CrateWriter::begin(std::string_view name) {
  const bool is_root = open_.empty();
  std::string path = is_root ? "" : open_paths_.back() + "/" + std::string(name);
  const std::uint32_t number = is_root ? 0 : token(name);
  if (!is_root) open_.back().children.push_back(number);
  const std::int32_t at = add_path(static_cast<std::int32_t>(number), is_root ? "/" : path);
  open_.push_back({.path = at, .fields = {}, .properties = {}, .children = {}});
  open_paths_.push_back(std::move(path));
}

void CrateWriter::end(CrateSpec type) {
  assert(!open_.empty());
  OpenPrim prim = std::move(open_.back());
  if (!prim.properties.empty()) prim.fields.push_back(field("properties", tokens(prim.properties)));
  if (!prim.children.empty()) prim.fields.push_back(field("primChildren", tokens(prim.children)));
  add_spec(prim.path, type, prim.fields);
  open_.pop_back(), open_paths_.pop_back();
}

CrateWriter::CrateWriter(const UsdLayerHead& head) : out_(kCrateBootstrapBytes) {
  token(";-)");  // number 0 has no negative, which marks properties
  begin("");
  Fields& fields = open_.back().fields;
  if (!head.custom_data.empty()) fields.push_back(field("customLayerData", dictionary(head.custom_data)));
  fields.push_back(field("defaultPrim", value(UsdToken{head.default_prim})));
  fields.push_back(field("metersPerUnit", value(1.0)));
  fields.push_back(field("upAxis", value(UsdToken{"Z"})));
}

void CrateWriter::begin_prim(const UsdPrim& prim) {
  begin(prim.name);
  Fields fields = {field("specifier", inlined(CrateType::kSpecifier, 0)),
                   field("typeName", value(UsdToken{std::string(prim.type)}))};
  if (!prim.api_schemas.empty()) {
    fields.push_back(field("apiSchemas", offset(CrateType::kTokenListOp)));
    put_raw(kListPrepended);
    put_raw(std::uint64_t{prim.api_schemas.size()});
    for (const std::string_view schema : prim.api_schemas) put_raw(token(schema));
  }
  if (!prim.custom_data.empty()) fields.push_back(field("customData", dictionary(prim.custom_data)));
  if (!prim.kind.empty()) fields.push_back(field("kind", value(UsdToken{std::string(prim.kind)})));
  open_.back().fields = std::move(fields);
}

void CrateWriter::write(const UsdAttribute& a) {
  assert(open_.size() > 1);
  Fields fields = {field("typeName", value(UsdToken{std::string(a.type)}))};
  if (a.is_custom) fields.push_back(field("custom", value(true)));
  if (a.is_uniform) fields.push_back(field("variability", inlined(CrateType::kVariability, 1)));
  if (!a.interpolation.empty()) fields.push_back(field("interpolation", value(UsdToken{std::string(a.interpolation)})));
  if (!std::holds_alternative<std::monostate>(a.value)) fields.push_back(field("default", value(a.value)));
  if (!a.connection.empty()) fields.push_back(field("connectionPaths", paths({a.connection})));
  const std::uint32_t name = token(a.name);
  open_.back().properties.push_back(name);
  add_spec(add_path(-static_cast<std::int32_t>(name), open_paths_.back() + "." + a.name), CrateSpec::kAttribute,
           fields);
}

void CrateWriter::write(const UsdRelationship& relationship) {
  assert(open_.size() > 1);
  const Fields fields = {field("variability", inlined(CrateType::kVariability, 1)),
                         field("targetPaths", paths(relationship.targets))};
  const std::uint32_t name = token(relationship.name);
  open_.back().properties.push_back(name);
  add_spec(add_path(-static_cast<std::int32_t>(name), open_paths_.back() + "." + relationship.name),
           CrateSpec::kRelationship, fields);
}

void CrateWriter::end_prim() { end(CrateSpec::kPrim); }

// ---- sections ----

void CrateWriter::put_packed(std::span<const std::int32_t> numbers) {
  const std::vector<std::byte> packed = compress_integers(numbers);
  put_raw(std::uint64_t{packed.size()});
  put(packed);
}

void CrateWriter::put_tokens() {
  std::string all;
  for (const std::string& text : token_list_) all += text, all += '\0';
  const std::vector<std::byte> packed = compress_bytes(std::as_bytes(std::span(all)));
  put_raw(std::uint64_t{token_list_.size()});
  put_raw(std::uint64_t{all.size()});
  put_raw(std::uint64_t{packed.size()});
  put(packed);
}

void CrateWriter::put_fields() {
  std::vector<std::int32_t> names;
  std::vector<std::uint64_t> values;
  for (const auto& [name, value] : field_list_)
    names.push_back(static_cast<std::int32_t>(name)), values.push_back(value);
  put_raw(std::uint64_t{names.size()});
  put_packed(names);
  const std::vector<std::byte> packed = compress_bytes(std::as_bytes(std::span(values)));
  put_raw(std::uint64_t{packed.size()});
  put(packed);
}

void CrateWriter::put_paths() {
  const std::size_t count = nodes_.size();
  std::vector<std::int32_t> numbers(count), names(count), jumps(count);
  std::vector<std::int32_t> next;  // by depth, the sibling that follows the node
  for (std::size_t i = count; i-- > 0;) {
    const auto depth = static_cast<std::size_t>(nodes_[i].depth);
    const auto at = static_cast<std::int32_t>(i);
    const bool has_child = next.size() > depth + 1;
    next.resize(depth + 1, -1);  // those of its children end with it
    const std::int32_t sibling = std::exchange(next[depth], at);
    jumps[i] = has_child ? (sibling < 0 ? kJumpChild : sibling - at) : (sibling < 0 ? kJumpLeaf : kJumpSibling);
    numbers[i] = at, names[i] = nodes_[i].token;
  }
  put_raw(std::uint64_t{count});
  put_raw(std::uint64_t{count});
  put_packed(numbers), put_packed(names), put_packed(jumps);
}

void CrateWriter::put_specs() {
  std::vector<std::int32_t> paths, fields, types;
  for (const Spec& spec : specs_)
    paths.push_back(spec.path), fields.push_back(spec.fields), types.push_back(static_cast<std::int32_t>(spec.type));
  put_raw(std::uint64_t{specs_.size()});
  put_packed(paths), put_packed(fields), put_packed(types);
}

void CrateWriter::put_strings() {
  put_raw(std::uint64_t{token_list_.size()});
  for (std::uint32_t i = 0; i < token_list_.size(); ++i) put_raw(i);
}

void CrateWriter::put_field_sets() {
  put_raw(std::uint64_t{field_sets_.size()});
  put_packed(field_sets_);
}

// Writes the numbers of paths that were named before they existed.
void CrateWriter::set_path_numbers() {
  for (const auto& [place, path] : path_uses_) {
    const auto found = path_numbers_.find(path);
    assert(found != path_numbers_.end() && "targets are prims and properties of the layer");
    std::memcpy(out_.data() + place, &found->second, sizeof found->second);
  }
}

void CrateWriter::put_bootstrap(std::uint64_t contents) {
  constexpr std::uint8_t kVersion[8] = {0, 8, 0};
  std::memcpy(out_.data(), kCrateMagic, 8);
  std::memcpy(out_.data() + 8, kVersion, sizeof kVersion);
  std::memcpy(out_.data() + 16, &contents, sizeof contents);
}

std::vector<std::byte> CrateWriter::finish() {
  end(CrateSpec::kPseudoRoot);
  assert(open_.empty());
  set_path_numbers();
  constexpr std::pair<const char*, void (CrateWriter::*)()> kSections[] = {
      {"TOKENS", &CrateWriter::put_tokens}, {"STRINGS", &CrateWriter::put_strings},
      {"FIELDS", &CrateWriter::put_fields}, {"FIELDSETS", &CrateWriter::put_field_sets},
      {"PATHS", &CrateWriter::put_paths},   {"SPECS", &CrateWriter::put_specs}};
  std::vector<std::uint64_t> starts, ends;
  for (const auto& [name, put_section] : kSections) {
    out_.resize((out_.size() + 7) / 8 * 8);
    starts.push_back(out_.size());
    (this->*put_section)();
    ends.push_back(out_.size());
  }
  const std::uint64_t contents = out_.size();
  put_raw(std::uint64_t{starts.size()});
  for (std::size_t i = 0; i < starts.size(); ++i) {
    char name[kCrateSectionNameBytes] = {};
    std::strncpy(name, kSections[i].first, sizeof name - 1);
    put_raw(name), put_raw(starts[i]), put_raw(ends[i] - starts[i]);
  }
  put_bootstrap(contents);
  return std::move(out_);
}

}  // namespace citykiln::exporters
