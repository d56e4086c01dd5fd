#include "core/teaching/lesson/glossary.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

TEST_CASE("Glossary: every term has a unique id, a text, a figure and existing related terms") {
    std::set<std::string_view> ids;
    for (const GlossaryTerm &term : glossary()) {
        CAPTURE(term.name);
        CHECK(ids.insert(term.id).second);
        CHECK(glossaryTerm(term.id) == &term);
        CHECK(term.text.size() > 60);
        CHECK(term.text.back() == '.');
        CHECK_FALSE(term.phrases.empty());
        CHECK_FALSE(term.related.empty());
        for (const std::string_view id : term.related) {
            CHECK(id != term.id);
            CHECK(glossaryTerm(id) != nullptr);
        }
        const Figure figure = term.figure();
        CHECK(figure.lines.size() + figure.elements.size() > 3);
        const Vec2 size = figure.bounds().size();
        CHECK(std::isfinite(size.x));
        CHECK(size.x > size.y); // fits the wide space of the dialog
        for (const auto &[a, b, c] : figure.elements) {
            CHECK(cross(b - a, c - a) > 0.0);
        }
    }
    CHECK(ids.size() >= 16);
    CHECK(glossaryTerm("unknown") == nullptr);
}

TEST_CASE("Glossary: a text links to the terms that it mentions") {
    const auto idsIn = [](std::string_view text) {
        std::vector<std::string> ids;
        for (const GlossaryTerm *term : termsIn(text)) {
            ids.emplace_back(term->id);
        }
        return ids;
    };
    CHECK(idsIn("The Front moves inward.") == std::vector<std::string>{"front"});
    CHECK(idsIn("Compare Nc with the grid off.") == std::vector<std::string>{"grid", "counters"});
    CHECK(idsIn("In advance, once upon a time").empty()); // nc, nb and ns within words do not count
    CHECK(idsIn("").empty());
}

} // namespace forefront
