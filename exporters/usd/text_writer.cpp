#include "exporters/usd/text_writer.h"

#include <fmt/format.h>

#include <cassert>
#include <charconv>
#include <type_traits>

namespace citykiln::exporters {
namespace {

constexpr std::size_t kIndent = 4;

void put_alternative(std::string& out, std::string_view text) { out += exporters::quoted(text); }
void put_alternative(std::string& out, const std::string& text) { out += exporters::quoted(text); }
void put_alternative(std::string& out, const UsdToken& token) { out += exporters::quoted(token.text); }
void put_alternative(std::string& out, const UsdAsset& asset) { out += '@' + asset.path + '@'; }
void put_alternative(std::string& out, bool value) { out += value ? "true" : "false"; }
void put_alternative(std::string&, std::monostate) {}

template <typename Number>
requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>) void put_alternative(std::string& out,
                                                                                             Number value) {
  char digits[32];
  const auto end = std::to_chars(digits, std::end(digits), value).ptr;
  out.append(digits, end);
}

template <std::size_t kSize>
void put_alternative(std::string& out, const std::array<float, kSize>& values) {
  for (std::size_t i = 0; i < kSize; ++i) {
    out += i == 0 ? '(' : ',';
    put_alternative(out, values[i]);
  }
  out += ')';
}

void put_alternative(std::string& out, Vec3 v) { out += fmt::format("({},{},{})", v.x, v.y, v.z); }

// The real part is the first in text.
void put_alternative(std::string& out, const UsdQuath& q) {
  put_alternative(out, bake::Float4{half_value(q[3]), half_value(q[0]), half_value(q[1]), half_value(q[2])});
}

template <typename T>
void put_alternative(std::string& out, std::span<const T> values) {
  out += '[';
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) out += ',';
    put_alternative(out, values[i]);
  }
  out += ']';
}
void put_alternative(std::string& out, const UsdTokens& tokens) { put_alternative(out, tokens.texts); }

void put_value(std::string& out, const UsdValue& value) {
  std::visit([&](const auto& v) { put_alternative(out, v); }, value);
}

void put_dictionary(std::string& out, std::string_view name, const UsdDictionary& entries, std::size_t indent) {
  const std::string margin(indent, ' ');
  out += fmt::format("{}{} = {{\n", margin, name);
  for (const auto& [key, value] : entries) {
    out += fmt::format("{}    {} {} = ", margin, usd_type_of(value), key);
    put_value(out, value);
    out += '\n';
  }
  out += margin + "}\n";
}

bool has_metadata(const UsdPrim& prim) {
  return !prim.api_schemas.empty() || !prim.kind.empty() || !prim.custom_data.empty();
}

void put_metadata(std::string& out, const UsdPrim& prim, std::size_t indent) {
  const std::string margin(indent, ' ');
  if (!prim.api_schemas.empty()) {
    out += margin + "prepend apiSchemas = [";
    for (const std::string_view& schema : prim.api_schemas) {
      if (&schema != prim.api_schemas.data()) out += ", ";
      put_alternative(out, schema);
    }
    out += "]\n";
  }
  if (!prim.custom_data.empty()) put_dictionary(out, "customData", prim.custom_data, indent);
  if (!prim.kind.empty()) out += margin + "kind = " + exporters::quoted(prim.kind) + '\n';
}

}  // namespace

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += '\\', out += c;
    else if (c == '\n')
      out += "\\n";
    else if (static_cast<unsigned char>(c) < ' ')
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else
      out += c;
  }
  return out + '"';
}

std::string text_of(const UsdValue& value) {
  std::string out;
  put_value(out, value);
  return out;
}

TextWriter::TextWriter(const UsdLayerHead& head) {
  text_ = "#usda 1.0\n(\n";
  if (!head.custom_data.empty()) put_dictionary(text_, "customLayerData", head.custom_data, kIndent);
  text_ += fmt::format("    defaultPrim = \"{}\"\n    metersPerUnit = 1\n    upAxis = \"Z\"\n)\n", head.default_prim);
}

void TextWriter::new_line() { text_.append(kIndent * depth_, ' '); }

void TextWriter::begin_prim(const UsdPrim& prim) {
  text_ += '\n';
  new_line();
  text_ += fmt::format("def {} \"{}\"", prim.type, prim.name);
  if (has_metadata(prim)) {
    text_ += " (\n";
    put_metadata(text_, prim, kIndent * (depth_ + 1));
    new_line();
    text_ += ')';
  }
  text_ += '\n';
  new_line();
  text_ += "{\n";
  ++depth_;
}

void TextWriter::write(const UsdAttribute& a) {
  new_line();
  text_ += fmt::format("{}{}{} {}", a.is_custom ? "custom " : "", a.is_uniform ? "uniform " : "", a.type, a.name);
  if (!a.connection.empty()) text_ += fmt::format(".connect = <{}>", a.connection);
  if (!std::holds_alternative<std::monostate>(a.value)) {
    text_ += " = ";
    put_value(text_, a.value);
  }
  if (!a.interpolation.empty()) text_ += fmt::format(" (interpolation = \"{}\")", a.interpolation);
  text_ += '\n';
}

void TextWriter::write(const UsdRelationship& relationship) {
  assert(!relationship.targets.empty());
  new_line();
  text_ += "rel " + relationship.name + " = ";
  const bool is_list = relationship.targets.size() > 1;
  if (is_list) text_ += '[';
  for (const std::string& target : relationship.targets)
    text_ += fmt::format("{}<{}>", &target == relationship.targets.data() ? "" : ", ", target);
  if (is_list) text_ += ']';
  text_ += '\n';
}

void TextWriter::end_prim() {
  assert(depth_ > 0);
  --depth_;
  new_line();
  text_ += "}\n";
}

void TextWriter::write_lines(std::string_view lines) {
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    new_line();
    text_ += lines.substr(0, end);
    text_ += '\n';
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
  }
}

std::vector<std::byte> TextWriter::finish() {
  assert(depth_ == 0);
  const auto bytes = std::as_bytes(std::span(text_));
  return {bytes.begin(), bytes.end()};
}

}  // namespace citykiln::exporters
