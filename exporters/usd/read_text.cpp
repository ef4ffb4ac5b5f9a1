#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

#include "exporters/usd/read_layer.h"

namespace citykiln::exporters {
namespace {

/// A fault of a text: what was expected, and where.
struct TextError {
  std::string expected;
  std::size_t at;
};

constexpr int kDeepest = 64;

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == ';'; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == ':' || c == '.'; }

// Types of integers and of double precision are not.
bool is_single(std::string_view type) {
  return !type.starts_with("int") && !type.starts_with("double") && !type.starts_with("matrix");
}

// A recursive descent over the grammar of .usda, as far as citykiln uses it.
class TextReader {
 public:
  explicit TextReader(std::string_view text) : text_(text) {}

  UsdReadLayer layer() {
    if (!text_.starts_with("#usda 1.0")) throw TextError{"#usda 1.0", 0};
    UsdReadPrim head;
    if (next() == '(') metadata(head, 0);
    layer_.custom_data = head.custom_data;
    while (next() != '\0') {
      if (word() != "def") throw TextError{"def", at_};
      prim("", 0);
    }
    return std::move(layer_);
  }

 private:
  // The next character after white space and comments; '\0' at the end.
  char next() {
    while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == '#'))
      at_ = text_[at_] == '#' ? std::min(text_.find('\n', at_), text_.size()) : at_ + 1;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  void expect(char c) {
    if (next() != c) throw TextError{std::string(1, c), at_};
    ++at_;
  }

  bool skip(char c) {
    const bool found = next() == c;
    at_ += found;
    return found;
  }

  std::string word() {
    next();
    const std::size_t start = at_;
    while (at_ < text_.size() && is_word(text_[at_])) ++at_;
    if (at_ == start) throw TextError{"a word", at_};
    return std::string(text_.substr(start, at_ - start));
  }

  char escaped() {
    const char c = text_[at_++];
    if (c == 'n') return '\n';
    if (c != 'x') return c;
    unsigned value = 0;
    const auto digits = text_.substr(at_, 2);
    if (std::from_chars(digits.data(), digits.data() + digits.size(), value, 16).ptr != digits.data() + 2)
      throw TextError{"two digits", at_};
    at_ += 2;
    return static_cast<char>(value);
  }

  std::string text() {
    expect('"');
    std::string out;
    while (at_ < text_.size() && text_[at_] != '"') {
      const char c = text_[at_++];
      if (c == '\\' && at_ == text_.size()) break;
      out += c == '\\' ? escaped() : c;
    }
    expect('"');
    return out;
  }

  // The text between two characters.
  std::string between(char open, char close) {
    expect(open);
    const std::size_t end = text_.find(close, at_);
    if (end == std::string_view::npos) throw TextError{std::string(1, close), at_};
    const std::string out(text_.substr(at_, end - at_));
    at_ = end + 1;
    return out;
  }

  template <typename Number>
  Number number_as() {
    next();
    Number value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) throw TextError{"a number", at_};
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  // The number that the attribute's type holds.
  double number() { return is_single_ ? static_cast<double>(number_as<float>()) : number_as<double>(); }

  // A value, nested lists flattened.
  void value(UsdReadValue& out, int depth) {
    if (depth > kDeepest) throw TextError{"fewer brackets", at_};
    const char c = next();
    if (c == '(' || c == '[') {
      ++at_;
      const char close = c == '(' ? ')' : ']';
      while (next() != close) {
        value(out, depth + 1);
        skip(',');
      }
      ++at_;
    } else if (c == '"') {
      out.texts.push_back(text());
    } else if (c == '@') {
      out.texts.push_back(between('@', '@'));
    } else if (std::isalpha(static_cast<unsigned char>(c))) {
      const std::string name = word();
      if (name != "true" && name != "false") throw TextError{"true or false", at_};
      out.numbers.push_back(name == "true" ? 1 : 0);
    } else {
      out.numbers.push_back(number());
    }
  }

  UsdReadValue value() {
    UsdReadValue out;
    value(out, 0);
    return out;
  }

  std::string type() {
    std::string name = word();
    if (skip('[')) expect(']');
    is_single_ = is_single(name);
    return name;
  }

