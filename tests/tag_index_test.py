#!/usr/bin/env python3
"""compiler/map/tags.md lists the keys of tags that the code reads, each with the files that read it."""
import sys
import unittest

import tag_index


class TagIndex(unittest.TestCase):
    def test_the_page_is_up_to_date(self):
        self.assertEqual(tag_index.PAGE.read_text(encoding="utf-8"), tag_index.page(),
                         "run tests/tag_index.py --update and look at what changes")

    def test_known_keys_are_found_in_their_folders(self):
        readers = {key: {str(path.parent) for path in paths} for key, paths in tag_index.index().items()}
        for folder, keys in {"compiler/map/readers": ["natural", "surface", "shop", "genus"], "compiler/map/tags": ["building", "layer"],
                             "compiler/map/buildings": ["height", "roof:shape"],
                             "compiler/map/lanes": ["lanes", "lanes:bus:<direction>", "turn:lanes:<direction>", "cycleway:<side>:buffer"],
                             "compiler/source/areas": ["type"], "compiler/regions": ["building"]}.items():
            for key in keys:
                self.assertIn(folder, readers.get(key, set()), key)

    def test_values_and_other_words_are_no_keys(self):
        keys = set(tag_index.index())
        self.assertEqual(keys & {"yes", "no", "water", "underground", "zebra", "coastline", "building_passage", "track", "area", "footprint",
                                 "inner", "left", "lane", "tree", "hedge", "residential", "encoding", "pbf"},
                         {"water", "area"})  # both are keys too

    def test_every_lookup_is_read(self):
        self.assertEqual(list(tag_index.unexplained_lookups()), [])

    def test_each_rule_finds_a_key(self):
        text = tag_index.without_comments("""
            #define AREA(key, value) {key, value},
            AREA("natural", "water")  // AREA("not", "this")
            struct PointRow { std::string_view key, value; };
            constexpr PointRow kShop{"shop", ""};
            double width(Range tags, std::string_view key, double least);
            double w = width(tags, "width", 1) + tags.count("lanes:bus" + suffix, 0);
            bool b = tags("bus") == "yes" || tags.beside(flow, "cycleway", ":oneway") == "no" || data.strings[tag.key] != "type";
            for (const std::string_view key : {"height", "est_height"}) f(key);
            constexpr std::array<std::string_view, 2> kLandKeys = {"landuse", "golf"};
            for (const std::string_view key : kLandKeys) f(key);
            int count(const std::string& key, double least), beside(Flow flow, std::string_view key, std::string_view suffix);""")
        self.assertEqual(tag_index.keys_in(text, tag_index.parameters_named_key([text])),
                         {"natural", "shop", "width", "lanes:bus:<direction>", "bus", "cycleway:<side>:oneway", "type", "height", "est_height",
                          "landuse", "golf"})


if __name__ == "__main__":
    sys.exit(unittest.main())
