#pragma once

#include "tests/ui/typist.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace forefront::test {

using Entry = std::function<void(Typist &)>;
/// Returns what the entry leaves beside the drawing.
using Outcome = std::function<std::string(Typist &)>;

/// Types the same with fast and with slow frames, and expects the same drawing, tool and outcome. Each field that
/// entry_fields.hpp lists for `what` must have been typed into.
void expectSame(const char *what, const Entry &entry, const Outcome &outcome = {});

inline void enter(Typist &typist, std::string_view text) {
    typist.write(text);
    typist.tap(key::kEnter);
}

inline void tabbed(Typist &typist, std::string_view text) {
    typist.write(text);
    typist.tap(key::kTab);
}

/// Clicks a field and types over its text, without a pause.
inline void typeOver(Typist &typist, std::string_view field, std::string_view text) {
    typist.touch(field);
    typist.tap('A', kControl);
    tabbed(typist, text);
}

/// A rectangle of 6 by 5, drawn with typed numbers.
inline void typedRectangle(Typist &typist) {
    typist.write("r");
    tabbed(typist, "1");
    enter(typist, "2");
    tabbed(typist, "6");
    enter(typist, "5");
}

} // namespace forefront::test