  UsdReadDictionary dictionary() {
    UsdReadDictionary entries;
    expect('{');
    while (!skip('}')) {
      type();
      const std::string name = word();
      expect('=');
      entries[name] = value();
    }
    is_single_ = false;
    return entries;
  }

  std::vector<std::string> paths() {
    if (next() == '<') return {between('<', '>')};
    std::vector<std::string> all;
    expect('[');
    while (!skip(']')) {
      all.push_back(between('<', '>'));
      skip(',');
    }
    return all;
  }

  static std::string first_text(const UsdReadValue& value) { return value.texts.empty() ? "" : value.texts.front(); }

  // Metadata in parentheses, of a layer or a prim.
  void metadata(UsdReadPrim& prim, int depth) {
    expect('(');
    while (!skip(')')) {
      std::string name = word();
      if (name == "prepend") name = word();
      expect('=');
      if (name == "customData" || name == "customLayerData") {
        prim.custom_data = dictionary();
      } else if (name == "variants") {
        for (const auto& [set, choice] : dictionary()) prim.selections[set] = first_text(choice);
      } else {
        UsdReadValue found;
        value(found, depth);
        if (name == "payload") prim.payloads = found.texts;
        if (name == "defaultPrim") layer_.default_prim = first_text(found);
        if (name == "upAxis") layer_.up_axis = first_text(found);
        if (name == "metersPerUnit" && !found.numbers.empty()) layer_.meters_per_unit = found.numbers.front();
      }
    }
  }

  void relationship(UsdReadPrim& prim) {
    const std::string name = word();
    expect('=');
    prim.targets[name] = paths();
  }

  void interpolation(const std::string& name, UsdReadPrim& prim) {
    expect('(');
    while (!skip(')')) {
      const std::string key = word();
      expect('=');
      const std::string text = first_text(value());
      if (key == "interpolation") prim.interpolations[name] = text;
    }
  }

  // Reads the rest of an attribute after its qualifiers and type.
  void attribute(UsdReadPrim& prim) {
    std::string name = word();
    constexpr std::string_view kConnect = ".connect";
    const bool is_connection = name.ends_with(kConnect);
    if (is_connection) {
      name.resize(name.size() - kConnect.size());
      expect('=');
      prim.targets[name] = paths();
      return;
    }
    if (skip('=')) prim.values[name] = value();
    if (next() == '(') interpolation(name, prim);
  }

  void variant_set(UsdReadPrim& prim, int depth) {
    const std::string set = text();
    expect('='), expect('{');
    while (!skip('}')) {
      UsdReadPrim variant;
      variant.path = text();
      if (next() == '(') metadata(variant, depth);
      expect('{');
      while (!skip('}')) property(word(), variant, depth);
      prim.variants[set].push_back(std::move(variant));
    }
  }

  void property(std::string first, UsdReadPrim& prim, int depth) {
    while (first == "custom" || first == "uniform") first = word();
    if (first == "variantSet") return variant_set(prim, depth);
    if (first == "rel") return relationship(prim);
    if (skip('[')) expect(']');
    is_single_ = is_single(first);
    attribute(prim);
    is_single_ = false;
  }

  // Reads a prim after "def".
  void prim(const std::string& parent, int depth) {
    if (depth > kDeepest) throw TextError{"fewer prims inside each other", at_};
    UsdReadPrim read;
    read.type = word();
    read.path = parent + "/" + text();
    if (next() == '(') metadata(read, depth);
    const std::size_t number = layer_.prims.size();
    const std::string path = read.path;
    layer_.prims.push_back(std::move(read));
    expect('{');
    while (!skip('}')) {
      const std::string first = word();
      if (first == "def") {
        prim(path, depth + 1);
        continue;
      }
      UsdReadPrim& own = layer_.prims[number];
      property(first, own, depth);
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  bool is_single_ = false;  ///< True if numbers have single precision or less.
  UsdReadLayer layer_;
};

}  // namespace

Result<UsdReadLayer> read_usd_text(std::string_view text) {
  try {
    return TextReader(text).layer();
  } catch (const TextError& problem) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(problem.at), '\n');
    return Error{"",
                 "line " + std::to_string(line) + ": is no layer that citykiln wrote; expected " + problem.expected};
  }
}

}  // namespace citykiln::exporters
