#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/contract/texts/nearest_name.h"
#include "compiler/contract/texts/parse.h"
#include "compiler/contract/texts/utf8.h"
#include "compiler/invent/tiles/tile_set.h"

namespace citykiln::invent {
namespace {

using Words = std::vector<std::string_view>;

constexpr double kLeastCell_m = 8, kMostCell_m = 256, kMostWeight = 1e6;
constexpr std::size_t kMostContent = 256, kMostText = 1U << 20;

Words words_of(std::string_view line) {
  Words words;
  line = line.substr(0, line.find('#'));
  while (true) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

class TileSetReader {
 public:
  TileSetReader(std::string_view text, const std::string& where) : text_(text), where_(where) {}

  Result<TileSet> read() {
    if (text_.size() > kMostText) return Error{where_, "expected a tile set of at most 1 MB"};
    if (!is_utf8(text_)) return Error{where_, "expected text in UTF-8"};
    for (const std::string_view line : split(text_, '\n')) {
      ++line_;
      const Words words = words_of(line);
      if (words.empty()) continue;
      if (const Result<Done> done = read_line(words); !done) return done.error();
    }
    if (set_.tiles.empty()) return Error{where_, "expected at least one tile, such as: tile grass"};
    if (const Result<Done> done = finish_tile(); !done) return done.error();
    return std::move(set_);
  }

 private:
  Error here(std::string message) const { return {fmt::format("{}:{}", where_, line_), std::move(message)}; }
  Error expected(std::string_view what, std::string_view found) const {
    return here(fmt::format("expected {}, found \"{}\"", what, found));
  }

  Result<Done> read_line(const Words& words) {
    const std::string_view word = words.front();
    if (word == "cell") return read_cell(words);
    if (word == "roads") return read_roads(words);
    if (word == "tile") return begin_tile(words);
    static const std::vector<std::string> kKnown = {"cell",  "roads", "tile", "sides", "weight", "turns",
                                                    "noise", "line",  "area", "point", "cover"};
    if (std::ranges::find(kKnown, word) == kKnown.end())
      return here(fmt::format("unknown word \"{}\"{}", word, did_you_mean(word, kKnown)));
    if (set_.tiles.empty()) return here(fmt::format("expected \"tile NAME\" before \"{}\"", word));
    if (word == "sides") return read_sides(words);
    if (word == "weight" || word == "turns" || word == "noise") return read_numbers(words);
    return read_content(words);
  }

  Result<Done> read_cell(const Words& words) {
    const auto side_m = words.size() == 2 ? number_in<double>(words[1]) : std::nullopt;
    if (!side_m || *side_m < kLeastCell_m || *side_m > kMostCell_m)
      return expected("cell M, with 8 to 256 metres", words.back());
    set_.cell_m = *side_m;
    return Done{};
  }

  Result<std::uint8_t> label_of(std::string_view word) {
    auto found = std::ranges::find(set_.labels, word);
    if (found == set_.labels.end()) {
      if (set_.labels.size() == kMostLabels) return here("expected at most 16 different labels of sides");
      found = set_.labels.insert(set_.labels.end(), std::string(word));
    }
    return static_cast<std::uint8_t>(found - set_.labels.begin());
  }

  Result<Done> read_roads(const Words& words) {
    if (words.size() < 2) return here("expected labels of sides after \"roads\"");
    for (std::size_t i = 1; i < words.size(); ++i) {
      const Result<std::uint8_t> label = label_of(words[i]);
      if (!label) return label.error();
      set_.roads.push_back(*label);
    }
    return Done{};
  }

  Result<Done> begin_tile(const Words& words) {
    if (words.size() != 2) return here("expected one name after \"tile\"");
    if (!set_.tiles.empty())
      if (const Result<Done> done = finish_tile(); !done) return done.error();
    if (std::ranges::any_of(set_.tiles, [&](const Tile& tile) { return tile.name == words[1]; }))
      return here(fmt::format("there are two tiles \"{}\"", words[1]));
    set_.tiles.push_back({});
    set_.tiles.back().name = words[1];
    has_sides_ = false;
    return Done{};
  }

  Result<Done> read_sides(const Words& words) {
    if (words.size() != 5) return here("expected the labels of four sides after \"sides\": north, west, south, east");
    for (int side = 0; side < kSides; ++side) {
      const Result<std::uint8_t> label = label_of(words[side + 1]);
      if (!label) return label.error();
      set_.tiles.back().sides[side] = *label;
    }
    has_sides_ = true;
    return Done{};
  }

  Result<Done> read_numbers(const Words& words) {
    std::vector<double> numbers;
    for (std::size_t i = 1; i < words.size(); ++i) {
      const auto number = number_in<double>(words[i]);
      if (!number) return expected("a number", words[i]);
      numbers.push_back(*number);
    }
    Tile& tile = set_.tiles.back();
    if (words[0] == "weight") {
      if (numbers.size() != 1 || numbers[0] <= 0 || numbers[0] > kMostWeight)
        return here("expected a number above 0 and up to 1000000 after \"weight\"");
      tile.weight = numbers[0];
    } else if (words[0] == "turns") {
      if (numbers.size() != 1 || (numbers[0] != 1 && numbers[0] != 2 && numbers[0] != 4))
        return here("expected 1, 2 or 4 after \"turns\"");
      tile.turns = static_cast<int>(numbers[0]);
    } else {
      if (numbers.size() != 2 || !(numbers[0] < numbers[1]))
        return here("expected two rising numbers after \"noise\", such as -0.2 1");
      tile.low_noise = numbers[0], tile.high_noise = numbers[1];
    }
    return Done{};
  }

  Result<Done> read_content(const Words& words) {
    struct Form {
      std::string_view word;
      ContentKind kind;
      std::size_t least, most;
    };
    constexpr std::size_t kMany = 64;
    constexpr Form kForms[] = {{"line", ContentKind::kLine, 2, kMany},
                               {"area", ContentKind::kArea, 3, kMany},
                               {"point", ContentKind::kPoint, 1, 1},
                               {"cover", ContentKind::kCover, 0, 0}};
    const Form& form = *std::ranges::find(kForms, words.front(), &Form::word);
    if (words.size() < 2) return here(fmt::format("expected tags after \"{}\", such as landuse=grass", form.word));
    if (words.size() - 2 < form.least || words.size() - 2 > form.most)
      return here(fmt::format(
          "expected {} places x,y after the tags, found {}",
          form.least == form.most ? fmt::format("{}", form.least) : fmt::format("{} to {}", form.least, form.most),
          words.size() - 2));
    if (set_.tiles.back().content.size() == kMostContent) return here("expected at most 256 objects in a tile");
    TileContent content{.kind = form.kind, .tags = {}, .points = {}};
    if (const Result<Done> done = read_tags(words[1], content); !done) return done;
    for (std::size_t i = 2; i < words.size(); ++i) {
      const auto xy = numbers_in<double>(words[i], ',', 2);
      if (!xy || !is_inside((*xy)[0]) || !is_inside((*xy)[1])) return expected("x,y from 0 to 1", words[i]);
      content.points.push_back({(*xy)[0], (*xy)[1]});
    }
    if (form.kind == ContentKind::kArea) {
      const double area = signed_area_m2(content.points);
      if (std::abs(area) < 1e-6) return here("the area has no size");
      if (area < 0) std::ranges::reverse(content.points);
    }
    set_.tiles.back().content.push_back(std::move(content));
    return Done{};
  }

  static bool is_inside(double v) { return v >= 0 && v <= 1; }

  Result<Done> read_tags(std::string_view text, TileContent& content) {
    for (const std::string_view part : split(text, ',')) {
      const std::size_t equals = part.find('=');
      if (equals == 0 || equals == std::string_view::npos || equals + 1 == part.size())
        return expected("key=value or key=value|value", part);
      TagChoice tag{std::string(part.substr(0, equals)), {}};
      for (const std::string_view value : split(part.substr(equals + 1), '|')) {
        if (value.empty()) return expected("key=value or key=value|value", part);
        tag.values.emplace_back(value);
      }
      // spaces end a word, so that _ stands for them in names
      content.tags.push_back(std::move(tag));
    }
    std::ranges::sort(content.tags, {}, &TagChoice::key);
    const auto twice = std::ranges::adjacent_find(content.tags, {}, &TagChoice::key);
    if (twice != content.tags.end()) return here(fmt::format("the key \"{}\" stands twice", twice->key));
    return Done{};
  }

  /// Adds the turns of the tile that ends here.
  Result<Done> finish_tile() {
    const Tile& tile = set_.tiles.back();
    if (!has_sides_) return here(fmt::format("tile \"{}\" has no line \"sides\"", tile.name));
    for (int turn = 0; turn < tile.turns; ++turn) {
      TurnedTile turned{static_cast<std::uint16_t>(set_.tiles.size() - 1), static_cast<std::uint8_t>(turn), {}};
      // a quarter turn counter-clockwise brings the northern side to the west
      for (int side = 0; side < kSides; ++side) turned.sides[(side + turn) % kSides] = tile.sides[side];
      set_.turned.push_back(turned);
    }
    if (set_.turned.size() > kMostTurned) return here("expected at most 128 tiles, turned ones counted");
    return Done{};
  }

  std::string_view text_;
  const std::string& where_;
  int line_ = 0;
  bool has_sides_ = false;
  TileSet set_;
};

}  // namespace

Result<TileSet> read_tile_set(std::string_view text, const std::string& where) {
  return TileSetReader(text, where).read();
}

}  // namespace citykiln::invent
