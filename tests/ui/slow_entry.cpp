#include "tests/ui/slow_entry.hpp"

#include "ui/widgets/parse_number.hpp"

#include <doctest/doctest.h>

#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

/// Returns the fields of each case that entry_fields.txt lists.
std::map<std::string, std::vector<std::string>> readEntryFields() {
    std::ifstream list(std::string(FOREFRONT_SOURCE_DIR) + "/tests/ui/entry_fields.txt");
    std::map<std::string, std::vector<std::string>> fields;
    for (std::string line; std::getline(list, line);) {
        std::istringstream row(line);
        std::array<std::string, 4> columns; // the source, the call, the field and the case
        for (std::string &column : columns) {
            std::string padded;
            std::getline(row, padded, '|');
            column = trimmed(padded);
        }
        if (!line.starts_with('#') && !columns[2].empty()) {
            fields[columns[3]].push_back(columns[2]);
        }
    }
    return fields;
}

} // namespace

void expectSame(const char *what, const Entry &entry, const Outcome &outcome) {
    static const std::map<std::string, std::vector<std::string>> kEntryFields = readEntryFields();
    REQUIRE_FALSE(kEntryFields.empty());
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
    if (const auto listed = kEntryFields.find(name); listed != kEntryFields.end()) {
        for (const std::string &field : listed->second) {
            CAPTURE(field);
            CHECK(fast.fields().contains(field));
            CHECK(slow.fields().contains(field));
        }
    }
}

} // namespace forefront::test
