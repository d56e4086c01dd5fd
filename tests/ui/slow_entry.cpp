#include "tests/ui/slow_entry.hpp"

#include "tests/ui/entry_fields.hpp"

#include <doctest/doctest.h>

#include <string>

namespace forefront::test {

void expectSame(const char *what, const Entry &entry, const Outcome &outcome) {
    const std::string name(what);
    CAPTURE(name);
    Typist fast(false), slow(true);
    entry(fast);
    entry(slow);
    const std::string wanted = fast.drawing();
    CHECK(slow.drawing() == wanted);
    CHECK(slow.context().tools.current().id() == std::string(fast.context().tools.current().id()));
    CHECK(slow.context().dialogs.any() == fast.context().dialogs.any());
    if (outcome) {
        CHECK(outcome(slow) == outcome(fast));
    }
    for (const EntryField &listed : kEntryFields) {
        if (listed.typedIn == name && *listed.field != '\0') {
            const std::string field(listed.field);
            CAPTURE(field);
            CHECK(fast.fields().contains(field));
            CHECK(slow.fields().contains(field));
        }
    }
}

} // namespace forefront::test
