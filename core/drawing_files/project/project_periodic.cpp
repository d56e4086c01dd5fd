#include "core/drawing_files/project/project_periodic.hpp"

#include <cstdint>
#include <set>
#include <string>

namespace forefront {

void writePeriodic(const Document &document, JsonText &out) {
    if (document.periodic.empty()) {
        return;
    }
    out << ",\n  \"periodic\": [";
    out.list(document.periodic, ", ",
             [&](const PeriodicSpec &spec) { out << "{\"from\": " << spec.from << ", \"to\": " << spec.to << '}'; });
    out << ']';
}

namespace {

/// `seen`: tags of the pairs read so far.
void readPeriodicPair(const JsonValue &item, std::set<std::int32_t> &seen, Document &document, JsonCheck &check) {
    if (!check.expect(item, JsonKind::Object, "a pair of periodic parts")) {
        return;
    }
    const std::size_t before = check.faults().size();
    PeriodicSpec spec;
    if (const auto value = check.member(item, "from", "periodic parts")) {
        spec.from = check.tag(*value);
    }
    if (const auto value = check.member(item, "to", "periodic parts")) {
        spec.to = check.tag(*value);
    }
    check.noteUnknown(item, {"from", "to"});
    if (check.faults().size() != before) {
        return;
    }
    for (const std::int32_t tag : {spec.from, spec.to}) {
        if (!seen.insert(tag).second) {
            check.fault(item, "bad-tag", "tag " + std::to_string(tag) + " is periodic twice; expected each tag once");
            return;
        }
    }
    document.periodic.push_back(spec);
}

} // namespace

void readPeriodic(const JsonValue &root, Document &document, JsonCheck &check) {
    const auto list = root.find("periodic");
    if (!list || !check.expect(*list, JsonKind::Array, "\"periodic\"")) {
        return;
    }
    std::set<std::int32_t> seen;
    for (const JsonValue item : *list) {
        if (check.full()) {
            return;
        }
        readPeriodicPair(item, seen, document, check);
    }
}

} // namespace forefront
