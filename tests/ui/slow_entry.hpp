#pragma once

#include "tests/ui/typist.hpp"

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace forefront::test {

using Entry = std::function<void(Typist &)>;
/// Returns what the entry leaves beside the drawing.
using Outcome = std::function<std::string(Typist &)>;

/// Types the same with fast and with slow frames, and expects the same drawing, tool and outcome. Each field that
/// entry_fields.txt lists for `what` must have been typed into.
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

/// Types over the texts of several fields: a field and its text each.
inline void typeOver(Typist &typist, std::initializer_list<std::pair<std::string_view, std::string_view>> texts) {
    for (const auto &[field, text] : texts) {
        typeOver(typist, field, text);
    }
}

/// Opens a field and replaces its text, ending with Enter.
inline void replaceText(Typist &typist, std::string_view field, std::string_view text) {
    typist.touch(field);
    typist.tap('A', kControl);
    enter(typist, text);
}

/// Selects parts of the drawing without the pointer.
inline void selectParts(Typist &typist, Selection selection) {
    typist.context().selection = std::move(selection);
    typist.context().animate();
    typist.settle();
}

/// A rectangle of 6 by 5, drawn with typed numbers.
inline void typedRectangle(Typist &typist) {
    typist.write("r");
    tabbed(typist, "1");
    enter(typist, "2");
    tabbed(typist, "6");
    enter(typist, "5");
}

/// The typed rectangle, selected.
inline void selectedRectangle(Typist &typist) {
    typedRectangle(typist);
    typist.write("v");
    typist.finish();
}

/// The typed rectangle, selected and meshed.
inline void meshedRectangle(Typist &typist) {
    selectedRectangle(typist);
    typist.context().run.mesh();
    typist.settle();
}

} // namespace forefront::test
